#!/usr/bin/env bash
# Installs the build dependencies of a wheel in an image of manylinux (AlmaLinux), which has no Debian packages: by dnf
# and from sources. Called by cibuildwheel.
# usage: packaging/wheels/install_dependencies.sh
set -euo pipefail
MOST_ARGUMENTS=0
. "$(dirname "$0")/../../tests/refuse_options.sh"
dnf install -y epel-release
dnf install -y boost-devel eigen3-devel tbb-devel libpng-devel zlib-devel patchelf ninja-build
sources=$(mktemp -d)
# NAME REPOSITORY TAG [CMAKE OPTION...]
install_from_source() {
  git clone --depth 1 --branch "$3" "$2" "$sources/$1"
  cmake -S "$sources/$1" -B "$sources/$1/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_POSITION_INDEPENDENT_CODE=ON \
    -DBUILD_SHARED_LIBS=OFF "${@:4}"
  cmake --build "$sources/$1/build"
  cmake --install "$sources/$1/build"
}
install_from_source highway https://github.com/google/highway 1.0.7 -DHWY_ENABLE_TESTS=OFF -DHWY_ENABLE_EXAMPLES=OFF
install_from_source openmesh https://gitlab.vci.rwth-aachen.de:9000/OpenMesh/OpenMesh OpenMesh-9.0 -DBUILD_APPS=OFF
install_from_source nanoflann https://github.com/jlblancoc/nanoflann v1.4.3 -DNANOFLANN_BUILD_EXAMPLES=OFF -DNANOFLANN_BUILD_TESTS=OFF
install_from_source json https://github.com/nlohmann/json v3.11.2 -DJSON_BuildTests=OFF
install_from_source pybind11 https://github.com/pybind/pybind11 v2.10.3 -DPYBIND11_TEST=OFF
curl -sSL http://dist.schmorp.de/liblzf/liblzf-3.6.tar.gz | tar -xz -C "$sources"
(cd "$sources/liblzf-3.6" && CFLAGS="-O2 -fPIC" ./configure && make install)
rm -rf "$sources"
