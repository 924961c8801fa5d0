#include "rbpa/hierarchy/local_triangles.h"

#include <algorithm>
#include <cmath>

#include "rbpa/hierarchy/circumradius.h"

namespace rbpa {

LocalTriangles::LocalTriangles(std::span<const Point> points, const Ladder<double>& ladder)
    : points_(points), ladder_(ladder) {
  seams_.begin(points.size());
  corners_.reserve(2 * points.size());
  across_.reserve(2 * points.size());
  level_.reserve(2 * points.size());
}

void LocalTriangles::add(const meshops::Patch& patch) {
  const auto base = static_cast<int>(3 * corners_.size());
  corners_.insert(corners_.end(), patch.triangles.begin(), patch.triangles.end());
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    level_.push_back(static_cast<std::uint16_t>(level_of(patch.triangles[t])));
    auto& across = across_.emplace_back(patch.across[t]);
    for (int i = 0; i < 3; ++i) {
      int& beyond = across[static_cast<std::size_t>(i)];
      if (beyond >= 0) {
        beyond += base;
        continue;
      }
      const int side = 3 * (static_cast<int>(across_.size()) - 1) + i;
      beyond = seams_.take(to(side), [&](int other) { return to(other) == from(side); }).value_or(none);
      if (beyond >= 0)
        across_[static_cast<std::size_t>(beyond) / 3][static_cast<std::size_t>(beyond) % 3] = side;
      else
        seams_.add(from(side), side);
    }
  }
}

/// The first level whose radius admits the triangle; one behind the last when none does.
int LocalTriangles::level_of(const std::array<meshops::Site, 3>& corners) const {
  using P = Predicates<double>;
  const Point &a = points_[static_cast<std::size_t>(corners[0])], &b = points_[static_cast<std::size_t>(corners[1])],
              &c = points_[static_cast<std::size_t>(corners[2])];
  const auto ab = P::from(a, b), bc = P::from(b, c), ca = P::from(c, a);
  const double area = std::abs(P::cross(ab, ca));
  const double sides = P::dot(ab, ab) * P::dot(bc, bc) * P::dot(ca, ca);
  const double diameter = 2 * ladder_.least();
  // (R / α₀)², and how far it is from a power of four.
  const double ratio = sides / (area * area) / (diameter * diameter);
  int exponent;
  const double mantissa = std::frexp(ratio, &exponent);  // in [1/2, 1)
  constexpr double near = 1e-5;
  const bool is_clear = area > 1e7 * P::unit * P::cross_size(ab, ca) && mantissa > 0.5 + near && mantissa < 1 - near;
  if (is_clear && std::isfinite(ratio) && ratio > 0) {
    const int level = std::max(0, (exponent + 1) / 2);
    if (level < ladder_.end()) return level;
  }
  int level = std::min(ladder_.first_reaching(circumradius<double>(a, b, c)), ladder_.end());
  while (level <= ladder_.end() && !ladder_.radius(level).admits<double>(a, b, c)) {
    if (ladder_.is_last(level)) return ladder_.end() + 1;
    ++level;
  }
  return level;
}

void LocalTriangles::sort() {
  seams_.end();
  start_.assign(static_cast<std::size_t>(ladder_.end()) + 3, 0);
  for (const std::uint16_t level : level_) ++start_[level + 1u];
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
  order_.resize(level_.size());
  std::vector<std::uint32_t> next(start_);
  for (std::uint32_t t = 0; t < level_.size(); ++t) order_[next[level_[t]]++] = t;
  face_.assign(level_.size(), meshops::Face());
  seen_.assign(points_.size(), 0);
}

std::uint32_t LocalTriangles::first_of_level(int level) const {
  return start_[std::min(static_cast<std::size_t>(level), static_cast<std::size_t>(ladder_.end()) + 1)];
}

int LocalTriangles::next(int level) const {
  const std::uint32_t first = first_of_level(level);
  return first == first_of_level(ladder_.end() + 1) ? Ladder<double>::never : level_[order_[first]];
}

