// What: the changes of a mesh before a repair: --weld, --keep-largest and --drop-small, --orient, in this order.
// Law:  positions stay as in the file, and no face is added. The result does not depend on the order of vertices and
//       faces, except for their numbers, and for the direction of an open component half of whose faces run either way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "meshtopo/weld.h"
#include "triangulation/component_choice.h"

namespace rbpa::app {

struct Edits {
  std::optional<double> weld = {};  ///< distance of --weld
  ComponentChoice components = {};
  bool orient = false;

  bool any() const { return weld || !components.keeps_all() || orient; }
};

struct Dropped {
  std::size_t components = 0;
  std::size_t faces = 0;     ///< dropped faces: those of dropped components, and degenerate and repeated ones
  std::size_t vertices = 0;  ///< dropped vertices: all that are corners of no kept face
};

struct Oriented {
  std::size_t faces = 0;                         ///< number of reversed faces
  std::size_t outward = 0;                       ///< closed components that enclose a volume, and face outward
  std::size_t inward = 0;                        ///< closed components in an odd number of others: walls of cavities
  std::size_t nested = 0;                        ///< closed components within one or more others
  std::vector<std::size_t> not_orientable = {};  ///< first face of each such component, by its number in the file
};

/// The effects of the changes; absent if a change was not requested.
struct EditReport {
  std::optional<Welded> weld = {};
  std::optional<Dropped> drop = {};
  std::optional<Oriented> orient = {};

  bool any() const { return weld || drop || orient; }
};

struct EditedMesh {
  MeshFile mesh;                         ///< without line numbers
  std::vector<std::uint32_t> point_was;  ///< for each vertex, its number in the file; of merged vertices, the least
  std::vector<std::size_t> face_was;     ///< for each face, its number in the file
  EditReport report;
};

/// Applies the requested changes. Cost: that of near_vertices(), kept_components(), orient(). Throws Cancelled.
EditedMesh edit(const MeshFile& mesh, const Edits& edits);

}  // namespace rbpa::app
