// What:   Lo's mesher as a policy of the advancing-front engine: the shortest edge of the front gets a triangle, whose
//         apex is a point of the front or a new one.
// Law:    every triangle is empty: nothing of the front reaches into it or lies on it except its corners, which is
//         decided exactly. For every edge of the front there is such a triangle (docs/explanation/plane.md, section
//         27), so no edge is ever frozen, and the run ends.
// Cost:   for each triangle a search of the corners visible from an edge; and triangles that are detached again. On the
//         whole about 200 triangles of the unfilled region are crossed or made for each edge of the boundary and each
//         triangle of the result; ordinary fronts need thirty.
// Source: Lo, A new mesh generation scheme for arbitrary planar domains (1985); George, Séveno, The advancing-front
//         mesh generation method revisited (1994).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "meshops/front/policy.h"
#include "rbpa/base/point.h"
#include "rbpa/fill/front/size_field.h"
#include "rbpa/fill/front/unfilled.h"
#include "rbpa/plane/grid/box.h"

namespace rbpa {

using meshops::Front;
using meshops::Halfedge;
using meshops::Site;

class LoFront {
 public:
  /// Takes the rings of the front and the places of its sites; places of sites on no ring are arbitrary. Keeps a
  /// reference to the field.
  /// Requires: at least one ring; the mesh of the front has one face behind each edge of the rings, and no other face.
  /// Throws:   Cancelled.
  LoFront(std::vector<Point> places, std::span<const std::vector<Site>> rings, const SizeField& field,
          const GoOn& go_on);
  LoFront(const LoFront&) = delete;
  LoFront& operator=(const LoFront&) = delete;

  /// Returns the places of all sites, including those that the mesher added.
  const std::vector<Point>& places() const { return places_; }
  std::size_t retreats() const { return retreated_; }
  /// Returns a measure of the work: the number of triangles that searches passed, of triangles added, and of flips.
  std::size_t passed() const { return unfilled_.passed(); }

  /// Returns the length of an edge: the shortest is first.
  double key(const Front& front, Halfedge h) const;
  /// Returns nothing, as the front begins at the boundary.
  std::optional<std::array<Site, 3>> seed(const Front&) const { return std::nullopt; }
  /// Proposes the apex for an edge; detaches the triangle behind the edge if no apex makes a good one.
  meshops::Proposal propose(const Front& front, Halfedge h);

  /// Updates the unfilled region after a change of the front.
  void attached(const Front& front, const meshops::InsertedTriangle& triangle);
  void detached(const meshops::DetachedTriangle& triangle);

 private:
  /// An edge that needs an apex, and the candidates for it.
  struct Task {
    Point a, b;
    Site from, to;
    double length;                      ///< length of the edge
    double side;                        ///< target length of the other two edges
    Point ideal;                        ///< the best place of the apex
    std::vector<Site> candidates = {};  ///< sites that make empty triangles
    bool is_all = false;                ///< whether the last search covered the whole front
  };
  struct Choice {
    Site apex;
    double quality;
  };

  Task task_of(Site from, Site to) const;
  Point apex_at(const Task& task, double share) const;
  void look_around(Task& task, double reach) const;
  std::optional<Site> near_ideal(const Task& task, double reach) const;
  std::optional<Choice> best_of(const Task& task) const;
  std::optional<Choice> corner_of(const Front& front, Halfedge h, Task& task) const;
  std::optional<Point> placed(const Task& task, double share, double clearance) const;
  bool is_late() const;
  std::size_t most_passed() const;
  std::optional<meshops::Face> behind(const Front& front, Halfedge h) const;

  std::vector<Point> places_;
  std::size_t given_faces_ = 0;  // number of faces of the mesh outside of the polygons: they stay
  const SizeField& field_;
  Unfilled unfilled_;
  Box bounds_;                  // box of the front when it began
  double least_reach_ = 0;      // least radius of the second search for an edge
  double least_clearance_ = 0;  // least distance of a new point from the front
  std::size_t retreats_left_ = 0;
  std::size_t retreated_ = 0;
  std::unordered_set<std::uint64_t> retreated_from_;  // pairs of sites
  std::size_t kept_ = 0;                              // number of triangles that were attached and not detached
};

}  // namespace rbpa
