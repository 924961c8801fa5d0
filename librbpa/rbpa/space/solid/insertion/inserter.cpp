#include "rbpa/space/solid/insertion/inserter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/predicate/outer_faces.h"

namespace rbpa::space {

template <bool weighted>
bool BasicInserter<weighted>::owns(std::uint32_t t) const {
  const auto& corner = all_[t].corner;
  return owner_ == nullptr || std::all_of(corner.begin(), corner.end(), [&](Vertex v) { return owns_corner(v); });
}

/// Returns whether this inserter owns all corners of the tetrahedron with this face. Requires: it owns the face.
template <bool weighted>
inline bool BasicInserter<weighted>::owns_beyond(Face face) const {
  return owner_ == nullptr || owns_corner(all_[face / 4].corner[face % 4]);
}

template <bool weighted>
void BasicInserter<weighted>::begin() {
  // The first tetrahedron, its ghosts at the three faces that contain vertex 4, and the ghost at the face (1, 2, 3).
  constexpr std::array<std::array<Vertex, 4>, 5> corners = {
      {{1, 2, 3, 4}, {at_infinity, 3, 2, 4}, {at_infinity, 1, 3, 4}, {at_infinity, 2, 1, 4}, {3, 1, at_infinity, 2}}};
  const std::uint32_t first = all_.add(corners.size());
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
    for (std::size_t k = 0; k < 3; ++k) add_spoke(corners[t][k], all_.vertices()[corners[t][3]]);
    Tetrahedron& tetrahedron = all_.all()[first + t];
    tetrahedron.corner[3] = corners[t][3];
    make(first + t, {0, 1, 2});
    for (std::size_t k = 0; k < 4; ++k) tetrahedron.neighbor[k] = across(t, k);
  }
  last_ = first;
}

template <bool weighted>
InsertionResult BasicInserter<weighted>::insert(Vertex v, std::uint32_t t) {
  InsertionResult result = InsertionResult::yes;
  t = locate(v, t, result);
  if (result != InsertionResult::yes) return result;
  if constexpr (weighted) {
    boundary_.clear();
    last_ = t;
    if (!all_.is_inside(t, v, all_.estimate(t, all_.vertices()[v]))) return result;
  }
  if (!find_cavity(t, v) || !make_room()) {
    give_up_cavity();
    return InsertionResult::not_owned;
  }
  fill_cavity(v);
  return result;
}

/// Returns a tetrahedron whose sphere contains the point of v; for a hidden ball, a tetrahedron that contains the
/// center. A point on the plane of a face has equal powers with respect to the spheres on both sides of the face. The
/// power of the point thus decreases from a tetrahedron to the neighbor on the point's side of a face; the walk takes
/// the step of greatest decrease among the tetrahedra that this inserter owns.
template <bool weighted>
std::uint32_t BasicInserter<weighted>::locate(Vertex v, std::uint32_t t, InsertionResult& refusal) const {
  const VertexData& q = all_.vertices()[v];
  const Estimate at_start = all_.estimate(t, q);
  if (at_start.value > at_start.error) return t;
  // The value V is −power · six volumes, and minor 3 is −six volumes; minor 3 of a ghost is about 0.
  const auto power_of = [&](std::uint32_t s, double value) {
    return all_[s].is_ghost() ? std::numeric_limits<double>::infinity() : value / all_[s].minor[3];
  };
  double power = power_of(t, at_start.value);
  while (true) {
    std::uint32_t best = t;
    bool is_stopped = false;
    for (const Face face : all_[t].neighbor) {
      const std::uint32_t other = face / 4;
      const Estimate estimated = all_.estimate(other, q);
      if (estimated.value > estimated.error) {
        if (!owns_beyond(face)) refusal = InsertionResult::not_owned;
        return other;
      }
      const double other_power = power_of(other, estimated.value);
      if (!(other_power < power)) continue;
      if (!owns_beyond(face)) {
        is_stopped = true;
        continue;
      }
      power = other_power;
      best = other;
    }
    if (best == t) {
      if (!is_stopped) return locate_exactly(t, v, refusal);  // rounded powers or a tie ended the walk
      refusal = InsertionResult::not_reached;
      return t;
    }
    t = best;
  }
}

