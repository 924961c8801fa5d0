// What: changes a mesh before a repair: --weld, then --keep-largest and --drop-small, then --orient.
// Law:  no face is added, and no vertex gets a position that no vertex had. The order of vertices and faces affects
//       only their numbers, and the direction of an open component if exactly half of its faces have each direction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "meshtopo/weld.h"
#include "triangulation/choices.h"

namespace rbpa::app {

struct Edits {
  std::optional<double> weld = {};  ///< distance of --weld
  ComponentChoice components = {};
  bool orient = false;

  bool any() const { return weld || !components.keeps_all() || orient; }
};

struct Dropped {
  std::size_t components = 0;
  std::size_t faces = 0;     ///< number of dropped faces: faces of dropped components, degenerate and repeated faces
  std::size_t vertices = 0;  ///< number of dropped vertices, which are corners of no kept face
};

struct Oriented {
  std::size_t faces = 0;    ///< number of reversed faces
  std::size_t outward = 0;  ///< number of closed components that enclose a volume and face outward
  std::size_t inward = 0;   ///< number of closed components within an odd number of others: walls of cavities
  std::size_t nested = 0;   ///< number of closed components within one or more others
  std::vector<std::size_t> not_orientable = {};  ///< for each such component, the number of its first face in the file
};

/// The effects of the requested changes. A member is nullopt if the change was not requested.
struct EditReport {
  std::optional<Welded> weld = {};
  std::optional<Dropped> drop = {};
  std::optional<Oriented> orient = {};

  bool any() const { return weld || drop || orient; }
};

struct EditedMesh {
  MeshFile mesh;                         ///< without line numbers
  std::vector<std::uint32_t> point_was;  ///< number of each vertex in the file; the least number for merged vertices
  std::vector<std::size_t> face_was;     ///< number of each face in the file
  EditReport report;
};

/// Applies the requested changes to a copy of `mesh`. Cost: that of near_vertices(), meshops::repair() and
/// meshops::orient(), and a sort. Throws Cancelled.
EditedMesh edit(const MeshFile& mesh, const Edits& edits);

}  // namespace rbpa::app
