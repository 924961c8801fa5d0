#include "rbpa/space/solid/insertion/insertion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/predicate/outer_faces.h"

namespace rbpa::space {
namespace {

constexpr std::uint32_t max_tetrahedra = std::uint32_t{1} << 30U;  // 32 bits number their faces

}  // namespace

template <bool weighted>
BasicInsertion<weighted>::BasicInsertion(std::span<const Point3> points, std::span<const Point3> scaled,
                                         const Spread& spread, std::span<const std::uint32_t> order,
                                         std::span<const double> radii, std::span<const double> scaled_radii)
    : original_(points),
      points_(spread.is_exact ? scaled : points),
      radii_(spread.is_exact ? scaled_radii : radii),
      spread_(spread),
      beyond_filter_(spread),
      index_(order.size() + 1),
      vertex_(order.size() + 1) {
  vertex_[at_infinity] = {};
  index_[at_infinity] = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Point3& p = scaled[order[i]];
    index_[i + 1] = order[i];
    Inserted& vertex = vertex_[i + 1] = {};
    vertex.x = p.x;
    vertex.y = p.y;
    vertex.z = p.z;
    if constexpr (weighted) vertex.radius = scaled_radii[order[i]];
  }
  // The usual number of tetrahedra of points that fill a volume, including ghosts and deleted tetrahedra. Reserved
  // memory that is not used is not touched.
  const std::size_t expected = 7 * order.size() + 64;
  tetrahedra_.reserve(expected);
  error_.reserve(expected);
}

template <bool weighted>
bool BasicInsertion<weighted>::begin() {
  const auto exchange = [&](Vertex v, Vertex w) {
    std::swap(index_[v], index_[w]);
    std::swap(vertex_[v], vertex_[w]);
  };
  Vertex third = 3, fourth;
  while (third <= size() && are_collinear(point(1), point(2), point(third))) ++third;
  if (third > size()) return false;
  exchange(3, third);
  for (fourth = 4; fourth <= size(); ++fourth)
    if (orientation(point(1), point(2), point(3), point(fourth)) != 0) break;
  if (fourth > size()) return false;
  exchange(4, fourth);
  if (orientation(point(1), point(2), point(3), point(4)) < 0) exchange(1, 2);

  // The first tetrahedron, its ghosts at the three faces that contain vertex 4, and the ghost at the face (1, 2, 3).
  constexpr std::array<std::array<Vertex, 4>, 5> corners = {
      {{1, 2, 3, 4}, {at_infinity, 3, 2, 4}, {at_infinity, 1, 3, 4}, {at_infinity, 2, 1, 4}, {3, 1, at_infinity, 2}}};
  const std::uint32_t first = new_tetrahedra(corners.size());
  const auto across = [&](std::uint32_t t, std::size_t k) {  // returns the equal face of another tetrahedron
    for (std::uint32_t other = 0; other < corners.size(); ++other)
      for (std::uint32_t j = 0; j < 4; ++j) {
        std::array<Vertex, 4> mine = corners[t], its = corners[other];
        mine[k] = its[j] = std::numeric_limits<Vertex>::max();
        std::sort(mine.begin(), mine.end());
        std::sort(its.begin(), its.end());
        if (other != t && mine == its) return 4 * (first + other) + j;
      }
    return Face{0};
  };
  for (std::uint32_t t = 0; t < corners.size(); ++t) {
    rim_.clear();
    spokes_.clear();
    rim_.make_room(3);
    spokes_.make_room(3);
    for (std::size_t k = 0; k < 3; ++k) add_spoke(corners[t][k], vertex_[corners[t][3]]);
    tetrahedra_[first + t].corner[3] = corners[t][3];
    make(first + t, {0, 1, 2});
    for (std::size_t k = 0; k < 4; ++k) tetrahedra_[first + t].neighbor[k] = across(t, k);
  }
  start_ = first;
  return true;
}

template <bool weighted>
std::size_t BasicInsertion<weighted>::insert(Vertex v) {
  const std::uint32_t t = locate(v);
  if constexpr (weighted) {
    start_ = t;
    if (!is_inside(t, v, estimate(t, vertex_[v]))) return 0;
  }
  find_cavity(t, v);
  fill_cavity(v);
  return boundary_.size();
}

