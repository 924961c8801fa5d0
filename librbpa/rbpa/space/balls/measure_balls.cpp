#include "rbpa/space/balls/measure_balls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/base/parallel/in_order.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/balls/full/ball_wedges.h"
#include "rbpa/space/balls/full/edges.h"
#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/full/far_points.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/bounding_box.h"
#include "rbpa/space/predicate/orthosphere.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa {
namespace {

using space::Ball;
using std::numbers::pi;

/// Returns the exponent of a power of two that scales the balls so that products of lengths are within the range of
/// double: 0 for sizes that need none.
int scale_exponent(std::span<const Point3> centers, std::span<const double> radii) {
  const auto [low, high] = space::box_of(centers);
  double size = *std::max_element(radii.begin(), radii.end());
  for (const double side : {high.x - low.x, high.y - low.y, high.z - low.z}) size = std::max(size, side);
  const bool fits = size == 0 || (size > 0x1p-60 && size < 0x1p60);
  return fits ? 0 : -std::ilogb(std::min(size, 0x1p1023));
}

/// Measures the union on one triangulation. Balls from number `own` on are auxiliary: they meet no other.
class BallParts {
 public:
  BallParts(std::span<const Point3> centers, std::span<const double> radii, std::size_t own,
            const RegularTriangulation& regular, const MeasureBallsOptions& options)
      : radii_(radii),
        own_(own),
        regular_(regular),
        options_(options),
        go_on_(go_on_of(options.progress, own)),
        threads_(threads_for(own, options.threads)),
        scale_(scale_exponent(centers, radii)),
        cells_(centers, regular),
        faces_(cells_, radii, threads_, go_on_),
        stars_(cells_),
        is_inside_(regular.simplices.size()),
        vertices_(own) {
    for_each_part(threads_, is_inside_.size(), 1u << 12, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        const auto& across = regular.neighbors[t];
        is_inside_[t] = faces_.has_tetrahedron(static_cast<std::uint32_t>(t)) &&
                        std::find(across.begin(), across.end(), RegularTriangulation::none) == across.end();
      }
    });
    balls_.reserve(centers.size());
    const auto scaled = [&](double value) { return std::ldexp(value, scale_); };
    for (std::size_t i = 0; i < centers.size(); ++i) {
      const Point3& p = centers[i];
      balls_.push_back(scale_ == 0 ? Ball{p, radii[i]}
                                   : Ball{{scaled(p.x), scaled(p.y), scaled(p.z)}, scaled(radii[i])});
    }
  }

  BallMeasures measure() {
    std::vector<Edge> edges = measured_edges();
    for (const Edge& edge : edges) {
      add(edge, edge.balls[0], edge.height[0]);
      add(edge, edge.balls[1], edge.height[1]);
    }
    BallMeasures result;
    result.volumes.assign(own_, 0);
    result.areas.assign(own_, 0);
    ExactSum volume, area;
    for (std::size_t i = 0; i < own_; ++i) {
      const Vertex& vertex = vertices_[i];
      if (vertex.edges == 0 && !has_vertex(i)) {
        result.hidden.push_back(static_cast<std::uint32_t>(i));
        continue;
      }
      const double r = balls_[i].radius;
      if (vertex.is_exposed) {
        // By Gauss and Bonnet: section 24 of the page.
        const double angles = pi * static_cast<double>(4 + vertex.turns - 2 * vertex.edges) - vertex.corners;
        result.areas[i] = std::clamp(r * (r * angles + vertex.arcs), 0.0, 4 * pi * r * r);
      }
      result.volumes[i] = std::max((r * result.areas[i] + vertex.cones) / 3, 0.0);
      result.areas[i] = std::ldexp(result.areas[i], -2 * scale_);
      result.volumes[i] = std::ldexp(result.volumes[i], -3 * scale_);
      area.add(result.areas[i]);
      volume.add(result.volumes[i]);
    }
    result.area = area.rounded();
    result.volume = volume.rounded();
    if (options_.derivatives) add_gradients(edges, result);
    if (options_.contacts) {
      result.contacts.reserve(edges.size());
      for (const Edge& edge : edges)
        result.contacts.push_back({edge.balls, std::ldexp(edge.area, -2 * scale_), std::ldexp(edge.arc, -scale_),
                                   std::ldexp(edge.distance, -scale_)});
    }
    return result;
  }

 private:
  /// An edge of the dual complex: the contact of two balls.
  struct Edge {
    std::array<std::uint32_t, 2> balls;
    std::array<double, 2> height;  // signed distance of the contact's plane from each center
    double distance = 0, area = 0;
    double growth = 0;          // derivative of the area when all radii grow alike
    double angle = 0, arc = 0;  // of the circle's arcs on the surface; 0 if there are none
  };
  /// Sums over the simplices at a ball.
  struct Vertex {
    bool is_exposed = false;  // whether its cell reaches out of the ball
    std::int64_t turns = 0;   // tetrahedra of the complex, and sides of triangles without one
    std::int64_t edges = 0;
    double corners = 0;  // angles at the points where three spheres meet
    double arcs = 0, cones = 0;
  };
  struct Workspace {
    space::EdgesUp up;
    std::vector<space::BallCircle::Side> sides;
    std::vector<Edge> edges;
  };

  std::vector<Edge> measured_edges() {
    constexpr std::size_t at_a_time = 1u << 9;
    std::vector<Edge> edges;
    CheckpointOfThreads checkpoint(go_on_);
    const std::size_t bound = std::min(stars_.bound(), own_);
    in_order<Workspace>(
        threads_, (bound + at_a_time - 1) / at_a_time,
        [&](std::size_t part, Workspace& w) {
          checkpoint();
          w.edges.clear();
          for (std::size_t i = part * at_a_time; i < std::min((part + 1) * at_a_time, bound); ++i)
            measure_star(static_cast<std::uint32_t>(i), w);
        },
        [&](std::size_t, Workspace& w) { edges.insert(edges.end(), w.edges.begin(), w.edges.end()); },
        [](std::size_t, Workspace&) {});
    return edges;
  }

  /// Returns how many sides of the triangle across from corner k have no tetrahedron of the complex: of the side of t,
  /// and of that outside of the hull. 0 if the triangle is not in the complex.
  int free_sides(std::uint32_t t, std::size_t k) const {
    const int sides = (faces_.has_tetrahedron(t) ? 0 : 1) + (faces_.is_on_hull(t, k) ? 1 : 0);
    return sides > 0 && faces_.has_triangle(t, k) ? sides : 0;
  }
  const Ball& ball(std::uint32_t t, std::size_t k) const { return balls_[regular_.simplices[t][k]]; }

  void measure_star(std::uint32_t i, Workspace& w) {
    Vertex& vertex = vertices_[i];
    for (const std::uint32_t t : stars_[i]) {
      if (is_inside_[t] != 0) {
        ++vertex.turns;
        continue;
      }
      const auto& row = regular_.simplices[t];
      vertex.turns += faces_.has_tetrahedron(t) ? 1 : 0;
      vertex.is_exposed |= !faces_.has_tetrahedron(t);
      const auto own = static_cast<std::size_t>(std::find(row.begin(), row.end(), i) - row.begin());
      for (std::size_t k = 0; k < 4; ++k) {
        if (k == own) continue;
        vertex.is_exposed |= faces_.is_on_hull(t, k);
        const int sides = free_sides(t, k);
        if (sides == 0) continue;
        const auto [a, b] = space::others({t, static_cast<std::uint8_t>(own), static_cast<std::uint8_t>(k)});
        vertex.turns += sides;
        vertex.corners += sides * space::corner_angle(balls_[i], ball(t, a), ball(t, b));
      }
    }
    space::for_each_edge_up(i, stars_[i], cells_, w.up, [&](std::uint32_t j, std::span<const space::EdgeAt> ring) {
      if (faces_.has_edge(ring)) w.edges.push_back(measured(i, j, ring, w.sides));
    });
  }

  Edge measured(std::uint32_t i, std::uint32_t j, std::span<const space::EdgeAt> ring,
                std::vector<space::BallCircle::Side>& sides) const {
    constexpr std::size_t most_kept = 32;
    const space::BallCircle circle(balls_[i], balls_[j]);
    const bool is_exposed = std::any_of(ring.begin(), ring.end(), [&](const space::EdgeAt& at) {
      const auto [k, l] = space::others(at);
      return is_inside_[at.tetrahedron] == 0 &&
             (!faces_.has_tetrahedron(at.tetrahedron) || faces_.is_on_hull(at.tetrahedron, k) ||
              faces_.is_on_hull(at.tetrahedron, l));
    });
    Edge edge{{i, j}, {circle.height_i, circle.height_j}, circle.distance};
    double angle = 2 * pi;
    const auto add = [&](double times, const space::WedgePart& part) {
      angle -= times * part.angle;
      edge.area += times * part.area;
      edge.growth += times * part.growth;
    };
    // Each ball around is in two tetrahedra.
    sides.clear();
    const auto side = [&](const Ball& of) {
      for (std::size_t s = 0; s < std::min(sides.size(), most_kept); ++s)
        if (sides[s].ball == &of) return sides[s];
      sides.push_back(circle.side(of));
      return sides.back();
    };
    for (const space::EdgeAt& at : ring) {
      const auto [k, l] = space::others(at);
      const auto a = side(ball(at.tetrahedron, k)), b = side(ball(at.tetrahedron, l));
      if (faces_.has_tetrahedron(at.tetrahedron)) add(1, circle.in_tetrahedron(a, b, is_exposed));
      if (is_inside_[at.tetrahedron] != 0) continue;
      if (const int sides = free_sides(at.tetrahedron, k)) add(sides, circle.beside_triangle(b));
      if (const int sides = free_sides(at.tetrahedron, l)) add(sides, circle.beside_triangle(a));
    }
    if (is_exposed) {
      edge.angle = std::max(angle, 0.0);
      edge.arc = edge.angle * std::sqrt(circle.square);
      edge.area += edge.angle * circle.square / 2;
      edge.growth +=
          edge.angle * (balls_[i].radius * circle.height_j + balls_[j].radius * circle.height_i) / circle.distance;
    }
    edge.area = std::max(edge.area, 0.0);
    return edge;
  }

  void add(const Edge& edge, std::uint32_t i, double height) {
    Vertex& vertex = vertices_[i];
    ++vertex.edges;
    vertex.arcs += height * edge.angle;
    vertex.cones += height * edge.area;
  }

  /// Returns whether ball i, which is in no edge of the complex, is in it as a vertex: whether its center is in its
  /// cell.
  bool has_vertex(std::size_t i) const {
    if (i >= stars_.bound() || stars_[i].empty()) return false;
    const Ball own = {cells_.positions[i], radii_[i]};
    return std::none_of(stars_[i].begin(), stars_[i].end(), [&](std::uint32_t t) {
      return std::any_of(regular_.simplices[t].begin(), regular_.simplices[t].end(), [&](std::uint32_t k) {
        return k != i && space::is_conflict(own, {cells_.positions[k], radii_[k]});
      });
    });
  }

  void add_gradients(std::span<const Edge> edges, BallMeasures& result) const {
    result.volume_gradient.assign(own_, {});
    result.area_gradient.assign(own_, {});
    for (const Edge& edge : edges) {
      const auto& [i, j] = edge.balls;
      const space::Vector3<double> to = space::from<double>(balls_[i].center, balls_[j].center);
      const auto add_both = [&](std::vector<Point3>& gradient, double derivative) {
        for (const auto& [ball, times] : {std::pair{i, -derivative}, std::pair{j, derivative}}) {
          gradient[ball].x += to.x / edge.distance * times;
          gradient[ball].y += to.y / edge.distance * times;
          gradient[ball].z += to.z / edge.distance * times;
        }
      };
      add_both(result.volume_gradient, std::ldexp(edge.area, -2 * scale_));
      add_both(result.area_gradient, std::ldexp(edge.growth, -scale_));
    }
  }

  std::span<const double> radii_;
  std::size_t own_;
  const RegularTriangulation& regular_;
  const MeasureBallsOptions& options_;
  GoOn go_on_;
  Threads threads_;
  int scale_;
  space::Triangulated cells_;
  space::FacesWithin faces_;
  space::PointStars stars_;
  std::vector<std::uint8_t> is_inside_;  // for each tetrahedron: it is in the complex and has no face on the hull
  std::vector<Vertex> vertices_;
  std::vector<Ball> balls_;  // scaled
};

