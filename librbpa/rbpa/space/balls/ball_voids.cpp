#include "rbpa/space/balls/ball_voids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/grouped.h"
#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/full/orthoball.h"
#include "rbpa/space/balls/full/outside_of_balls.h"
#include "rbpa/space/balls/full/slices.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/predicate/outer_faces.h"
#include "rbpa/space/predicate/spread.h"

namespace rbpa {
namespace {

using space::Ball;
constexpr std::uint32_t none = RegularTriangulation::none;

/// The triangle of a tetrahedron across from one of its corners.
struct Face {
  std::uint32_t tetrahedron;
  std::uint8_t across;
};

class Finder {
 public:
  Finder(std::span<const Point3> centers, std::span<const double> radii, const RegularTriangulation& regular,
         const BallVoidsOptions& options)
      : centers_(centers),
        radii_(radii),
        regular_(regular),
        go_on_(go_on_of(options.progress, centers.size())),
        threads_(threads_for(centers.size(), options.threads)),
        cells_(centers, regular),
        faces_(cells_, radii, threads_, go_on_),
        stars_(cells_),
        scale_(space::spread(centers, radii)),
        scaled_centers_(space::scaled(centers, scale_, copy_of_centers_)),
        scaled_radii_(space::scaled(radii, scale_, copy_of_radii_)),
        power_cells_{{}, regular.simplices, stars_},
        is_outside_(regular.simplices.size(), 0) {
    for (std::size_t i = 0; i < centers.size(); ++i)
      power_cells_.balls.push_back({scaled_centers_[i], scaled_radii_[i]});
    find_outside(options.pockets);
  }

  BallVoids find() {
    std::vector<BallVoid> all = regions();
    const space::RegionMeasures measures =
        space::outside_of_balls({cells_, scaled_centers_, scaled_radii_, region_, all.size(),
                                 [&](std::uint32_t t, std::size_t k) { return faces_.has_triangle(t, k); },
                                 [&](std::span<const space::EdgeAt> ring) { return faces_.has_edge(ring); },
                                 [&](std::uint32_t i) { return has_vertex(i); }},
                                threads_, go_on_);
    for (const space::RegionShare& share : measures.shares)
      all[share.region].balls.push_back({share.ball, unscaled(share.area, 2)});
    CheckpointOfThreads checkpoint(go_on_);
    for_each_index(threads_, all.size(), [&](std::size_t i) {
      checkpoint();
      BallVoid& of = all[i];
      of.volume_of_tetrahedra = unscaled(measures.all[i].tetrahedra, 3);
      of.volume = unscaled(measures.all[i].volume, 3);
      of.area = unscaled(measures.all[i].area, 2);
      const std::vector<std::uint32_t> around = corners(of);
      find_mouths(of, around);
      if (of.mouths.empty()) {  // rounding may leave sizes just below 0
        of.volume = std::max(of.volume, 0.0);
        for (LiningBall& ball : of.balls) ball.area = std::max(ball.area, 0.0);
      }
      find_largest_ball(of, around);
    });
    return sorted(std::move(all));
  }

 private:
  Ball ball(std::uint32_t t, std::size_t k) const { return {cells_.position(t, k), radii_[regular_.simplices[t][k]]}; }
  double unscaled(double value, int degree) const { return std::ldexp(value, -degree * scale_.exponent); }
  Point3 unscaled(const Point3& p) const { return {unscaled(p.x, 1), unscaled(p.y, 1), unscaled(p.z, 1)}; }
  std::uint32_t beyond(const Face& face) const { return regular_.neighbors[face.tetrahedron][face.across]; }
  bool is_open(const Face& face) const { return !faces_.has_triangle(face.tetrahedron, face.across); }
  Triangle corners(const Face& face) const {
    return space::outer_face(regular_.simplices[face.tetrahedron], face.across);
  }

  /// Returns whether the orthocenter of a tetrahedron is beyond a face of it.
  bool flows(const Face& face) const {
    const auto [a, b, c] = space::outer_faces[face.across];
    const std::uint32_t t = face.tetrahedron;
    return space::is_conflict(ball(t, a), ball(t, b), ball(t, c), ball(t, face.across));
  }

