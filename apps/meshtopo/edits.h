// What: the changes of a mesh that the command line asks for, before a repair: --weld, --keep-largest and --drop-small, --orient,
//       in this order.
// Law:  positions are those of the file, and no face is added; the result does not depend on the order of vertices and faces,
//       but for their numbers, and for the direction of an open component of which as many faces run one way as the other.
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
  std::optional<double> weld = {};  ///< the distance
  ComponentChoice components = {};
  bool orient = false;

  bool any() const { return weld || !components.keeps_all() || orient; }
};

struct Dropped {
  std::size_t components = 0;
  std::size_t faces = 0;     ///< of them, and those that are no part of a surface: degenerate, or repeating another
  std::size_t vertices = 0;  ///< that no face has any more, or had before
};

struct Oriented {
  std::size_t faces = 0;                         ///< that are reversed
  std::size_t outward = 0;                       ///< closed components that enclose a volume, and face outward
  std::size_t inward = 0;                        ///< those in an odd number of others, the walls of cavities
  std::size_t nested = 0;                        ///< those in one or more others
  std::vector<std::size_t> not_orientable = {};  ///< the first face of each component, as the file numbers it
};

/// Absent: not asked for.
struct EditReport {
  std::optional<Welded> weld = {};
  std::optional<Dropped> drop = {};
  std::optional<Oriented> orient = {};

  bool any() const { return weld || drop || orient; }
};

struct EditedMesh {
  MeshFile mesh;                         ///< without lines
  std::vector<std::uint32_t> point_was;  ///< of each vertex: its number in the file, the least where several became one
  std::vector<std::size_t> face_was;     ///< of each face: its number in the file
  EditReport report;
};

/// Cost: that of near_vertices(), kept_components(), orient(). Throws Cancelled.
EditedMesh edit(const MeshFile& mesh, const Edits& edits);

}  // namespace rbpa::app
