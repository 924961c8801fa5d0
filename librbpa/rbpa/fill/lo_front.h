// What:   Lo's mesher as a policy of the advancing-front engine: the shortest edge of the front gets a triangle, whose apex
//         is a point of the front or a new one.
// Law:    every triangle is empty: nothing of the front reaches into it or lies on it but its corners, which is decided
//         exactly. For every edge of the front there is such a triangle (docs/fill.md, section 3), so that none is ever
//         frozen, and the run ends.
// Cost:   a look at the edges around for each triangle.
// Source: Lo, A new mesh generation scheme for arbitrary planar domains (1985); George, Séveno, The advancing-front mesh
//         generation method revisited (1994).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

#include "meshops/front/policy.h"
#include "rbpa/base/point.h"
#include "rbpa/fill/edge_tree.h"
#include "rbpa/fill/shadow.h"
#include "rbpa/fill/size_field.h"

namespace rbpa {

using meshops::Front;
using meshops::Halfedge;
using meshops::Site;

class LoFront {
 public:
  /// `edges` are those of the front, behind each of which the mesh has one face, and `places` of its sites; of sites that
  /// are on no edge any. Keeps a reference to the field.
  LoFront(std::vector<Point> places, std::span<const FrontEdge> edges, const SizeField& field);

  /// Where the sites are, those that were placed as well.
  const std::vector<Point>& places() const { return places_; }
  std::size_t retreats() const { return retreated_; }
  /// How many edges of the front were compared with triangles: the work of finding empty ones.
  std::size_t compared() const { return compared_; }

  /// Shortest first.
  double key(const Front& front, Halfedge h) const;
  /// The front begins at the boundary.
  std::optional<std::array<Site, 3>> seed(const Front&) const { return std::nullopt; }
  /// The apex for an edge; or the triangle behind it goes, if none makes a good one.
  meshops::Proposal propose(const Front& front, Halfedge h);

  /// To be told what has become of the front.
  void attached(const Front& front, const meshops::InsertedTriangle& triangle);
  void detached(const meshops::DetachedTriangle& triangle);

 private:
  /// An edge that wants an apex, and what is around it.
  struct Task {
    Point a, b;
    Site from, to;
    double length;                       ///< of the edge
    double side;                         ///< that the others should have
    Point ideal;                         ///< where the apex would be best
    std::vector<FrontEdge> near = {};    ///< every edge of the front that meets `box`,
    std::vector<FrontEdge> hidden = {};  ///< but for these: any triangle into which one reaches is not empty without it
    std::vector<Shadow> shadows = {};    ///< by which they were left out
    std::vector<Site> candidates = {};   ///< ends of those, on the left of the edge
    std::vector<FrontEdge> blockers = {};  ///< the last that reached into a triangle
    Box box = {};
    std::size_t looked_at = 0;  ///< of `near`, for triangles that were not empty
    bool looked = false;
  };
  struct Choice {
    Site apex;
    double quality;
  };

  /// A candidate, by how good it is: the least is the best.
  using Ranked = std::pair<double, Site>;

  Task task_of(Site from, Site to) const;
  Point apex_at(const Task& task, double share) const;
  void look_around(Task& task, double reach) const;
  bool is_hidden(Task& task, const FrontEdge& edge) const;
  void hide(Task& task) const;
  void hide_all(Task& task) const;
  bool hide_behind_widest(Task& task) const;
  std::optional<Site> near_ideal(Task& task, double reach) const;
  std::optional<Choice> best_of(Task& task) const;
  std::optional<Choice> corner_of(const Front& front, Halfedge h, Task& task) const;
  std::optional<Ranked> first_free(Task& task, std::vector<Ranked>& order) const;
  std::optional<Point> placed(Task& task, double share, double clearance) const;
  bool reaches_into(const FrontEdge& edge, const Task& task, const Point& apex, std::optional<Site> site) const;
  bool is_known_blocked(Task& task, Site site) const;
  bool is_free(Task& task, const Point& apex, std::optional<Site> site) const;
  std::optional<meshops::Face> behind(const Front& front, Halfedge h) const;

  std::vector<Point> places_;
  std::size_t given_faces_;  // of the mesh, outside of the polygons: they stay
  const SizeField& field_;
  EdgeTree tree_;
  double least_clearance_;  // so far from the front is every new point
  std::size_t retreats_left_;
  std::size_t retreated_ = 0;
  mutable std::size_t compared_ = 0;
  std::unordered_set<std::uint64_t> retreated_from_;  // pairs of sites
};

}  // namespace rbpa
