// What: what a filling must not touch: the triangles of a mesh near the loops to be filled, and the edges between their points.
// Law:  exact. What is added is as if it had been there from the beginning.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/closing/box_tree.h"
#include "rbpa/space/closing/least_triangulation.h"
#include "rbpa/space/closing/simple_loops.h"
#include "rbpa/space/closing/work.h"
#include "rbpa/space/predicate/crossing.h"

namespace rbpa::space {

/// What of a rim is in the way of its filling: chords and triangles by its corners.
struct Faults {
  std::vector<Chord> taken;            ///< join points that an edge joins
  std::vector<Chord> crossing;         ///< meet a triangle
  std::vector<RimTriangle> triangles;  ///< are met by a side of one, or by another new one
  bool none() const { return taken.empty() && crossing.empty() && triangles.empty(); }
};

class MeshAround {
 public:
  /// Keeps the spans. `loops`: all that may be filled. Throws: Cancelled.
  MeshAround(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
             std::span<const SimpleLoop> loops, meshops::Steps& step);

  /// The chords of a loop that edges of the mesh have, sorted.
  std::vector<Chord> taken_chords(const SimpleLoop& loop) const;
  Faults faults(std::uint32_t number, const Rim& rim, std::span<const RimTriangle> filling, Work& work) const;
  /// Adds the filling of the loop with this number.
  void add(std::uint32_t number, const Rim& rim, std::span<const RimTriangle> filling);

 private:
  std::optional<std::uint32_t> place_of(const Point3& p) const;

  std::span<const SimpleLoop> loops_;
  std::vector<Point3> places_;                          // points of the loops, sorted
  std::vector<std::vector<std::uint32_t>> joined_;      // to each place by an edge
  std::vector<Corners> triangles_;                      // near the loops
  std::vector<std::vector<std::uint32_t>> corners_at_;  // places of the corners of each loop
  BoxTree loop_tree_, triangle_tree_;
  std::vector<std::vector<Corners>> added_;  // to each loop
};

}  // namespace rbpa::space
