#include "meshops/topology/loop_kinds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <queue>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"

namespace meshops {
namespace {

using Vector = std::array<double, 3>;

Vector operator+(const Vector& u, const Vector& v) { return {u[0] + v[0], u[1] + v[1], u[2] + v[2]}; }
Vector operator-(const Vector& u, const Vector& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }
Vector operator*(double s, const Vector& v) { return {s * v[0], s * v[1], s * v[2]}; }
double dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
Vector cross(const Vector& u, const Vector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
double length(const Vector& v) { return std::sqrt(dot(v, v)); }

/// Returns the vector scaled to length 1, or nothing if its length is 0.
std::optional<Vector> unit(const Vector& v) {
  const double size = length(v);
  if (!(size > 0)) return std::nullopt;
  return (1 / size) * v;
}

/// Closed polygon with its bounding box.
struct Polygon {
  std::vector<Vector> points;
  Vector low, high;

  explicit Polygon(std::vector<Vector> of) : points(std::move(of)), low(points.front()), high(points.front()) {
    for (const Vector& p : points)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
  }

  const Vector& behind(std::size_t i) const { return points[i + 1 == points.size() ? 0 : i + 1]; }
  bool meets_box_of(const Polygon& other) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (other.low[k] > high[k] || low[k] > other.high[k]) return false;
    return true;
  }
};

/// Returns the signed solid angle of the directions in which two segments appear to cross.
double crossing_angle(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  const Vector ac = c - a, ad = d - a, bc = c - b, bd = d - b;
  const auto n1 = unit(cross(ac, ad)), n2 = unit(cross(ad, bd)), n3 = unit(cross(bd, bc)), n4 = unit(cross(bc, ac));
  if (!n1 || !n2 || !n3 || !n4) return 0;  // all four points are in a plane
  const double side = dot(cross(d - c, b - a), ac);
  const auto angle = [](const Vector& u, const Vector& v) { return std::asin(std::clamp(dot(u, v), -1.0, 1.0)); };
  const double sum = angle(*n1, *n2) + angle(*n2, *n3) + angle(*n3, *n4) + angle(*n4, *n1);
  return side > 0 ? sum : side < 0 ? -sum : 0;
}

/// Returns how often one polygon winds around the other, or nothing if the sum is not near an integer.
std::optional<int> linking_number(const Polygon& p, const Polygon& q, Steps& step) {
  if (!p.meets_box_of(q)) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    step(q.points.size());
    for (std::size_t j = 0; j < q.points.size(); ++j)
      sum += crossing_angle(p.points[i], p.behind(i), q.points[j], q.behind(j));
  }
  constexpr double near = 0.1;
  const double number = sum / (4 * std::numbers::pi), rounded = std::round(number);
  if (!(std::abs(number - rounded) < near)) return std::nullopt;
  return static_cast<int>(rounded);
}

/// Lifts loops of a surface off the surface, on the side of its normals.
class Lifting {
 public:
  Lifting(const Connectivity& mesh, std::span<const Vector> positions) : mesh_(mesh), positions_(positions) {}

  Polygon on_surface(const Loop& loop) const {
    std::vector<Vector> points;
    for (const Halfedge h : loop) points.push_back(at(mesh_.from_vertex_handle(h)));
    return Polygon(std::move(points));
  }

