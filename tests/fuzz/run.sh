#!/usr/bin/env bash
# Builds the fuzz targets and lets libFuzzer search for bytes that break them. Findings are in build/fuzz/found.
# usage: tests/fuzz/run.sh [SECONDS [TARGET...]]      600 seconds for every target
set -euo pipefail
. "$(dirname "$0")/../refuse_options.sh"
cd "$(dirname "$0")/../.."
seconds=${1:-600}
bash tests/install_packages.sh cmake make clang-14 libclang-rt-14-dev libopenmesh-dev libboost-graph-dev libhwy-dev \
  libtbb-dev libeigen3-dev libnanoflann-dev libcli11-dev libpng-dev zlib1g-dev liblzf-dev nlohmann-json3-dev
cmake --preset fuzz > /dev/null
cmake --build --preset fuzz --parallel "$(nproc)"
targets=("${@:2}")
[ ${#targets[@]} -gt 0 ] || targets=($(ls tests/fuzz/corpus))
for target in "${targets[@]}"; do
  mkdir -p "build/fuzz/corpus/$target" "build/fuzz/found"
  dictionary=tests/fuzz/dictionaries/$target.dict
  # New inputs are written into the first folder; the committed corpus is only read. An input of a kilobyte that takes
  # ten seconds or 512 MiB is a finding.
  "build/fuzz/bin/fuzz_$target" -max_total_time="$seconds" -max_len=1024 -timeout=10 -rss_limit_mb=2048 \
    -malloc_limit_mb=512 -print_final_stats=1 -artifact_prefix="build/fuzz/found/$target-" \
    $([ -f "$dictionary" ] && echo "-dict=$dictionary") "build/fuzz/corpus/$target" "tests/fuzz/corpus/$target"
done
