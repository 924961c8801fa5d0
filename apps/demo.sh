#!/usr/bin/env bash
# Installs what is missing, builds the programs in release mode and triangulates a bundled real point set.
# Leaves a mesh and a picture in rbpa-demo/ and says so.
set -euo pipefail
cd "$(dirname "$0")/.."
bash tests/install_packages.sh g++ cmake make libopenmesh-dev libboost-graph-dev libhwy-dev libtbb-dev libcli11-dev libpng-dev \
  zlib1g-dev nlohmann-json3-dev
cmake --preset programs
cmake --build --preset programs --parallel "$(nproc)"
mkdir -p rbpa-demo
build/release/bin/rbpa mesh tests/data/mol_2xhe_xy.xy --alpha 1 -o rbpa-demo/molecule.ply -o rbpa-demo/molecule.png
echo "mesh:    $PWD/rbpa-demo/molecule.ply"
echo "picture: $PWD/rbpa-demo/molecule.png"
