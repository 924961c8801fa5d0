#!/usr/bin/env bash
# Installs what is missing, builds everything in release mode and runs the tests.
# usage: tests/run.sh [PRESET]      release (default), debug, sanitize, threads, clang, shared, gdal, nightly
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
packages=(g++ cmake make ccache libopenmesh-dev libboost-graph-dev libhwy-dev libtbb-dev libnanoflann-dev doctest-dev libcli11-dev libpng-dev
          zlib1g-dev nlohmann-json3-dev libcgal-dev libeigen3-dev libgeos-dev libgudhi-dev pkgconf clang-format-14
          clang-tidy-14 pybind11-dev python3-dev python3-numpy python3-pytest mypy python3-scipy python3-shapely
          python3-gudhi python3-matplotlib python3-meshio python3-pandas python3-dask python3-distributed)
[ "$preset" = clang ] && packages+=(clang-14)
[ "$preset" = nightly ] && packages+=(nodejs chromium)
[ "$preset" = gdal ] || [ "$preset" = nightly ] && packages+=(libgdal-dev)
bash tests/install_packages.sh "${packages[@]}"
# The libraries are compiled for their own tests and again as parts of users' projects (tests/consumer).
export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache} CCACHE_DEPEND=1
export CCACHE_DIR=${CCACHE_DIR-$PWD/build/ccache}
build() {
  local python=()
  # All that it needs is installed by now. Said here, as a build folder of before may have it cached as OFF.
  case $1 in release | clang | shared | gdal) python=(-DRBPA_BUILD_PYTHON=ON) ;; esac
  cmake --preset "$1" "${python[@]}"
  cmake --build --preset "$1" --parallel "$(nproc)" "${@:2}"
}
if [ "$preset" = nightly ]; then
  build release
  ctest --preset nightly
  build sanitize --target test_meshops
  ctest --preset nightly-sanitize  # the long random walks
  build gdal --target test_ogr
  ctest --preset gdal
elif [ "$preset" = gdal ]; then
  build gdal --target test_ogr
  ctest --preset gdal
else
  build "$preset"
  ctest --preset "$preset" --parallel "$(nproc)"
fi
