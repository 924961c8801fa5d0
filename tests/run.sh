#!/usr/bin/env bash
# Installs what is missing, builds everything in release mode and runs the tests. The last lines name the suites that
# failed, and count those that ran; with `release` it is a failure if one is left out.
# usage: tests/run.sh [PRESET]      release (default), debug, sanitize, threads, clang, shared, gdal, javascript, site, nightly;
#                                   quick: the libraries' suites with sanitizers, and with clang;
#                                   further: what reads the larger collection in $RBPA_DATA_DIR
set -euo pipefail
MOST_ARGUMENTS=1
. "$(dirname "$0")/refuse_options.sh"
if [ "${1-}" = further ] && [ ! -d "${RBPA_DATA_DIR-}" ]; then
  echo "run.sh: further: RBPA_DATA_DIR is '${RBPA_DATA_DIR-}', expected a folder (tests/data/README.md)" >&2
  exit 2
fi
cd "$(dirname "$0")/.."
preset=${1:-release}
packages=(g++ cmake make ninja-build ccache libopenmesh-dev libboost-graph-dev libhwy-dev libtbb-dev libnanoflann-dev doctest-dev libcli11-dev libpng-dev
          zlib1g-dev liblzf-dev nlohmann-json3-dev libcgal-dev libeigen3-dev libgeos-dev libgudhi-dev pkgconf clang-format-14
          clang-tidy-14 pybind11-dev python3-dev python3-numpy python3-pytest mypy python3-scipy python3-shapely
          python3-gudhi python3-matplotlib python3-meshio python3-pandas python3-dask python3-distributed nodejs)
[ "$preset" = clang ] || [ "$preset" = quick ] && packages+=(clang-14)
[ "$preset" = nightly ] && packages+=(chromium patchelf)
[ "$preset" = javascript ] || [ "$preset" = site ] && packages+=(emscripten chromium)
# A Node.js from another source contains npm, and conflicts with Debian's npm.
[ "$preset" = javascript ] && ! command -v npm >/dev/null && packages+=(npm)
[ "$preset" = site ] && packages+=(python3-sphinx python3-myst-parser python3-sphinx-rtd-theme doxygen)
[ "$preset" = gdal ] || [ "$preset" = nightly ] && packages+=(libgdal-dev)
bash tests/install_packages.sh "${packages[@]}"
. tests/build_environment.sh
build() {
  cmake --preset "$1"
  cmake --build --preset "$1" --parallel "$(nproc)" "${@:2}"
}
# Runs suites, names those that failed, and prints a last line with the number of all and of those that are left out
# because something is missing.
test_preset() {
  local status=0 folder=$PWD/build/$1 not_run=()
  ctest --preset "$2" --output-junit "$folder/suites.xml" "${@:3}" || status=$?
  local summary
  summary=$(grep -A9 '<testsuite ' "$folder/suites.xml")
  count() { grep -o "$1=\"[0-9]*\"" <<<"$summary" | head -n 1 | tr -dc 0-9; }
  local ran=$(($(count tests) - $(count skipped) - $(count disabled)))
  mapfile -t not_run < <(
    cat "$folder/left_out.txt"
    sed -n 's/.*<testcase name="\([^"]*\)".*status="\(notrun\|disabled\)".*/\1 (skipped)/p' "$folder/suites.xml"
  )
  local failed
  failed=$(sed -n 's/.*<testcase name="\([^"]*\)".*status="fail".*/\1/p' "$folder/suites.xml" | paste -sd ' ')
  [ -z "$failed" ] || echo "failed: $failed"
  if [ ${#not_run[@]} -eq 0 ]; then
    echo "$ran suites run, none left out"
  else
    printf -v not_run '%s, ' "${not_run[@]}"
    echo "$ran suites run, left out: ${not_run%, }"
    [ "$1" = release ] && [ "$status" -eq 0 ] && status=1
  fi
  return "$status"
}
if [ "$preset" = nightly ]; then
  build release --target all nightly_programs
  test_preset release nightly
  build sanitize --target test_meshops
  test_preset sanitize nightly-sanitize  # the long random walks
  build gdal --target test_ogr
  test_preset gdal gdal
elif [ "$preset" = further ]; then
  build release --target test_apps test_rbpa oracle_hierarchy oracle_data oracle_shape oracle_space
  test_preset release further --parallel "$(nproc)"
elif [ "$preset" = threads ]; then  # only the programs that its tests run
  build threads --target test_rbpa oracle_remainder fuzz_fronts example_{nearest,placing,filling,grid,ear}_front
  test_preset threads threads --parallel "$(nproc)"
elif [ "$preset" = javascript ]; then
  build javascript
  ctest --preset javascript
elif [ "$preset" = site ]; then
  build release --target rbpa_python_package
  build javascript
  bash docs/site/build.sh
  node --test tests/site
elif [ "$preset" = gdal ]; then
  build gdal --target test_ogr
  test_preset gdal gdal
elif [ "$preset" = quick ]; then
  for with in sanitize clang; do
    build "$with" --target test_meshops test_rbpa fuzz_operators fuzz_fronts rbpa_cli meshtopo
    test_preset "$with" "quick-$with" --parallel "$(nproc)"
  done
else
  build "$preset"
  test_preset "$preset" "$preset" --parallel "$(nproc)"
fi