std::vector<double> grown(std::span<const Point3> centers, std::span<const double> radii, double probe) {
  space::check_points(centers);
  if (radii.size() != centers.size())
    throw InvalidInput(std::to_string(radii.size()) + " radii, expected one for each of " +
                       std::to_string(centers.size()) + " centers");
  std::vector<double> result(radii.begin(), radii.end());
  for (std::size_t i = 0; i < radii.size(); ++i) {
    result[i] += probe;
    if (!(result[i] >= 0) || std::isinf(result[i]))
      throw InvalidInput("radius " + std::to_string(i) + " is " + text(radii[i]) + " and the probe " + text(probe) +
                         ", expected a sum that is finite and at least 0");
  }
  return result;
}

}  // namespace

BallMeasures measure_balls(std::span<const Point3> centers, std::span<const double> radii,
                           const RegularTriangulation& regular, const MeasureBallsOptions& options) {
  meshops::require_one_each("measure_balls", radii.size(), "radii", centers.size(), "centers");
  meshops::require(regular.neighbors.size() == regular.simplices.size() && !regular.simplices.empty(),
                   "measure_balls: the triangulation has no tetrahedra or no neighbors");
  return BallParts(centers, radii, centers.size(), regular, options).measure();
}

BallMeasures measure_balls(std::span<const Point3> centers, std::span<const double> radii,
                           const MeasureBallsOptions& options) {
  std::vector<double> all_radii = grown(centers, radii, options.probe);
  if (centers.empty()) return {};
  const SolidOptions with_neighbors = {.threads = options.threads, .progress = options.progress};
  RegularTriangulation regular = regular_triangulation(centers, all_radii, with_neighbors);
  if (!regular.simplices.empty()) return measure_balls(centers, all_radii, regular, options);
  // All centers are in a plane. Additional balls of radius 0, too far away for any other, make a triangulation.
  const std::vector<Point3> all =
      space::with_far_points(centers, *std::max_element(all_radii.begin(), all_radii.end()));
  all_radii.resize(all.size(), 0);
  regular = regular_triangulation(all, all_radii, with_neighbors);
  return BallParts(all, all_radii, centers.size(), regular, options).measure();
}

}  // namespace rbpa
