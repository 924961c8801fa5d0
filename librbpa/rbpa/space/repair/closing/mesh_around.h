// What: keeps the obstacles to fillings: the triangles of a mesh near the loops that are to be filled, and the edges
//       between points of the loops.
// Law:  exact. Fillings that were added are obstacles to later ones.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/cells/box_tree.h"
#include "rbpa/space/predicate/crossing.h"
#include "rbpa/space/repair/closing/least_triangulation.h"
#include "rbpa/space/repair/closing/simple_loops.h"
#include "rbpa/space/repair/closing/work.h"

namespace rbpa::space {

/// The chords and triangles of a filling that are not allowed, by corners of the rim.
struct Faults {
  std::vector<Chord> taken;     ///< chords whose ends an edge of the mesh joins already
  std::vector<Chord> crossing;  ///< chords that cross a triangle of the mesh
  /// New triangles that cross a side of a triangle of the mesh, or another new triangle.
  std::vector<RimTriangle> triangles;
  bool none() const { return taken.empty() && crossing.empty() && triangles.empty(); }
};

class MeshAround {
 public:
  /// Prepares for fillings of `loops`, which has all loops that may be filled. Keeps the span. Throws: Cancelled.
  MeshAround(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
             std::span<const SimpleLoop> loops, meshops::Steps& step);

  /// Returns the chords of a loop that are edges of the mesh, sorted. Requires: `loop` is an element of `loops`.
  std::vector<Chord> taken_chords(const SimpleLoop& loop) const;
  /// Returns the faults of `filling`, which fills loop `number` with this rim; without faults, the filling may be
  /// added. Spends work for each pair of triangles.
  Faults faults(std::uint32_t number, const Rim& rim, std::span<const RimTriangle> filling, Work& work) const;
  /// Adds the filling of loop `number` to the mesh.
  void add(std::uint32_t number, const Rim& rim, std::span<const RimTriangle> filling);

 private:
  std::optional<std::uint32_t> place_of(const Point3& p) const;

  std::span<const SimpleLoop> loops_;
  std::vector<Point3> places_;                      // the points of the loops, sorted
  std::vector<std::vector<std::uint32_t>> joined_;  // for each place: the places to which an edge of the mesh joins it
  std::vector<Corners> triangles_;                  // triangles of the mesh near the loops
  std::vector<std::vector<std::uint32_t>> corners_at_;  // for each loop: the places of its corners
  BoxTree loop_tree_, triangle_tree_;
  std::vector<std::vector<Corners>> added_;  // for each loop: the triangles of its filling
};

}  // namespace rbpa::space
