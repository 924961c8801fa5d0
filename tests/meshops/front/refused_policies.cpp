// This file does not compile: a policy or a visitor with a near miss is refused with a message that gives the expected
// form. A test compares the messages.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>
#include <optional>

#include "meshops/front/engine.h"

using meshops::Front;
using meshops::Halfedge;
using meshops::Site;

struct Plain {
  std::optional<std::array<Site, 3>> seed(const Front&) { return std::nullopt; }
  std::optional<Site> propose(const Front&, Halfedge) { return std::nullopt; }
};
struct KeyOfMutableFront : Plain {
  int key(Front&, Halfedge) { return 0; }
};
struct IntGlues : Plain {
  int glues(const Front&, Halfedge, Site) { return 1; }
};
struct RekeysWithoutKey : Plain {
  static constexpr bool rekeys_neighbors = true;
};
struct CurvesOverridden : meshops::FrontVisitor {
  void curve_split(const Front&, Halfedge, Halfedge) {}
};
struct Freezed : meshops::FrontVisitor {
  void freezed(const Front&, Halfedge) {}
};
struct IntProposed : Plain {
  int propose(const Front&, Halfedge) { return -1; }
};

int main() {
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  Front front(mesh, 3);
  KeyOfMutableFront key;
  meshops::advance(front, key);
  IntGlues glues;
  meshops::advance(front, glues);
  RekeysWithoutKey rekeys;
  meshops::advance(front, rekeys);
  Plain plain;
  meshops::advance(front, plain, CurvesOverridden());
  meshops::advance(front, plain, Freezed());
  IntProposed proposed;
  meshops::advance(front, proposed);
}