template <bool weighted>
inline auto BasicInsertion<weighted>::estimate(std::uint32_t t, const Inserted& q) const -> Estimate {
  const Tetrahedron& tetrahedron = tetrahedra_[t];
  const Inserted& d = vertex_[tetrahedron.corner[3]];
  const double x = q.x - d.x, y = q.y - d.y, z = q.z - d.z, square = x * x + y * y + z * z;
  const auto& m = tetrahedron.minor;
  if constexpr (weighted) {
    const double weight = weight_difference(q.radius, d.radius);
    return {m[0] * x + m[1] * y + m[2] * z + m[3] * (square - weight), error_[t].at(square + std::abs(weight))};
  }
  return {m[0] * x + m[1] * y + m[2] * z + m[3] * square, error_[t].at(square)};
}

template <bool weighted>
inline bool BasicInsertion<weighted>::is_inside(std::uint32_t t, Vertex v, const Estimate& estimate) const {
  if (estimate.value > estimate.error) return true;
  if (estimate.value < -estimate.error) return false;
  return decide(t, v, estimate);
}

template <bool weighted>
bool BasicInsertion<weighted>::decide(std::uint32_t t, Vertex v, const Estimate& estimate) const {
  const Tetrahedron& tetrahedron = tetrahedra_[t];
  if (tetrahedron.is_ghost()) return decide_ghost(tetrahedron, v);
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
bool BasicInsertion<weighted>::decide_ghost(const Tetrahedron& ghost, Vertex v) const {
  const auto& corner = ghost.corner;
  const std::size_t k = corner[0] == at_infinity ? 0 : corner[1] == at_infinity ? 1 : 2;
  const auto& face = outer_faces[k];  // positively oriented with a point inside of the hull
  const int side = orientation(point(corner[face[0]]), point(corner[face[1]]), point(corner[face[2]]), point(v));
  if (side != 0) return side < 0;
  const std::uint32_t behind = ghost.neighbor[k] / 4;
  if (error_[behind].is_deleted()) return true;  // the tetrahedron behind the face is in the cavity
  return is_inside(behind, v, estimate(behind, vertex_[v]));
}

/// Returns a tetrahedron whose sphere contains the point of v; for a hidden ball, a tetrahedron that contains the
/// center. A point on the plane of a face has equal powers with respect to the spheres on both sides of the face. The
/// power of the point thus decreases from a tetrahedron to the neighbor on the point's side of a face; the walk takes
/// the step of greatest decrease.
template <bool weighted>
std::uint32_t BasicInsertion<weighted>::locate(Vertex v) const {
  const Inserted& q = vertex_[v];
  std::uint32_t t = start_;
  const Estimate at_start = estimate(t, q);
  if (at_start.value > at_start.error) return t;
  // The value V is −power · six volumes, and minor 3 is −six volumes; minor 3 of a ghost is about 0.
  const auto power_of = [&](std::uint32_t s, double value) {
    return tetrahedra_[s].is_ghost() ? std::numeric_limits<double>::infinity() : value / tetrahedra_[s].minor[3];
  };
  double power = power_of(t, at_start.value);
  while (true) {
    std::uint32_t best = t;
    for (const Face face : tetrahedra_[t].neighbor) {
      const std::uint32_t other = face / 4;
      const Estimate estimated = estimate(other, q);
      if (estimated.value > estimated.error) return other;
      const double other_power = power_of(other, estimated.value);
      if (other_power < power) {
        power = other_power;
        best = other;
      }
    }
    if (best == t) return locate_exactly(t, v);  // rounded powers or a tie ended the walk
    t = best;
  }
}

/// Returns a tetrahedron as locate() does, by exact orientations. The walk ends because the exact power decreases.
template <bool weighted>
std::uint32_t BasicInsertion<weighted>::locate_exactly(std::uint32_t t, Vertex v) const {
  while (true) {
    const Tetrahedron& tetrahedron = tetrahedra_[t];
    if (tetrahedron.is_ghost()) {
      if (is_inside(t, v, estimate(t, vertex_[v]))) return t;
      for (std::size_t k = 0; k < 3; ++k)
        if (tetrahedron.corner[k] == at_infinity) t = tetrahedron.neighbor[k] / 4;
      continue;
    }
    std::uint32_t next = t;
    for (std::size_t k = 0; k < 4 && next == t; ++k) {
      const auto& face = outer_faces[k];
      const auto& corner = tetrahedron.corner;
      if (orientation(point(corner[face[0]]), point(corner[face[1]]), point(corner[face[2]]), point(v)) > 0)
        next = tetrahedron.neighbor[k] / 4;
    }
    // The point is in the tetrahedron but is no corner of it, and thus inside of the sphere; a ball may be hidden.
    if (next == t) return t;
    t = next;
    if (tetrahedra_[t].is_ghost()) return t;  // the point is beyond the face of the ghost
  }
}

template <bool weighted>
void BasicInsertion<weighted>::find_cavity(std::uint32_t first, Vertex v) {
  const Inserted q = vertex_[v];
  cavity_.clear();
  boundary_.clear();
  level_.clear();
  cavity_.make_room(1);
  cavity_.push(first);
  error_[first] = ErrorBound::deleted();
  level_.make_room(4);
  for (const Face face : tetrahedra_[first].neighbor) level_.push(face);
  while (!level_.empty()) {
    const std::size_t count = level_.size();
    estimates_.clear();
    estimates_.make_room(count);
    next_level_.clear();
    next_level_.make_room(3 * count + 3);
    cavity_.make_room(count + 1);  // one more is written but not counted
    boundary_.make_room(count + 1);
    // All estimates are computed first, as they do not depend on each other. About half of the tests succeed, so the
    // code does not branch on the results.
    for (std::size_t i = 0; i < count; ++i) estimates_.push(estimate(level_[i] / 4, q));
    for (std::size_t i = 0; i < count; ++i) {
      const Face face = level_[i];
      const std::uint32_t t = face / 4;
      const Estimate& estimated = estimates_[i];
      const bool is_new = !error_[t].is_deleted();
      bool is_in = estimated.value > estimated.error;
      if (!(std::abs(estimated.value) > estimated.error)) [[unlikely]]
        is_in = is_new && decide(t, v, estimated);
      const auto& neighbor = tetrahedra_[t].neighbor;
      const bool is_taken = is_new & is_in;
      boundary_.push_if(is_new & !is_in, face);
      cavity_.push_if(is_taken, t);
      error_[t] = error_[t].deleted_if(is_taken);
      next_level_.push_if(is_taken, {neighbor[(face + 1) % 4], neighbor[(face + 2) % 4], neighbor[(face + 3) % 4]});
    }
    std::swap(level_, next_level_);
  }
}

template <bool weighted>
inline void BasicInsertion<weighted>::add_spoke(Vertex corner, const Inserted& from) {
  rim_.push(corner);
  const Inserted& p = vertex_[corner];
  const auto spoke = [&](auto... weight) { return AnySpoke::to(p.x - from.x, p.y - from.y, p.z - from.z, weight...); };
  if constexpr (weighted)
    spokes_.push(corner == at_infinity ? AnySpoke::to_infinity() : spoke(weight_difference(p.radius, from.radius)));
  else
    spokes_.push(corner == at_infinity ? AnySpoke::to_infinity() : spoke());
}

/// Returns the number of a corner among the vertices of the cavity's boundary; adds a new corner to rim_.
template <bool weighted>
inline std::uint32_t BasicInsertion<weighted>::number_of(Vertex corner, Vertex v) {
  Inserted& p = vertex_[corner];
  if (p.last_insertion != v) {
    p.last_insertion = v;
    p.local = static_cast<std::uint32_t>(rim_.size());
    add_spoke(corner, vertex_[v]);
  }
  return p.local;
}

/// Resizes cavity_ to one tetrahedron for each face of the boundary: the cavity's, then free ones, then new ones.
template <bool weighted>
void BasicInsertion<weighted>::make_room() {
  const std::size_t wanted = boundary_.size();
  if (wanted < cavity_.size()) {
    free_.make_room(cavity_.size() - wanted);
    while (cavity_.size() > wanted) free_.push(cavity_.pop());
    return;
  }
  cavity_.make_room(wanted - cavity_.size());
  while (cavity_.size() < wanted && !free_.empty()) cavity_.push(free_.pop());
  if (cavity_.size() == wanted) return;
  for (std::uint32_t t = new_tetrahedra(wanted - cavity_.size()); t < tetrahedra_.size(); ++t) cavity_.push(t);
}

template <bool weighted>
void BasicInsertion<weighted>::fill_cavity(Vertex v) {
  const std::size_t faces = boundary_.size();
  rim_.clear();
  spokes_.clear();
  locals_.clear();
  rim_.make_room(faces + 2);  // the boundary is a sphere: it has faces / 2 + 2 vertices
  spokes_.make_room(faces + 2);
  locals_.make_room(faces);
  for (std::size_t i = 0; i < faces; ++i) {
    const auto& corner = tetrahedra_[boundary_[i] / 4].corner;
    const auto& order = outer_faces[boundary_[i] % 4];
    locals_.push({number_of(corner[order[0]], v), number_of(corner[order[1]], v), number_of(corner[order[2]], v)});
  }
  make_room();
  edges_.begin(rim_.size(), faces);
  for (std::size_t i = 0; i < faces; ++i) {
    const auto& [a, b, c] = locals_[i];
    const Face face = 4 * cavity_[i];
    edges_.put(b, c, face);
    edges_.put(c, a, face + 1);
    edges_.put(a, b, face + 2);
  }
  for (std::size_t i = 0; i < faces; ++i) {
    const std::uint32_t t = cavity_[i];
    const auto& [a, b, c] = locals_[i];
    tetrahedra_[t].corner[3] = v;
    make(t, locals_[i]);
    tetrahedra_[t].neighbor = {edges_.get(c, b), edges_.get(a, c), edges_.get(b, a), boundary_[i]};
    tetrahedra_[boundary_[i] / 4].neighbor[boundary_[i] % 4] = 4 * t + 3;
  }
  start_ = cavity_[0];
}

/// Fills in corners 0 to 2 of tetrahedron t, its minors, and its error bound.
template <bool weighted>
inline void BasicInsertion<weighted>::make(std::uint32_t t, const Locals& locals) {
  const AnySpoke &a = spokes_[locals[0]], &b = spokes_[locals[1]], &c = spokes_[locals[2]];
  Tetrahedron& tetrahedron = tetrahedra_[t];
  tetrahedron.minor = sphere_minors(a, b, c);
  for (std::size_t k = 0; k < 3; ++k) tetrahedron.corner[k] = rim_[locals[k]];
  const double underflow = spread_.underflow();
  error_[t] = tetrahedron.is_ghost() ? half_space_error(a, b, c, underflow) : sphere_error(a, b, c, underflow);
}

template <bool weighted>
std::uint32_t BasicInsertion<weighted>::new_tetrahedra(std::size_t count) {
  const std::size_t first = tetrahedra_.size();
  if (first + count > max_tetrahedra)
    throw InvalidInput("more than " + std::to_string(max_tetrahedra) +
                       " tetrahedra at a time, expected so few that 32 bits number their faces");
  tetrahedra_.resize(first + count);
  error_.resize(first + count);
  return static_cast<std::uint32_t>(first);
}

template <bool weighted>
bool BasicInsertion<weighted>::is_within(std::uint32_t t, double alpha, double scaled_alpha) const requires(!weighted) {
  const Tetrahedron& tetrahedron = tetrahedra_[t];
  if (spread_.is_exact) {
    const RadiusSide side = radius_side(tetrahedron.minor, error_[t], scaled_alpha);
    if (side != RadiusSide::unknown) return side == RadiusSide::within;
  }
  const auto original = [&](std::size_t k) { return original_[index_[tetrahedron.corner[k]]]; };
  return exact::compare_circumradius(original(0), original(1), original(2), original(3), alpha) <= 0;
}

template class BasicInsertion<false>;
template class BasicInsertion<true>;

}  // namespace rbpa::space