  /// Returns the lifted loop, or nothing if the surface is folded flat or a face has no area along the loop.
  std::optional<Polygon> lifted(const Loop& loop) const {
    std::vector<Vector> points;
    const auto add = [&](const std::optional<Vector>& p) {
      if (p) points.push_back(*p);
      return p.has_value();
    };
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Halfedge in = loop[i], out = loop[i + 1 == loop.size() ? 0 : i + 1];
      // The lifted loop runs above the edge, then around its end, above the faces and edges on the left.
      if (!add(above_edge(in)) || !add(above_edge(mesh_.opposite_halfedge_handle(in)))) return std::nullopt;
      if (mesh_.opposite_halfedge_handle(in) == out) continue;
      Halfedge next = mesh_.next_halfedge_handle(in);
      if (!add(above_corner(next))) return std::nullopt;
      while (next != out) {
        const Halfedge beyond = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(next));
        require(beyond != mesh_.opposite_halfedge_handle(in), "loop_kinds: at the end of halfedge ", in.idx(),
                " a loop passes from one fan to another");
        if (!add(above_edge(next)) || !add(above_corner(beyond))) return std::nullopt;
        next = beyond;
      }
    }
    return Polygon(std::move(points));
  }

 private:
  static constexpr double inward = 0.25;  // distance from the end of an edge, as a fraction of its length
  static constexpr double height = 1e-5;  // height above an edge, as a fraction of its length

  const Vector& at(Vertex v) const { return positions_[static_cast<std::size_t>(v.idx())]; }

  std::optional<Vector> normal_of(Face f) const {
    Vector sum = {0, 0, 0};
    const Halfedge first = mesh_.halfedge_handle(f);
    const Vector& origin = at(mesh_.from_vertex_handle(first));
    for (const Halfedge h : mesh_.fh_range(f))
      sum = sum + cross(at(mesh_.from_vertex_handle(h)) - origin, at(mesh_.to_vertex_handle(h)) - origin);
    return unit(sum);
  }

  /// Returns a point above an edge, near the start of the halfedge.
  std::optional<Vector> above_edge(Halfedge h) const {
    const auto left = normal_of(mesh_.face_handle(h)),
               right = normal_of(mesh_.face_handle(mesh_.opposite_halfedge_handle(h)));
    if (!left || !right) return std::nullopt;
    const auto up = unit(*left + *right);
    const Vector& from = at(mesh_.from_vertex_handle(h));
    const Vector along = at(mesh_.to_vertex_handle(h)) - from;
    if (!up) return std::nullopt;
    return from + inward * along + (height * length(along)) * *up;
  }

  /// Returns a point above the face on the left, near the start of the halfedge.
  std::optional<Vector> above_corner(Halfedge h) const {
    const auto up = normal_of(mesh_.face_handle(h));
    if (!up) return std::nullopt;
    const Vector& from = at(mesh_.from_vertex_handle(h));
    const Vector next = at(mesh_.to_vertex_handle(h)) - from;
    const Vector last = at(mesh_.from_vertex_handle(mesh_.prev_halfedge_handle(h))) - from;
    return from + (inward / 2) * (next + last) + (height * std::min(length(next), length(last))) * *up;
  }

  const Connectivity& mesh_;
  std::span<const Vector> positions_;
};

/// Components of a mesh: for each face, its component; for each component, whether it is closed, and its volume.
struct Sides {
  std::vector<std::size_t> component;  // for each face
  std::vector<double> volume;          // for each component; negative where its normals point inward
  std::vector<bool> is_closed;

