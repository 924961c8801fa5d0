// What:   Lo's mesher as a policy of the advancing-front engine: the shortest edge of the front gets a triangle, whose
//         apex is a point of the front or a new point.
// Law:    every triangle is empty: the front has no point in the triangle or on its sides, except its corners and its
//         own edges; decided exactly. For every edge of the front there is an empty triangle
//         (docs/explanation/plane.md, section 27), so no edge is ever frozen, and the run ends.
// Cost:   a search of the corners visible from an edge for each triangle, including triangles that are detached again.
//         In total, about 200 triangles of the unfilled region at most are crossed or made for each boundary edge and
//         each triangle of the result; ordinary fronts need thirty.
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
  /// Takes the places of the sites of the front, and its rings; places of sites on no ring are arbitrary. Keeps a
  /// reference to `field`.
  /// Requires: at least one ring; the mesh of the front has one face behind each edge of the rings, and no other face.
  /// Throws:   Cancelled.
  LoFront(std::vector<Point> places, std::span<const std::vector<Site>> rings, const SizeField& field,
          const GoOn& go_on);
  LoFront(const LoFront&) = delete;
  LoFront& operator=(const LoFront&) = delete;

  /// Returns the places of all sites, including those that the mesher added.
  const std::vector<Point>& places() const { return places_; }
  std::size_t retreats() const { return retreated_; }
  /// Returns Unfilled::passed(): a measure of the work.
  std::size_t passed() const { return unfilled_.passed(); }

  /// Returns the length of an edge; the front processes the edge with the least key first.
  double key(const Front& front, Halfedge h) const;
  /// Returns nothing: the front begins at the boundary, and needs no seed.
  std::optional<std::array<Site, 3>> seed(const Front&) const { return std::nullopt; }
  /// Proposes the apex of a triangle on edge `h`; or, if every triangle there is bad, proposes to detach a triangle
  /// behind `h` or behind one of the two edges beside `h`.
  meshops::Proposal propose(const Front& front, Halfedge h);

  /// Updates the unfilled region after a change of the front.
  void attached(const Front& front, const meshops::InsertedTriangle& triangle);
  void detached(const meshops::DetachedTriangle& triangle);

 private:
  /// An edge that needs an apex, and the candidates for the apex.
  struct Task {
    Point a, b;
    Site from, to;
    double length;                      ///< length of the edge
    double side;                        ///< target length of the other two edges
    Point ideal;                        ///< the best place of the apex
    std::vector<Site> candidates = {};  ///< sites that form empty triangles with the edge
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
  std::size_t given_faces_ = 0;  // number of faces outside of the polygons, which are never detached
  const SizeField& field_;
  Unfilled unfilled_;
  Box bounds_;                  // bounding box of the initial front
  double least_reach_ = 0;      // least radius of the second search for an edge
  double least_clearance_ = 0;  // least distance of a new point from the front
  std::size_t retreats_left_ = 0;
  std::size_t retreated_ = 0;
  std::unordered_set<std::uint64_t> retreated_from_;  // edges from which the front retreated, by key_of()
  std::size_t kept_ = 0;                              // number of triangles that were attached and not detached
};

}  // namespace rbpa
