#!/usr/bin/env bash
# Installs what is missing, builds the program `rbpa` in release mode and triangulates a bundled real point set.
# Writes a mesh, a picture and a page to look at into rbpa-demo/, and prints their names.
set -euo pipefail
cd "$(dirname "$0")/.."
if [ $# -gt 0 ]; then
  case $1 in
    -h | --help)
      echo "usage: apps/demo.sh"
      echo "Installs what is missing (Debian's packages, as root or by sudo), builds rbpa into build/release/bin, and"
      echo "makes a mesh, a picture and a page to look at of a bundled set of points, in rbpa-demo/."
      exit 0
      ;;
  esac
  echo "demo.sh: found '$1', expected no arguments (see apps/demo.sh --help)" >&2
  exit 2
fi
bash tests/install_packages.sh g++ cmake ninja-build ccache libopenmesh-dev libboost-graph-dev libhwy-dev libtbb-dev libcli11-dev libpng-dev \
  libeigen3-dev libnanoflann-dev zlib1g-dev liblzf-dev nlohmann-json3-dev
# tests/run.sh uses the same folder, flags and cache, so that nothing is compiled twice.
. tests/build_environment.sh
cmake --preset programs
cmake --build --preset programs --parallel "$(nproc)" --target rbpa_cli
mkdir -p rbpa-demo
build/release/bin/rbpa mesh tests/data/mol_2xhe_xy.xy --alpha 1 -o rbpa-demo/molecule.ply -o rbpa-demo/molecule.png
build/release/bin/rbpa report tests/data/mol_2xhe_xy.xy -o rbpa-demo/molecule.html
echo "mesh:    $PWD/rbpa-demo/molecule.ply"
echo "picture: $PWD/rbpa-demo/molecule.png"
echo "page:    $PWD/rbpa-demo/molecule.html"