  Sides(const Connectivity& mesh, std::span<const Vector> positions) : component(mesh.n_faces(), none) {
    const auto number = [](Face f) { return static_cast<std::size_t>(f.idx()); };
    for_each_face(mesh, [&](Face first) {
      if (component[number(first)] != none) return;
      const std::size_t own = volume.size();
      const Vector& origin =
          positions[static_cast<std::size_t>(mesh.from_vertex_handle(mesh.halfedge_handle(first)).idx())];
      double six = 0;
      bool closed = true;
      std::queue<Face> waiting;
      const auto reach = [&](Face f) {
        if (component[number(f)] != none) return;
        component[number(f)] = own;
        waiting.push(f);
      };
      reach(first);
      while (!waiting.empty()) {
        const Face f = waiting.front();
        waiting.pop();
        const auto place = [&](Vertex v) { return positions[static_cast<std::size_t>(v.idx())] - origin; };
        const Vector a = place(mesh.from_vertex_handle(mesh.halfedge_handle(f)));
        for (const Halfedge h : mesh.fh_range(f)) {
          six += dot(a, cross(place(mesh.from_vertex_handle(h)), place(mesh.to_vertex_handle(h))));
          const Halfedge beyond = mesh.opposite_halfedge_handle(h);
          if (mesh.is_boundary(beyond))
            closed = false;
          else
            reach(mesh.face_handle(beyond));
        }
      }
      volume.push_back(six / 6);
      is_closed.push_back(closed);
    });
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

/// Returns the face of a halfedge; for a boundary halfedge, the face beyond it.
Face face_at(const Connectivity& mesh, Halfedge h) {
  const Face f = mesh.face_handle(mesh.is_boundary(h) ? mesh.opposite_halfedge_handle(h) : h);
  require(is_live(mesh, f), "loop_kinds: halfedge ", h.idx(), " of a loop has no face on either side");
  return f;
}

void require_closed(const Connectivity& mesh, const Loop& loop) {
  require(!loop.empty(), "loop_kinds: a loop is empty");
  for (const Halfedge h : loop)
    require(is_live(mesh, h), "loop_kinds: halfedge ", h.idx(), " of a loop does not exist or is deleted");
  for (std::size_t i = 0; i < loop.size(); ++i)
    require(mesh.to_vertex_handle(loop[i]) == mesh.from_vertex_handle(loop[i + 1 == loop.size() ? 0 : i + 1]),
            "loop_kinds: halfedge ", loop[i].idx(), " of a loop does not end where the next one starts");
}

}  // namespace

std::vector<LoopKind> loop_kinds(const Connectivity& mesh, std::span<const Vector> positions,
                                 std::span<const Loop> loops, const GoOn& go_on) {
  if (positions.size() < mesh.n_vertices())
    require_one_each("loop_kinds", positions.size(), "positions", mesh.n_vertices(), "vertices");
  for (const Loop& loop : loops) require_closed(mesh, loop);
  Steps step(go_on);
  const Sides sides(mesh, positions);
  const Lifting lifting(mesh, positions);
  std::vector<std::size_t> component;
  std::vector<Polygon> on;
  std::vector<std::optional<Polygon>> above;  // nothing for loops of open components and loops that cannot be lifted
  std::vector<LoopKind> kinds(loops.size(), LoopKind::unknown);
  std::vector<bool> bounds_below(loops.size(), true), bounds_above(loops.size(), true), is_sure(loops.size(), true);
  std::vector<bool> is_known = sides.is_closed;  // for each component, whether all of its loops could be lifted
  for (std::size_t i = 0; i < loops.size(); ++i) {
    component.push_back(sides.component[static_cast<std::size_t>(face_at(mesh, loops[i].front()).idx())]);
    on.push_back(lifting.on_surface(loops[i]));
    above.push_back(sides.is_closed[component[i]] ? lifting.lifted(loops[i]) : std::nullopt);
    if (!above[i]) is_known[component[i]] = false;
  }
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t j = 0; j < loops.size(); ++j) {
      const bool is_own = component[i] == component[j];
      if (!is_known[component[i]] || (!is_own && !on[i].meets_box_of(on[j]))) continue;
      const std::optional<int> number = linking_number(on[i], is_own ? *above[j] : on[j], step);
      if (!number) {
        is_sure[i] = false;
        if (is_own) is_sure[j] = false;
      } else if (*number != 0) {
        bounds_below[i] = false;
        if (is_own)
          bounds_above[j] = false;
        else  // the loop links the other component on both sides
          bounds_above[i] = false;
      }
    }
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!is_sure[i] || !is_known[component[i]]) continue;
    const bool is_turned = sides.volume[component[i]] < 0;  // whether the normals point inward
    const bool inside = is_turned ? bounds_above[i] : bounds_below[i],
               outside = is_turned ? bounds_below[i] : bounds_above[i];
    kinds[i] = inside ? (outside ? LoopKind::both : LoopKind::handle) : outside ? LoopKind::tunnel : LoopKind::neither;
  }
  return kinds;
}

}  // namespace meshops
