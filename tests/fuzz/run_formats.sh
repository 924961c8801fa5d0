#!/usr/bin/env bash
# Gives each reader of files RUNS inputs of each format of the programs' table. Findings are in build/fuzz*/found.
# usage: tests/fuzz/run_formats.sh RUNS [sanitize]      without sanitizers millions of inputs take minutes
set -euo pipefail
MOST_ARGUMENTS=2
. "$(dirname "$0")/../refuse_options.sh"
cd "$(dirname "$0")/../.."
runs=${1:?how many inputs of each format}
. tests/build_environment.sh
folder=build/fuzz
flags=()
if [ "${2-}" != sanitize ]; then
  folder=build/fuzz_formats
  # Comparisons are not traced, which takes more time than reading.
  flags=("-DCMAKE_CXX_FLAGS=-fsanitize-coverage=inline-8bit-counters,pc-table" -DRBPA_COMPILE_TOGETHER=ON)
fi
cmake --preset fuzz -B "$folder" "${flags[@]}" > /dev/null
cmake --build "$folder" --parallel "$(nproc)" --target fuzz_points fuzz_space_points fuzz_meshes
mkdir -p "$folder/found"
for target in points space_points meshes; do
  for format in $(RBPA_FUZZ_FORMAT=list "$folder/bin/fuzz_$target"); do echo "$target $format"; done
done > "$folder/formats.txt"
export folder runs
# An input of 400 bytes, of LAZ and COPC 2000, that takes ten seconds or 512 MiB is a finding. Prints a line for each format.
xargs -P "$(nproc)" -n 2 bash -c '
  name=$0-$1
  status=0
  dictionary=tests/fuzz/dictionaries/$0.dict
  mkdir -p "$folder/corpus/$name"
  RBPA_FUZZ_FORMAT=$1 "$folder/bin/fuzz_$0" -runs="$runs" -max_len=$([ "$1" = laz ] && echo 2000 || echo 400) -timeout=10 -rss_limit_mb=2048 \
    -malloc_limit_mb=512 -entropic=0 -print_final_stats=1 -artifact_prefix="$folder/found/$name-" \
    $([ -f "$dictionary" ] && echo "-dict=$dictionary") \
    "$folder/corpus/$name" "tests/fuzz/corpus/$0" > "$folder/found/$name.log" 2>&1 || status=$?
  echo "$name: $(sed -n "s/stat::number_of_executed_units: *//p" "$folder/found/$name.log") inputs, exit $status"
  exit "$status"' < "$folder/formats.txt"
