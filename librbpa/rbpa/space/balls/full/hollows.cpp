#include "rbpa/space/balls/full/hollows.h"

#include <algorithm>
#include <limits>

#include "rbpa/space/balls/full/orthoball.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/predicate/outer_faces.h"

namespace rbpa::space {

Hollows::Hollows(std::span<const Point3> centers, std::span<const double> radii, const RegularTriangulation& regular,
                 Threads& threads, const GoOn& go_on)
    : radii_(radii),
      cells_(centers, regular),
      faces_(cells_, radii, threads, go_on),
      stars_(cells_),
      scale_(spread(centers, radii)),
      scaled_centers_(scaled(centers, scale_, copy_of_centers_)),
      scaled_radii_(scaled(radii, scale_, copy_of_radii_)),
      power_cells_{{}, cells_.simplices, stars_} {
  for (std::size_t i = 0; i < centers.size(); ++i) power_cells_.balls.push_back({scaled_centers_[i], scaled_radii_[i]});
}

bool Hollows::has_edge(std::uint32_t a, std::uint32_t b) const {
  std::vector<EdgeAt> ring;
  for (const std::uint32_t t : stars_[a]) {
    const auto& row = cells_.simplices[t];
    const auto place = [&](std::uint32_t i) {
      return static_cast<std::uint8_t>(std::find(row.begin(), row.end(), i) - row.begin());
    };
    if (place(b) < 4) ring.push_back({t, place(a), place(b)});
  }
  return faces_.has_edge(ring);
}

bool Hollows::has_vertex(std::uint32_t i) const {
  for (const std::uint32_t t : stars_[i])
    for (const std::uint32_t other : cells_.simplices[t])
      if (other != i && has_edge(i, other)) return true;
  return is_center_in_cell(cells_, radii_, i, stars_[i]);
}

RegionMeasures Hollows::measure(std::span<const std::uint32_t> region, std::size_t count, Threads& threads,
                                const GoOn& go_on) const {
  RegionMeasures measures = outside_of_balls({cells_, scaled_centers_, scaled_radii_, region, count,
                                              [&](std::uint32_t t, std::size_t k) { return faces_.has_triangle(t, k); },
                                              [&](std::span<const EdgeAt> ring) { return faces_.has_edge(ring); },
                                              [&](std::uint32_t i) { return has_vertex(i); }},
                                             threads, go_on);
  for (RegionMeasure& of : measures.all)
    of = {unscaled(of.tetrahedra, 3), unscaled(of.volume, 3), unscaled(of.area, 2)};
  for (RegionShare& share : measures.shares) {
    share.area = unscaled(share.area, 2);
    share.volume = unscaled(share.volume, 3);
  }
  return measures;
}

/// Returns whether x, in scaled coordinates, is outside of all balls and in the region. Fast if `near` is near.
bool Hollows::is_free(const Point3& x, std::uint32_t near, std::uint32_t is_in,
                      std::span<const std::uint32_t> region) const {
  if (!(power_cells_.power(x, power_cells_.ball_at(x, near)) > 0)) return false;
  std::uint32_t t = stars_[near].front();
  for (std::uint8_t k = 0; k < 4 && t != Solid::none;) {
    const auto [a, b, c] = outer_face(cells_.simplices[t], k);
    const bool is_beyond = orientation(scaled_centers_[a], scaled_centers_[b], scaled_centers_[c], x) > 0;
    if (is_beyond) t = cells_.neighbors[t][k];
    k = is_beyond ? 0 : static_cast<std::uint8_t>(k + 1);
  }
  return t != Solid::none && region[t] == is_in;
}

/// Tries orthocenters and touching balls, until the triangulation of the balls grown by the best radius found has no
/// orthocenter of positive power in the void.
void Hollows::find_largest_ball(BallVoid& of, std::span<const std::uint32_t> around,
                                std::span<const std::uint32_t> region) const {
  std::vector<Point3> centers;
  std::vector<double> radii;
  for (const std::uint32_t i : around) {
    centers.push_back(scaled_centers_[i]);
    radii.push_back(scaled_radii_[i]);
  }
  Ball best;
  const auto consider = [&](const std::array<Ball, 4>& balls, std::uint32_t near, double grown) {
    const Orthoball found = orthoball(balls);
    for (const Point3& x : {found.touching.center, found.center}) {
      if (!(found.power > 0) || !is_finite(x)) continue;
      double radius = std::numeric_limits<double>::infinity();
      for (const Ball& ball : balls) radius = std::min(radius, distance(x, ball.center) - ball.radius + grown);
      if (radius <= best.radius || !is_free(x, near, region[of.tetrahedra.front()], region)) continue;
      for (std::size_t i = 0; i < radii.size(); ++i) radius = std::min(radius, distance(x, centers[i]) - radii[i]);
      if (radius > best.radius) best = {x, radius};
    }
    return found.power;
  };
  for (const std::uint32_t t : of.tetrahedra)
    of.power = std::max(of.power, unscaled(consider(scaled_balls(cells_.simplices[t]), cells_.simplices[t][0], 0), 2));
  for (double grown = -1; best.radius > grown * (1 + 0x1p-40);) {
    grown = best.radius;
    std::vector<double> wider = radii;
    for (double& radius : wider) radius += grown;
    for (const auto& row : regular_triangulation(centers, wider, {.neighbors = false, .threads = 1}).simplices) {
      std::array<Ball, 4> balls{};
      for (std::size_t k = 0; k < 4; ++k) balls[k] = {centers[row[k]], wider[row[k]]};
      consider(balls, around[row[0]], grown);
    }
  }
  of.center = unscaled(best.center);
  of.radius = unscaled(best.radius, 1);
}

}  // namespace rbpa::space
