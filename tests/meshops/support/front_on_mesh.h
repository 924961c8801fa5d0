// A front on a mesh of its own.
#pragma once

#include <cstddef>

#include "meshops/front/front.h"
#include "support/meshes.h"

namespace meshops::test {

/// An empty mesh, and a front of so many sites on it.
struct FrontOnMesh {
  TestMesh mesh;
  Front front;

  explicit FrontOnMesh(std::size_t sites) : front(mesh, sites) {}
};

}  // namespace meshops::test