/// Returns a tetrahedron as locate() does, by exact orientations. The walk ends because the exact power decreases.
template <bool weighted>
std::uint32_t BasicInserter<weighted>::locate_exactly(std::uint32_t t, Vertex v, InsertionResult& refusal) const {
  while (true) {
    const Tetrahedron& tetrahedron = all_[t];
    const auto& corner = tetrahedron.corner;
    std::size_t next = 4;
    if (tetrahedron.is_ghost()) {
      if (all_.is_inside(t, v, all_.estimate(t, all_.vertices()[v]))) return t;
      next = corner[0] == at_infinity ? 0 : corner[1] == at_infinity ? 1 : 2;
    } else {
      for (std::size_t k = 0; k < 4 && next == 4; ++k) {
        const auto& face = outer_faces[k];
        if (orientation(all_.point(corner[face[0]]), all_.point(corner[face[1]]), all_.point(corner[face[2]]),
                        all_.point(v)) > 0)
          next = k;
      }
      // The point is in the tetrahedron but is no corner of it, and thus inside of the sphere; a ball may be hidden.
      if (next == 4) return t;
    }
    if (!owns_beyond(tetrahedron.neighbor[next])) {
      refusal = InsertionResult::not_reached;
      return t;
    }
    const bool was_ghost = tetrahedron.is_ghost();
    t = tetrahedron.neighbor[next] / 4;
    if (!was_ghost && all_[t].is_ghost()) return t;  // the point is beyond the face of the ghost
  }
}

/// Finds the cavity, and marks its tetrahedra as deleted. Returns false, in the middle of the search, if a tetrahedron
/// of the cavity has other owners.
template <bool weighted>
bool BasicInserter<weighted>::find_cavity(std::uint32_t first, Vertex v) {
  const VertexData q = all_.vertices()[v];
  ErrorBound* const error = all_.errors();
  cavity_.clear();
  boundary_.clear();
  level_.clear();
  cavity_.make_room(1);
  cavity_.push(first);
  error[first] = error[first].marked_if(true);
  level_.make_room(4);
  for (const Face face : all_[first].neighbor) level_.push(face);
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
    for (std::size_t i = 0; i < count; ++i) estimates_.push(all_.estimate(level_[i] / 4, q));
    for (std::size_t i = 0; i < count; ++i) {
      const Face face = level_[i];
      const std::uint32_t t = face / 4;
      const Estimate& estimated = estimates_[i];
      const bool is_new = !error[t].is_deleted();
      bool is_in = estimated.value > estimated.error;
      if (!(std::abs(estimated.value) > estimated.error)) [[unlikely]]
        is_in = is_new && all_.decide(t, v, estimated);
      const bool is_taken = is_new & is_in;
      if (owner_ != nullptr && is_taken & !owns_corner(all_[t].corner[face % 4])) [[unlikely]]
        return false;
      const auto& neighbor = all_[t].neighbor;
      boundary_.push_if(is_new & !is_in, face);
      cavity_.push_if(is_taken, t);
      error[t] = error[t].marked_if(is_taken);
      next_level_.push_if(is_taken, {neighbor[(face + 1) % 4], neighbor[(face + 2) % 4], neighbor[(face + 3) % 4]});
    }
    std::swap(level_, next_level_);
  }
  return true;
}

/// Takes the marks of find_cavity() away.
template <bool weighted>
void BasicInserter<weighted>::give_up_cavity() {
  ErrorBound* const error = all_.errors();
  while (!cavity_.empty()) {
    const std::uint32_t t = cavity_.pop();
    error[t] = error[t].marked_if(true);
  }
}