/// At how many of its corners the triangle is the first of its level.
std::size_t LocalTriangles::count_sites(std::uint32_t triangle, int level) {
  std::size_t sites = 0;
  for (const meshops::Site s : corners_[triangle]) {
    std::uint16_t& seen = seen_[static_cast<std::size_t>(s)];
    sites += seen != level + 1;
    seen = static_cast<std::uint16_t>(level + 1);
  }
  return sites;
}

/// Lays some triangles of the first level, in ascending order, as a patch.
std::size_t LocalTriangles::lay(std::span<const std::uint32_t> triangles, int level, meshops::Front& front) {
  const auto first = static_cast<int>(front.faces());
  for (std::size_t i = 0; i < triangles.size(); ++i) face_[triangles[i]] = meshops::Face(first + static_cast<int>(i));
  patch_.clear();
  std::size_t sites = 0;
  for (const std::uint32_t t : triangles) {
    sites += count_sites(t, level);
    patch_.triangles.push_back(corners_[t]);
    auto& across = patch_.across.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const int beyond = across_[t][i];
      const auto other = static_cast<std::size_t>(beyond) / 3;
      if (beyond == none || level_[other] > level)
        across[i] = meshops::Patch::nothing;
      else if (other < triangles.front() || other > triangles.back())
        across[i] = meshops::Patch::open;
      else
        across[i] = 3 * (face_[other].idx() - first) + beyond % 3;
    }
  }
  front.lay(patch_);
  return sites;
}

/// Tells of the triangle beyond a boundary halfedge, given the side there, or of none.
void LocalTriangles::remember(const meshops::Front& front, meshops::Halfedge h, int beyond,
                              Apexes<double>& apexes) const {
  apexes.remember(front, h, beyond == none ? std::nullopt : std::optional(apex_beyond(beyond)));
}

/// Tells of the triangles of later levels beyond the front that was laid. `first` is the number of the first face's
/// triangle in the order of levels.
void LocalTriangles::remember_frozen(std::uint32_t first, meshops::Front& front, Apexes<double>& apexes) const {
  for (const meshops::Halfedge h : front.frozen()) {
    const meshops::Halfedge side = front.mesh().opposite_halfedge_handle(h);
    const std::uint32_t t = order_[first + static_cast<std::uint32_t>(front.mesh().face_handle(side).idx())];
    const auto i = static_cast<std::size_t>(std::find(corners_[t].begin(), corners_[t].end(), front.from_site(side)) -
                                            corners_[t].begin());
    remember(front, h, across_[t][i], apexes);
  }
}

/// The corner of a triangle opposite to one of its sides.
std::uint32_t LocalTriangles::apex_beyond(int side) const {
  const auto s = static_cast<std::size_t>(side);
  return static_cast<std::uint32_t>(corners_[s / 3][(s + 2) % 3]);
}

std::size_t LocalTriangles::insert(std::uint32_t triangle, int level, meshops::Front& front, Apexes<double>& apexes) {
  const auto& corner = corners_[triangle];
  const auto& mesh = front.mesh();
  meshops::TriangleSides sides;
  for (std::size_t i = 0; i < 3; ++i) {
    const int beyond = across_[triangle][i];
    if (beyond == none) continue;
    if (const meshops::Face face = face_[static_cast<std::size_t>(beyond) / 3]; face.is_valid()) {
      meshops::Halfedge h = mesh.halfedge_handle(face);
      for (int k = beyond % 3; k > 0; --k) h = mesh.next_halfedge_handle(h);
      sides.side[i] = mesh.opposite_halfedge_handle(h);
    }
  }
  const meshops::InsertedTriangle inserted = front.insert(sides, corner[0], corner[1], corner[2]);
  face_[triangle] = inserted.face;
  for (std::size_t i = 0; i < 3; ++i) {
    if (sides.side[i].is_valid()) continue;
    const meshops::Halfedge h = mesh.opposite_halfedge_handle(inserted.side[i]);
    const int beyond = across_[triangle][i];
    if (beyond == none || level_[static_cast<std::size_t>(beyond) / 3] > level) {
      remember(front, h, beyond, apexes);
      front.freeze(h);
    }
  }
  return count_sites(triangle, level);
}

}  // namespace rbpa
