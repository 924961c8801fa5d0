#include "space/surface/model.h"

#include <algorithm>

#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/resting_ball.h"

namespace rbpa_test {
namespace {

namespace exact = rbpa::space::exact;

}  // namespace

std::vector<std::uint32_t> distinct_of(const Points3& points) {
  std::vector<std::uint32_t> distinct;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (std::find(points.begin(), points.begin() + i, points[i]) == points.begin() + i) distinct.push_back(i);
  return distinct;
}

std::set<Triangle> exposed_by_definition(const Points3& points, double radius) {
  const std::vector<std::uint32_t> distinct = distinct_of(points);
  std::set<Triangle> found;
  for (const std::uint32_t a : distinct)
    for (const std::uint32_t b : distinct)
      for (const std::uint32_t c : distinct) {
        if (!(a < b && a < c && b != c)) continue;
        const rbpa::space::RestingBall<long double> ball(points[a], points[b], points[c], radius);
        if (ball.rests() && std::none_of(distinct.begin(), distinct.end(), [&](std::uint32_t q) {
              return q != a && q != b && q != c && ball.contains(points[q]);
            }))
          found.insert({a, b, c});
      }
  return found;
}

bool disagrees(const Points3& points, const Points3& normals, const Triangle& t, std::size_t k) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i] == points[t[k]] && exact::normal_sign(points[t[0]], points[t[1]], points[t[2]], normals[i]) <= 0)
      return true;
  return false;
}

bool agrees(const Points3& points, const Points3& normals, const Triangle& t) {
  return !disagrees(points, normals, t, 0) && !disagrees(points, normals, t, 1) && !disagrees(points, normals, t, 2);
}

bool is_nearer(const Points3& points, std::uint32_t from, std::uint32_t to, std::uint32_t apex, std::uint32_t other,
               std::uint32_t third) {
  // Quarters of a turn from the apex, counter-clockwise about the direction of the side; a full turn for the apex
  // itself.
  const auto half = [&](std::uint32_t p) {
    return p == apex ? 2 : -exact::orientation(points[from], points[to], points[apex], points[p]);
  };
  if (half(other) != half(third)) return half(other) < half(third);
  return exact::orientation(points[from], points[to], points[other], points[third]) > 0;
}

Triangle next_by_definition(const Points3& points, const std::set<Triangle>& exposed, const Triangle& t,
                            std::size_t k) {
  const std::uint32_t from = t[(k + 1) % 3], to = t[(k + 2) % 3];
  const Triangle* best = nullptr;
  std::uint32_t best_apex = 0;
  for (const Triangle& other : exposed)
    for (std::size_t j = 0; j < 3; ++j) {
      if (other[(j + 1) % 3] != to || other[(j + 2) % 3] != from) continue;
      if (best != nullptr && !is_nearer(points, from, to, t[k], other[j], best_apex)) continue;
      best = &other;
      best_apex = other[j];
    }
  return *best;
}

const Triangle* ModelSurface::neighbor(const Triangle& triangle, std::size_t k) const {
  const auto found = glued_.find({triangle, k});
  return found == glued_.end() ? nullptr : &found->second.first;
}

bool ModelSurface::is_interior_edge(std::uint32_t a, std::uint32_t b) const {
  return std::any_of(glued_.begin(), glued_.end(), [&](const auto& pair) {
    const auto& [triangle, k] = pair.first;
    return std::minmax(triangle[(k + 1) % 3], triangle[(k + 2) % 3]) == std::minmax(a, b);
  });
}

bool ModelSurface::is_interior_point(std::uint32_t point) const {
  for (const auto& [first, level] : levels_)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (first[corner] != point) continue;
      Triangle at = first;
      std::size_t k = corner;
      while (const Triangle* next = neighbor(at, (k + 1) % 3)) {
        at = *next;
        k = static_cast<std::size_t>(std::find(at.begin(), at.end(), point) - at.begin());
        if (at == first) return true;
      }
    }
  return false;
}

void ModelSurface::add(double radius) {
  const std::set<Triangle> exposed = exposed_by_definition(points_, radius);
  std::set<Triangle> candidates;
  for (const Triangle& t : exposed) {
    if (!agrees(points_, normals_, t) || levels_.count(t) > 0) continue;
    bool is_free = true;
    for (std::size_t k = 0; k < 3; ++k)
      is_free = is_free && !is_interior_point(t[k]) && !is_interior_edge(t[k], t[(k + 1) % 3]);
    if (is_free) candidates.insert(t);
  }
  // All sides that are not glued yet, each with the one that it faces.
  std::vector<Side> sides;
  for (const auto& [t, level] : levels_)
    for (std::size_t k = 0; k < 3; ++k)
      if (neighbor(t, k) == nullptr) sides.emplace_back(t, k);
  for (const Triangle& t : candidates)
    for (std::size_t k = 0; k < 3; ++k) sides.emplace_back(t, k);
  std::vector<std::pair<Side, Side>> found;  // pairs between which the turn contains both positive sides
  for (const Side& s : sides) {
    const auto& [t, k] = s;
    const std::uint32_t from = t[(k + 1) % 3], to = t[(k + 2) % 3];
    const Side* nearest = nullptr;
    for (const Side& other : sides) {
      const auto& [u, j] = other;
      const std::uint32_t begin = u[(j + 1) % 3], end = u[(j + 2) % 3];
      if (other == s || std::minmax(begin, end) != std::minmax(from, to)) continue;
      if (nearest == nullptr || is_nearer(points_, from, to, t[k], u[j], nearest->first[nearest->second]))
        nearest = &other;
    }
    if (nearest == nullptr || nearest->first[(nearest->second + 1) % 3] != to) continue;
    const Triangle& u = nearest->first;
    const bool both_old = levels_.count(t) > 0 && levels_.count(u) > 0;
    const bool both_exposed = exposed.count(t) > 0 && exposed.count(u) > 0;
    if (both_old || (both_exposed && next_by_definition(points_, exposed, t, k) != u)) continue;
    found.emplace_back(s, *nearest);
  }
  for (const auto& [s, other] : found) {
    glued_[s] = other;
    glued_[other] = s;
  }
  for (const Triangle& t : candidates) levels_[t] = next_level_;
  ++next_level_;
}

bool is_model(const rbpa::Surface& surface, const ModelSurface& model) {
  if (surface.triangles.size() != model.levels().size()) return false;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto found = model.levels().find(surface.triangles[t]);
    if (found == model.levels().end() || found->second != surface.levels[t]) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle* expected = model.neighbor(surface.triangles[t], k);
      const std::uint32_t other = surface.neighbors[t][k];
      if ((expected == nullptr) != (other == rbpa::Surface::none)) return false;
      if (expected != nullptr && *expected != surface.triangles[other]) return false;
    }
  }
  return true;
}

}  // namespace rbpa_test