/// Ensures that there are free tetrahedra for the faces of the boundary, in addition to those of the cavity. Returns
/// false if there are none in the room that several inserters share.
template <bool weighted>
bool BasicInserter<weighted>::make_room() {
  constexpr std::uint32_t at_a_time = 128;
  while (cavity_.size() + free_.size() < boundary_.size()) {
    std::uint32_t first;
    if (owner_ == nullptr)
      first = all_.add(at_a_time);
    else if (!all_.add_in_room(at_a_time, first))
      return false;
    free_.make_room(at_a_time);
    for (std::uint32_t i = at_a_time; i-- > 0;) free_.push(first + i);
  }
  return true;
}

template <bool weighted>
inline void BasicInserter<weighted>::add_spoke(Vertex corner, const VertexData& from) {
  rim_.push(corner);
  const VertexData& p = all_.vertices()[corner];
  const auto spoke = [&](auto... weight) { return AnySpoke::to(p.x - from.x, p.y - from.y, p.z - from.z, weight...); };
  if constexpr (weighted)
    spokes_.push(corner == at_infinity ? AnySpoke::to_infinity() : spoke(weight_difference(p.radius, from.radius)));
  else
    spokes_.push(corner == at_infinity ? AnySpoke::to_infinity() : spoke());
}

/// Returns the number of a corner among the vertices of the cavity's boundary; adds a new corner to rim_.
template <bool weighted>
inline std::uint32_t BasicInserter<weighted>::number_of(Vertex corner, Vertex v) {
  VertexData& p = corner == at_infinity ? infinity_ : all_.vertices()[corner];
  if (p.last_insertion != v) {
    p.last_insertion = v;
    p.local = static_cast<std::uint32_t>(rim_.size());
    add_spoke(corner, all_.vertices()[v]);
  }
  return p.local;
}

/// Makes a tetrahedron for each face of the boundary, in place of the cavity's, then of free ones.
template <bool weighted>
void BasicInserter<weighted>::fill_cavity(Vertex v) {
  const std::size_t faces = boundary_.size();
  rim_.clear();
  spokes_.clear();
  locals_.clear();
  rim_.make_room(faces + 2);  // the boundary is a sphere: it has faces / 2 + 2 vertices
  spokes_.make_room(faces + 2);
  locals_.make_room(faces);
  Tetrahedron* const tetrahedra = all_.all();
  for (std::size_t i = 0; i < faces; ++i) {
    const auto& corner = tetrahedra[boundary_[i] / 4].corner;
    const auto& order = outer_faces[boundary_[i] % 4];
    locals_.push({number_of(corner[order[0]], v), number_of(corner[order[1]], v), number_of(corner[order[2]], v)});
  }
  cavity_.make_room(faces);
  while (cavity_.size() < faces) cavity_.push(free_.pop());
  free_.make_room(cavity_.size() - faces);
  while (cavity_.size() > faces) free_.push(cavity_.pop());
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
    tetrahedra[t].corner[3] = v;
    make(t, locals_[i]);
    tetrahedra[t].neighbor = {edges_.get(c, b), edges_.get(a, c), edges_.get(b, a), boundary_[i]};
    tetrahedra[boundary_[i] / 4].neighbor[boundary_[i] % 4] = 4 * t + 3;
  }
  last_ = cavity_[0];
}

/// Fills in corners 0 to 2 of tetrahedron t, its minors, and its error bound.
template <bool weighted>
inline void BasicInserter<weighted>::make(std::uint32_t t, const Locals& locals) {
  const AnySpoke &a = spokes_[locals[0]], &b = spokes_[locals[1]], &c = spokes_[locals[2]];
  Tetrahedron& tetrahedron = all_.all()[t];
  tetrahedron.minor = sphere_minors(a, b, c);
  for (std::size_t k = 0; k < 3; ++k) tetrahedron.corner[k] = rim_[locals[k]];
  const double underflow = all_.underflow();
  all_.errors()[t] = tetrahedron.is_ghost() ? half_space_error(a, b, c, underflow) : sphere_error(a, b, c, underflow);
}

template class BasicInserter<false>;
template class BasicInserter<true>;

}  // namespace rbpa::space