  /// Marks the tetrahedra that are connected to infinity through triangles outside of the complex; if `by_flow`, only
  /// tetrahedra that flow to infinity.
  void find_outside(bool by_flow) {
    std::vector<std::uint32_t> found;
    Steps step(go_on_);
    const auto add = [&](const Face& face) {
      step();
      if (is_outside_[face.tetrahedron] != 0 || !is_open(face) || (by_flow && !flows(face))) return;
      is_outside_[face.tetrahedron] = 1;
      found.push_back(face.tetrahedron);
    };
    for (std::uint32_t t = 0; t < regular_.simplices.size(); ++t)
      for (std::uint8_t k = 0; k < 4; ++k)
        if (faces_.is_on_hull(t, k)) add({t, k});
    while (!found.empty()) {
      const std::uint32_t t = found.back();
      found.pop_back();
      for (const std::uint32_t other : regular_.neighbors[t])
        if (other != none)
          for (std::uint8_t k = 0; k < 4; ++k)
            if (regular_.neighbors[other][k] == t) add({other, k});
    }
  }

  /// Returns the regions with their tetrahedra, in the order of the first tetrahedron of each.
  std::vector<BallVoid> regions() {
    const auto count = static_cast<std::uint32_t>(regular_.simplices.size());
    const auto is_in = [&](std::uint32_t t) { return is_outside_[t] == 0 && !faces_.has_tetrahedron(t); };
    meshops::DisjointSets sets(count);
    Steps step(go_on_);
    for (std::uint32_t t = 0; t < count; ++t)
      for (std::uint8_t k = 0; k < 4; ++k) {
        step();
        const std::uint32_t other = regular_.neighbors[t][k];
        if (other != none && t < other && is_in(t) && is_in(other) && is_open({t, k})) sets.join(t, other);
      }
    const space::Grouped groups(count, count, [&](std::uint32_t t) { return is_in(t) ? sets.find(t) : none; });
    region_ = groups.number();
    std::vector<BallVoid> all(groups.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i].tetrahedra.assign(groups.items(i).begin(), groups.items(i).end());
    return all;
  }

  /// Returns the scaled balls at the corners of a triangle or tetrahedron.
  template <std::size_t corners>
  std::array<Ball, corners> balls_of(const std::array<std::uint32_t, corners>& simplex) const {
    std::array<Ball, corners> balls{};
    for (std::size_t k = 0; k < corners; ++k) balls[k] = power_cells_.balls[simplex[k]];
    return balls;
  }

  /// Returns whether x, in scaled coordinates, is outside of all balls and in the region. Fast if `near` is near.
  bool is_free(const Point3& x, std::uint32_t near, std::uint32_t region) const {
    if (!(power_cells_.power(x, power_cells_.ball_at(x, near)) > 0)) return false;
    std::uint32_t t = stars_[near].front();
    for (std::uint8_t k = 0; k < 4 && t != none;) {
      const auto [a, b, c] = corners(Face{t, k});
      const bool is_beyond = space::orientation(scaled_centers_[a], scaled_centers_[b], scaled_centers_[c], x) > 0;
      if (is_beyond) t = regular_.neighbors[t][k];
      k = is_beyond ? 0 : static_cast<std::uint8_t>(k + 1);
    }
    return t != none && region_[t] == region;
  }

  /// Returns the balls at corners of simplices, ascending.
  template <typename Simplices>
  static std::vector<std::uint32_t> corners_of(const Simplices& simplices) {
    std::vector<std::uint32_t> all;
    for (const auto& simplex : simplices) all.insert(all.end(), simplex.begin(), simplex.end());
    sort_unique(all);
    return all;
  }
  static std::vector<std::uint32_t> corners(const BallMouth& of) { return corners_of(of.triangles); }
  std::vector<std::uint32_t> corners(const BallVoid& of) const {
    std::vector<std::array<std::uint32_t, 4>> rows;
    for (const std::uint32_t t : of.tetrahedra) rows.push_back(regular_.simplices[t]);
    return corners_of(rows);
  }

