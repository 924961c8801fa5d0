#include "rbpa/space/solid/insertion/tetrahedra.h"

#include <algorithm>
#include <string>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/predicate/outer_faces.h"

namespace rbpa::space {
namespace {

constexpr std::uint32_t max_tetrahedra = std::uint32_t{1} << 30U;  // 32 bits number their faces

}  // namespace

template <bool weighted>
BasicTetrahedra<weighted>::BasicTetrahedra(std::span<const Point3> points, std::span<const Point3> scaled,
                                           const Spread& spread, std::span<const std::uint32_t> order,
                                           std::span<const double> radii, std::span<const double> scaled_radii,
                                           std::size_t room, Threads& threads)
    : points_(points),
      radii_(spread.is_exact ? scaled_radii : radii),
      spread_(spread),
      beyond_filter_(spread),
      index_(order.size() + 1),
      vertex_(order.size() + 1),
      tetrahedra_(std::min<std::size_t>(room, max_tetrahedra)),
      error_(tetrahedra_.size()) {
  vertex_[at_infinity] = {};
  index_[at_infinity] = 0;
  for_each_part(threads, order.size(), 1u << 14, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      index_[i + 1] = order[i];
      VertexData& vertex = vertex_[i + 1] = {};
      static_cast<Point3&>(vertex) = scaled[order[i]];
      if constexpr (weighted) vertex.radius = scaled_radii[order[i]];
    }
  });
}

template <bool weighted>
void BasicTetrahedra<weighted>::exchange(Vertex v, Vertex w) {
  std::swap(index_[v], index_[w]);
  std::swap(vertex_[v], vertex_[w]);
}

template <bool weighted>
std::uint32_t BasicTetrahedra<weighted>::add(std::uint32_t count) {
  std::uint32_t first;
  while (!add_in_room(count, first)) {
    if (used_ > max_tetrahedra - count)
      throw InvalidInput("more than " + std::to_string(max_tetrahedra) +
                         " tetrahedra at a time, expected so few that 32 bits number their faces");
    make_room(tetrahedra_.size() + tetrahedra_.size() / 2 + count);
  }
  return first;
}

template <bool weighted>
void BasicTetrahedra<weighted>::make_room(std::size_t room) {
  if (room <= tetrahedra_.size()) return;
  tetrahedra_.resize(std::min<std::size_t>(room, max_tetrahedra));
  error_.resize(tetrahedra_.size());
}

template <bool weighted>
bool BasicTetrahedra<weighted>::add_in_room(std::uint32_t count, std::uint32_t& first) {
  first = used_.load(std::memory_order_relaxed);
  do
    if (tetrahedra_.size() - first < count) return false;
  while (!used_.compare_exchange_weak(first, first + count, std::memory_order_relaxed));
  std::fill_n(&error_[first], count, ErrorBound::deleted());
  return true;
}

template <bool weighted>
bool BasicTetrahedra<weighted>::decide(std::uint32_t t, Vertex v, const Estimate& estimate) const {
  const Tetrahedron& tetrahedron = tetrahedra_[t];
  if (tetrahedron.is_ghost()) return decide_ghost(tetrahedron, v, estimate);
  const auto& [a, b, c, d] = tetrahedron.corner;
  if constexpr (weighted) {
    const auto radius = [&](Vertex corner) { return radii_[index_[corner]]; };
    const FiveRadii radii = {radius(a), radius(b), radius(c), radius(d), radius(v)};
    return beyond_filter_.is_inside(point(a), point(b), point(c), point(d), point(v), estimate.value, estimate.error,
                                    &radii);
  }
  return beyond_filter_.is_inside(point(a), point(b), point(c), point(d), point(v), estimate.value, estimate.error);
}

/// Returns whether v is beyond the hull face of a ghost. A point in the plane of the face counts as beyond if it is in
/// the circle of the face: in the sphere of the tetrahedron behind the face.
template <bool weighted>
bool BasicTetrahedra<weighted>::decide_ghost(const Tetrahedron& ghost, Vertex v, const Estimate& estimated) const {
  const auto& corner = ghost.corner;
  const std::size_t k = corner[0] == at_infinity ? 0 : corner[1] == at_infinity ? 1 : 2;
  const auto& face = outer_faces[k];  // positively oriented with a point inside of the hull
  // A value of degree three without an error: 0 in the plane.
  if (estimated.value != 0 || estimated.error >= spread_.exact_below(3)) {
    const int side = orientation(point(corner[face[0]]), point(corner[face[1]]), point(corner[face[2]]), point(v));
    if (side != 0) return side < 0;
  }
  const std::uint32_t behind = ghost.neighbor[k] / 4;
  if (error_[behind].is_deleted()) return true;  // the tetrahedron behind the face is in the cavity
  return is_inside(behind, v, estimate(behind, vertex_[v]));
}

template <bool weighted>
bool BasicTetrahedra<weighted>::is_within(std::uint32_t t, double alpha, double scaled_alpha) const {
  const Tetrahedron& tetrahedron = tetrahedra_[t];
  if (spread_.is_exact) {
    const RadiusSide side = radius_side(tetrahedron.minor, error_[t], scaled_alpha);
    if (side != RadiusSide::unknown) return side == RadiusSide::within;
  }
  const auto original = [&](std::size_t k) { return points_[index_[tetrahedron.corner[k]]]; };
  return exact::compare_circumradius(original(0), original(1), original(2), original(3), alpha) <= 0;
}

template class BasicTetrahedra<false>;
template class BasicTetrahedra<true>;

}  // namespace rbpa::space
