#include "rbpa/space/solid/tiles/unsettled.h"

#include <cmath>

#include "rbpa/space/solid/insertion/insertion.h"
#include "rbpa/space/solid/insertion/spatial_order.h"

namespace rbpa::space {
namespace {

constexpr std::uint32_t none = Solid::none;

/// Faces with a tetrahedron on one side only, in buckets by first corner. Corners are positions in `unsettled`.
class OpenSides {
 public:
  /// Collects the border faces that have no neighbor and only unsettled corners.
  OpenSides(const std::vector<Place>& unsettled, std::size_t places, const FoundRows& found)
      : end_(unsettled.size() + 1, 0) {
    std::vector<std::uint32_t> number(places, none);
    for (std::uint32_t i = 0; i < unsettled.size(); ++i) number[unsettled[i]] = i;
    std::vector<std::uint32_t> first;
    std::vector<Side> sides;
    for (const BorderFace& border : found.border) {
      const std::uint32_t t = border.face / 4, k = border.face % 4;
      if (found.rows.neighbors[t][k] != none) continue;
      const std::uint32_t a = number[border.corners[0]], b = number[border.corners[1]], c = number[border.corners[2]];
      if (a == none || b == none || c == none) continue;
      first.push_back(a);
      sides.push_back({b, c, border.face, is_ascending_outside(found.rows.corners[t], k)});
      ++end_[a + 1];
    }
    for (std::size_t i = 1; i < end_.size(); ++i) end_[i] += end_[i - 1];
    sides_.resize(sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i)
      sides_[end_[first[i]]++] = sides[i];  // end_[i] moves from the beginning of bucket i to its end
  }

  bool empty() const { return sides_.empty(); }

  /// Returns the border face that equals the face across from corner k of the tetrahedron `corners`, if the known
  /// tetrahedron of the border face is on the other side; otherwise none.
  std::uint32_t face_of(const Row& corners, std::size_t k) const {
    const BorderFace face = border_face(corners, 0, k);
    const std::uint32_t first = face.corners[0];
    for (std::uint32_t i = first == 0 ? 0 : end_[first - 1]; i < end_[first]; ++i) {
      const Side& side = sides_[i];
      if (side.middle == face.corners[1] && side.greatest == face.corners[2] &&
          side.is_ascending != is_ascending_outside(corners, k))
        return side.face;
    }
    return none;
  }

 private:
  struct Side {
    std::uint32_t middle, greatest, face;
    bool is_ascending;  ///< is_ascending_outside() of the tetrahedron at the face
  };
  std::vector<Side> sides_;
  std::vector<std::uint32_t> end_;  // for each first corner, the end of its bucket in sides_
};

}  // namespace

void add_remainder(const Leaves& leaves, const Spread& spread, double alpha, const std::vector<Place>& unsettled,
                   FoundRows& found) {
  const OpenSides open(unsettled, leaves.places(), found);
  const bool are_all = found.rows.corners.empty();
  if (open.empty() && !are_all) return;
  std::vector<Point3> points;
  points.reserve(unsettled.size());
  for (const Place i : unsettled) points.push_back(leaves.point(i));
  Threads one(1);
  const SpatialOrder sorted = spatial_order(points, points, one, {});
  Insertion triangulation(points, points, spread, sorted, one);
  if (!triangulation.insert_all({})) return;

  const auto tetrahedra = triangulation.tetrahedra();
  const auto corners_of = [&](std::uint32_t t) {
    Row row;
    for (std::size_t k = 0; k < 4; ++k) row[k] = triangulation.index()[tetrahedra[t].corner[k]];
    return row;
  };
  // 1. Add the tetrahedra at open sides. Step 2 does not cross the faces at open sides.
  const Row nothing = {none, none, none, none};
  std::vector<Row> open_sides(tetrahedra.size(), nothing);
  std::vector<std::uint32_t> number(tetrahedra.size(), none), added;
  auto next = static_cast<std::uint32_t>(found.rows.corners.size());
  const auto add = [&](std::uint32_t t) {
    if (number[t] != none || tetrahedra[t].is_ghost()) return;
    number[t] = next++;
    added.push_back(t);
  };
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
    if (triangulation.is_deleted(t) || tetrahedra[t].is_ghost()) continue;
    const Row corners = corners_of(t);
    if (are_all) add(t);
    for (std::size_t k = 0; k < 4; ++k)
      if ((open_sides[t][k] = open.face_of(corners, k)) != none) add(t);
  }
  // 2. Add neighbors of added tetrahedra until there are no more.
  for (std::size_t i = 0; i < added.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      if (open_sides[added[i]][k] == none) add(tetrahedra[added[i]].neighbor[k] / 4);
  // 3. Append the added tetrahedra to `found`, with their neighbors.
  for (const std::uint32_t t : added) {
    Row row = corners_of(t), neighbors = nothing;
    for (std::size_t k = 0; k < 4; ++k) {
      row[k] = unsettled[row[k]];
      const std::uint32_t face = open_sides[t][k];
      neighbors[k] = face == none ? number[tetrahedra[t].neighbor[k] / 4] : face / 4;
      if (face != none) found.rows.neighbors[face / 4][face % 4] = number[t];
    }
    found.rows.corners.push_back(row);
    found.rows.neighbors.push_back(neighbors);
    found.is_within.push_back(std::isinf(alpha) || triangulation.is_within(t, alpha, alpha) ? 1 : 0);
  }
}

}  // namespace rbpa::space