  /// Tries orthocenters and touching balls, until the triangulation of the balls grown by the best radius found has no
  /// orthocenter of positive power in the void.
  void find_largest_ball(BallVoid& of, std::span<const std::uint32_t> around) const {
    std::vector<Point3> centers;
    std::vector<double> radii;
    for (const std::uint32_t i : around) {
      centers.push_back(scaled_centers_[i]);
      radii.push_back(scaled_radii_[i]);
    }
    Ball best;
    const auto consider = [&](const std::array<Ball, 4>& balls, std::uint32_t near, double grown) {
      const space::Orthoball found = space::orthoball(balls);
      for (const Point3& x : {found.touching.center, found.center}) {
        if (!(found.power > 0) || !is_finite(x)) continue;
        double radius = std::numeric_limits<double>::infinity();
        for (const Ball& ball : balls) radius = std::min(radius, space::distance(x, ball.center) - ball.radius + grown);
        if (radius <= best.radius || !is_free(x, near, region_[of.tetrahedra.front()])) continue;
        for (std::size_t i = 0; i < radii.size(); ++i)
          radius = std::min(radius, space::distance(x, centers[i]) - radii[i]);
        if (radius > best.radius) best = {x, radius};
      }
      return found.power;
    };
    for (const std::uint32_t t : of.tetrahedra)
      of.power =
          std::max(of.power, unscaled(consider(balls_of(regular_.simplices[t]), regular_.simplices[t][0], 0), 2));
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

  bool has_edge(std::uint32_t a, std::uint32_t b) const {
    std::vector<space::EdgeAt> ring;
    for (const std::uint32_t t : stars_[a]) {
      const auto& row = regular_.simplices[t];
      const auto place = [&](std::uint32_t i) {
        return static_cast<std::uint8_t>(std::find(row.begin(), row.end(), i) - row.begin());
      };
      if (place(b) < 4) ring.push_back({t, place(a), place(b)});
    }
    return faces_.has_edge(ring);
  }

  bool has_vertex(std::uint32_t i) const {
    for (const std::uint32_t t : stars_[i])
      for (const std::uint32_t other : regular_.simplices[t])
        if (other != i && has_edge(i, other)) return true;
    return space::is_center_in_cell(cells_, radii_, i, stars_[i]);
  }

  void find_mouths(BallVoid& of, std::span<const std::uint32_t> around) const {
    std::vector<Face> open;
    for (const std::uint32_t t : of.tetrahedra)
      for (std::uint8_t k = 0; k < 4; ++k)
        if (is_open({t, k}) && (faces_.is_on_hull(t, k) || is_outside_[beyond({t, k})] != 0)) open.push_back({t, k});
    meshops::DisjointSets sets(open.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first_at;  // first triangle at each edge
    for (std::uint32_t i = 0; i < open.size(); ++i) {
      const Triangle triangle = corners(open[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto edge = std::minmax(triangle[k], triangle[(k + 1) % 3]);
        const auto [at, is_new] = first_at.emplace(edge, i);
        if (!is_new && !has_edge(edge.first, edge.second)) sets.join(at->second, i);
      }
    }
    const space::Grouped mouths(open.size(), open.size(), [&](std::uint32_t i) { return sets.find(i); });
    for (std::size_t i = 0; i < mouths.size(); ++i) {
      BallMouth& mouth = of.mouths.emplace_back(measured(of, open, mouths.items(i)));
      mouth.radius = std::numeric_limits<double>::infinity();
      for (const std::uint32_t ball : around)
        mouth.radius = std::clamp(space::distance(mouth.center, centers_[ball]) - radii_[ball], 0.0, mouth.radius);
    }
    std::sort(of.mouths.begin(), of.mouths.end(),
              [&](const BallMouth& a, const BallMouth& b) { return is_before(a.power, a, b.power, b); });
  }

  BallMouth measured(const BallVoid& of, std::span<const Face> open, std::span<const std::uint32_t> items) const {
    BallMouth mouth;
    for (const std::uint32_t i : items) {
      const Triangle triangle = from_least(corners(open[i]));
      mouth.triangles.push_back(triangle);
      const space::Slice slice = power_cells_.slice(triangle);
      mouth.area_of_triangles += unscaled(slice.area, 2);
      mouth.area += unscaled(slice.outside, 2);
      mouth.perimeter += unscaled(slice.perimeter, 1);
      const space::Orthoball closing = closing_ball(open[i]);
      if (const double power = unscaled(closing.power, 2); power > mouth.power) {
        mouth.power = power;
        mouth.center = unscaled(is_finite(closing.touching.center) ? closing.touching.center : closing.center);
      }
    }
    std::sort(mouth.triangles.begin(), mouth.triangles.end());
    mouth.balls = corners(mouth);
    std::erase_if(mouth.balls, [&](std::uint32_t i) {
      return std::none_of(of.balls.begin(), of.balls.end(), [&](const LiningBall& ball) { return ball.ball == i; });
    });
    return mouth;
  }

  /// Returns the orthoball of the simplex with which a triangle of a mouth comes into the complex: the triangle itself,
  /// or the tetrahedron outside if it flows into the pocket.
  space::Orthoball closing_ball(const Face& face) const {
    const std::uint32_t outside = beyond(face);
    if (outside != none) {
      const auto& back = regular_.neighbors[outside];
      const auto k = std::find(back.begin(), back.end(), face.tetrahedron) - back.begin();
      if (flows({outside, static_cast<std::uint8_t>(k)}))
        return space::orthoball(balls_of(regular_.simplices[outside]));
    }
    return space::orthoball(balls_of(corners(face)));
  }

  /// Returns whether an item comes before another one: by descending size, then by the coordinates of its corners.
  template <typename Item>
  bool is_before(double size, const Item& item, double other_size, const Item& other) const {
    if (size != other_size) return size > other_size;
    const auto key = [&](const Item& of) {
      std::vector<Point3> points;
      for (const std::uint32_t i : corners(of)) points.push_back(centers_[i]);
      std::sort(points.begin(), points.end());
      return points;
    };
    return key(item) < key(other);
  }

  BallVoids sorted(std::vector<BallVoid> all) const {
    std::sort(all.begin(), all.end(), [&](const BallVoid& a, const BallVoid& b) {
      return is_before(a.volume_of_tetrahedra, a, b.volume_of_tetrahedra, b);
    });
    BallVoids result;
    for (BallVoid& of : all) {
      if (of.mouths.empty()) {
        result.volume += of.volume;
        result.area += of.area;
      }
      (of.mouths.empty() ? result.voids : result.pockets).push_back(std::move(of));
    }
    return result;
  }

  std::span<const Point3> centers_;
  std::span<const double> radii_;
  const RegularTriangulation& regular_;
  GoOn go_on_;
  Threads threads_;
  space::Triangulated cells_;
  space::FacesWithin faces_;
  space::PointStars stars_;
  space::Spread scale_;
  std::vector<Point3> copy_of_centers_;
  std::vector<double> copy_of_radii_;
  std::span<const Point3> scaled_centers_;
  std::span<const double> scaled_radii_;
  space::PowerCells power_cells_;
  std::vector<std::uint8_t> is_outside_;
  std::vector<std::uint32_t> region_;  // region of each tetrahedron
};

}  // namespace

BallVoids ball_voids(std::span<const Point3> centers, std::span<const double> radii,
                     const RegularTriangulation& regular, const BallVoidsOptions& options) {
  meshops::require_one_each("ball_voids", radii.size(), "radii", centers.size(), "centers");
  meshops::require(regular.neighbors.size() == regular.simplices.size(),
                   "ball_voids: the triangulation has no neighbors, expected regular_triangulation() with neighbors");
  for (const auto& row : regular.simplices)
    for (const std::uint32_t corner : row)
      meshops::require(corner < centers.size(), "ball_voids: a corner of the triangulation is no ball");
  return Finder(centers, radii, regular, options).find();
}

std::vector<Triangle> boundary_of(const BallVoid& hollow, const RegularTriangulation& regular) {
  std::vector<Triangle> triangles;
  for (const std::uint32_t t : hollow.tetrahedra)
    for (std::size_t k = 0; k < 4; ++k)
      if (!std::binary_search(hollow.tetrahedra.begin(), hollow.tetrahedra.end(), regular.neighbors[t][k]))
        triangles.push_back(space::outer_face(regular.simplices[t], k));
  return triangles;
}

}  // namespace rbpa
