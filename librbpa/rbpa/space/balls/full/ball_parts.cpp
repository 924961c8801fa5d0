#include "rbpa/space/balls/full/ball_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/base/parallel/in_order.h"
#include "rbpa/space/balls/full/ball_wedges.h"
#include "rbpa/space/balls/full/edges.h"
#include "rbpa/space/predicate/bounding_box.h"
#include "rbpa/space/predicate/orthosphere.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

using std::numbers::pi;

class BallParts {
 public:
  BallParts(const Triangulated& cells, std::span<const double> radii, std::size_t own, const FacesWithin& faces,
            const MeasureBallsOptions& options, Threads& threads, const GoOn& go_on)
      : cells_(cells),
        radii_(radii),
        own_(own),
        faces_(faces),
        options_(options),
        threads_(threads),
        go_on_(go_on),
        scale_(scale_exponent(cells.positions, radii)),
        stars_(cells_),
        vertices_(own),
        balls_(radii.size()) {
    const auto scaled = [&](double value) { return scale_ == 0 ? value : std::ldexp(value, scale_); };
    for_each_part(threads, radii.size(), 1U << 14U, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Point3& p = cells.positions[i];
        balls_[i] = {{scaled(p.x), scaled(p.y), scaled(p.z)}, scaled(radii[i])};
        if (i < own) vertices_[i] = {};
      }
    });
    if (options.derivatives) {
      result_.volume_gradient.assign(own, {});
      result_.area_gradient.assign(own, {});
    }
  }

  BallMeasures measure() && {
    measure_edges();
    result_.volumes.assign(own_, 0);
    result_.areas.assign(own_, 0);
    result_.arcs.assign(own_, 0);
    ExactSum volume, area;
    for (std::size_t i = 0; i < own_; ++i) {
      const Vertex& vertex = vertices_[i];
      if (vertex.edges == 0 && !has_vertex(i)) {
        result_.hidden.push_back(static_cast<std::uint32_t>(i));
        continue;
      }
      double &own_area = result_.areas[i], &own_volume = result_.volumes[i];
      const double r = balls_[i].radius;
      if (vertex.is_exposed) {
        // By Gauss and Bonnet: section 24 of the page.
        const double angles = pi * static_cast<double>(4 + vertex.turns - 2 * vertex.edges) - vertex.corners;
        own_area = std::clamp(r * (r * angles + vertex.heights), 0.0, 4 * pi * r * r);
      }
      own_volume = std::max((r * own_area + vertex.cones) / 3, 0.0);
      own_area = std::ldexp(own_area, -2 * scale_);
      own_volume = std::ldexp(own_volume, -3 * scale_);
      result_.arcs[i] = vertex.arcs;
      area.add(own_area);
      volume.add(own_volume);
    }
    result_.area = area.rounded();
    result_.volume = volume.rounded();
    return std::move(result_);
  }

 private:
  /// An edge of the dual complex: the contact of two balls.
  struct Edge {
    std::array<std::uint32_t, 2> balls;
    std::array<double, 2> height;  // signed distance of the contact's plane from each center
    double distance = 0, area = 0;
    double growth = 0;          // derivative of the area when all radii grow alike
    double angle = 0, arc = 0;  // sums over the circle's arcs on the surface; 0 if there are none
    std::uint32_t arcs = 0;
  };
  /// Sums over the simplices at a ball.
  struct Vertex {
    bool is_exposed = false;  // whether the power cell reaches out of the ball
    std::int64_t turns = 0;   // number of tetrahedra of the complex, and of sides of triangles without one
    std::int64_t edges = 0;
    std::uint32_t arcs = 0;
    double corners = 0;  // sum of the angles at points where three spheres meet
    double heights = 0;  // sum of the heights of contacts, each times the angle of its arcs
    double cones = 0;    // sum of the areas of contacts times their heights
  };
  /// An edge of the triangulation from the ball that is measured.
  struct Spoke {
    Spoke(const Ball& from, const Ball& to, std::uint32_t other) : edge(from, to), ball(other) {}
    EdgeOfBalls edge;
    std::uint32_t ball, last = Solid::none;  // last: the last tetrahedron of the edge in the list
    std::uint32_t ends = 0;                  // ends of arcs, at sides of triangles without a tetrahedron
    bool is_exposed = false, has_triangle = false;
    WedgePart parts;  // sums
    void add(double times, const WedgePart& part) {
      parts.angle += times * part.angle;
      parts.area += times * part.area;
      parts.growth += times * part.growth;
    }
  };
  /// The places of the other corners of a tetrahedron.
  struct Corners {
    std::array<std::uint32_t, 3> place;
    bool is_filled;  // the tetrahedron is in the complex
  };
  /// A tetrahedron outside of the complex, in the list of those around an edge.
  struct Around {
    EdgeAt at;
    std::uint32_t before;  // the previous tetrahedron around the edge
  };
  struct Workspace {
    std::vector<std::uint32_t> place;  // for each ball in `ends`, its place there
    std::vector<std::uint32_t> ends;   // the other ball of each spoke
    std::vector<Spoke> spokes;
    std::vector<Corners> star;
    std::vector<Around> around;
    std::vector<EdgeAt> ring;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> up;  // ball and place of each edge to measure
    std::vector<Edge> edges;
  };

  void measure_edges() {
    constexpr std::size_t at_a_time = 1u << 9;
    CheckpointOfThreads checkpoint(go_on_);
    const std::size_t bound = std::min(stars_.bound(), own_);
    in_order<Workspace>(
        threads_, (bound + at_a_time - 1) / at_a_time,
        [&](std::size_t part, Workspace& w) {
          w.place.resize(stars_.bound());
          w.edges.clear();
          for (std::size_t i = part * at_a_time; i < std::min((part + 1) * at_a_time, bound); ++i) {
            if (i % 16 == 0) checkpoint();
            measure_star(static_cast<std::uint32_t>(i), w);
          }
        },
        [&](std::size_t, Workspace& w) {
          for (const Edge& edge : w.edges) add(edge);
        },
        [](std::size_t, Workspace&) {});
  }

  /// Measures the edges from ball i to balls of greater index, and sums what is at ball i alone.
  void measure_star(std::uint32_t i, Workspace& w) {
    const auto star = stars_[i];
    w.ends.clear();
    w.spokes.clear();
    w.star.clear();
    w.around.clear();
    w.up.clear();
    for (const std::uint32_t t : star) visit(t, i, w);
    for (const Corners& corners : w.star)
      if (corners.is_filled) add_tetrahedron(i, corners.place, w);
    for (std::uint32_t k = 0; k < w.ends.size(); ++k)
      if (const Spoke& spoke = w.spokes[k]; spoke.ball > i && has_edge(spoke, w)) w.up.emplace_back(spoke.ball, k);
    std::sort(w.up.begin(), w.up.end());
    for (const auto& [ball, k] : w.up) w.edges.push_back(measured(i, w.spokes[k]));
  }

  /// Numbers the other corners of a tetrahedron at ball i, and adds the parts that do not depend on other tetrahedra.
  void visit(std::uint32_t t, std::uint32_t i, Workspace& w) {
    const auto& row = cells_.simplices[t];
    const auto own = static_cast<std::size_t>(std::find(row.begin(), row.end(), i) - row.begin());
    Corners& star = w.star.emplace_back();
    std::array<std::size_t, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = (own + k + 1) % 4;
      star.place[k] = place_of(row[corner[k]], i, w);
    }
    star.is_filled = faces_.has_tetrahedron(t);
    Vertex& vertex = vertices_[i];
    vertex.turns += star.is_filled ? 1 : 0;
    if (faces_.is_inside(t)) {
      for (const std::uint32_t place : star.place) w.spokes[place].has_triangle = true;
      return;
    }
    vertex.is_exposed |= !star.is_filled;
    for (std::size_t k = 0; k < 3; ++k) {
      // The triangle across from a corner, and the edges to its other corners.
      const std::array<Spoke*, 2> to = {&w.spokes[star.place[(k + 1) % 3]], &w.spokes[star.place[(k + 2) % 3]]};
      const bool is_on_hull = faces_.is_on_hull(t, corner[k]), is_outer = !star.is_filled || is_on_hull,
                 has_triangle = star.is_filled || faces_.has_triangle(t, corner[k]);
      for (Spoke* spoke : to) {
        spoke->is_exposed |= is_outer;
        spoke->has_triangle |= has_triangle;
      }
      if (Spoke& spoke = w.spokes[star.place[k]]; !star.is_filled && spoke.ball > i) {
        w.around.push_back({{t, static_cast<std::uint8_t>(own), static_cast<std::uint8_t>(corner[k])}, spoke.last});
        spoke.last = static_cast<std::uint32_t>(w.around.size() - 1);
      }
      if (!is_outer || !has_triangle) continue;
      const unsigned sides = (star.is_filled ? 0U : 1U) + (is_on_hull ? 1U : 0U);
      vertex.is_exposed = true;
      vertex.turns += sides;
      vertex.corners += sides * corner_angle(to[0]->edge, to[1]->edge);
      for (std::size_t end = 0; end < 2; ++end)
        if (to[end]->ball > i) {
          to[end]->ends += sides;
          to[end]->add(sides, beside_triangle(to[end]->edge, to[1 - end]->edge));
        }
    }
  }

  std::uint32_t place_of(std::uint32_t ball, std::uint32_t i, Workspace& w) const {
    std::uint32_t& place = w.place[ball];
    if (place >= w.ends.size() || w.ends[place] != ball) {
      place = static_cast<std::uint32_t>(w.ends.size());
      w.ends.push_back(ball);
      w.spokes.emplace_back(balls_[i], balls_[ball], ball);
    }
    return place;
  }

  /// Adds the parts in a tetrahedron of the complex to its edges at ball i.
  void add_tetrahedron(std::uint32_t i, const std::array<std::uint32_t, 3>& place, Workspace& w) const {
    const std::array<Spoke*, 3> to = {&w.spokes[place[0]], &w.spokes[place[1]], &w.spokes[place[2]]};
    if (to[0]->ball < i && to[1]->ball < i && to[2]->ball < i) return;
    const EdgesAtCorner edges({&to[0]->edge, &to[1]->edge, &to[2]->edge});
    for (std::size_t k = 0; k < 3; ++k)
      if (to[k]->ball > i) to[k]->add(1, in_tetrahedron(edges, k, to[k]->is_exposed));
  }

  bool has_edge(const Spoke& spoke, Workspace& w) const {
    if (spoke.has_triangle) return true;
    w.ring.clear();
    for (std::uint32_t at = spoke.last; at != Solid::none; at = w.around[at].before) w.ring.push_back(w.around[at].at);
    return faces_.has_edge_alone(w.ring);
  }

  Edge measured(std::uint32_t i, const Spoke& spoke) const {
    const CircleOfBalls circle(spoke.edge);
    Edge edge{
        {i, spoke.ball}, {circle.height_i, circle.height_j}, circle.distance, spoke.parts.area, spoke.parts.growth};
    if (spoke.is_exposed) {
      const double r = balls_[i].radius, s = balls_[spoke.ball].radius;
      edge.arcs = std::max(spoke.ends / 2, 1U);
      edge.angle = std::max(2 * pi - spoke.parts.angle, 0.0);
      edge.arc = edge.angle * std::sqrt(circle.square);
      edge.area += edge.angle * circle.square / 2;
      edge.growth += edge.angle * (r * circle.height_j + s * circle.height_i) / circle.distance;
    }
    edge.area = std::max(edge.area, 0.0);
    return edge;
  }

  void add(const Edge& edge) {
    for (std::size_t k = 0; k < 2; ++k) {
      Vertex& vertex = vertices_[edge.balls[k]];
      ++vertex.edges;
      vertex.arcs += edge.arcs;
      vertex.heights += edge.height[k] * edge.angle;
      vertex.cones += edge.height[k] * edge.area;
    }
    const auto unscaled = [&](double value, int power) { return std::ldexp(value, -power * scale_); };
    if (options_.contacts)
      result_.contacts.push_back(
          {edge.balls, unscaled(edge.area, 2), unscaled(edge.arc, 1), unscaled(edge.distance, 1)});
    if (!options_.derivatives) return;
    const Vector3<double> to = from<double>(balls_[edge.balls[0]].center, balls_[edge.balls[1]].center);
    const auto add_both = [&](std::vector<Point3>& gradient, double derivative) {
      for (const auto& [ball, times] : {std::pair{edge.balls[0], -derivative}, std::pair{edge.balls[1], derivative}}) {
        gradient[ball].x += to.x / edge.distance * times;
        gradient[ball].y += to.y / edge.distance * times;
        gradient[ball].z += to.z / edge.distance * times;
      }
    };
    add_both(result_.volume_gradient, unscaled(edge.area, 2));
    add_both(result_.area_gradient, unscaled(edge.growth, 1));
  }

  /// Returns whether ball i, which is in no edge of the complex, is a vertex of the complex.
  bool has_vertex(std::size_t i) const {
    return i < stars_.bound() && !stars_[i].empty() &&
           is_center_in_cell(cells_, radii_, static_cast<std::uint32_t>(i), stars_[i]);
  }

  const Triangulated& cells_;
  std::span<const double> radii_;
  std::size_t own_;
  const FacesWithin& faces_;
  const MeasureBallsOptions& options_;
  Threads& threads_;
  const GoOn& go_on_;
  int scale_;
  PointStars stars_;
  meshops::FreshVector<Vertex> vertices_;
  meshops::FreshVector<Ball> balls_;  // scaled
  BallMeasures result_;
};

}  // namespace

int scale_exponent(std::span<const Point3> centers, std::span<const double> radii) {
  const auto [low, high] = box_of(centers);
  double size = *std::max_element(radii.begin(), radii.end());
  for (const double side : {high.x - low.x, high.y - low.y, high.z - low.z}) size = std::max(size, side);
  const bool fits = size == 0 || (size > 0x1p-60 && size < 0x1p60);
  return fits ? 0 : -std::ilogb(std::min(size, 0x1p1023));
}

BallMeasures ball_parts(const Triangulated& cells, std::span<const double> radii, std::size_t own,
                        const FacesWithin& faces, const MeasureBallsOptions& options, Threads& threads,
                        const GoOn& go_on) {
  return BallParts(cells, radii, own, faces, options, threads, go_on).measure();
}

}  // namespace rbpa::space
