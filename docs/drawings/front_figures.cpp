// What: advancing fronts: events of curves, what is refused, and moments of a run of ball pivoting.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "drawings/figures.h"
#include "drawings/sheet.h"
#include "meshops/core/live.h"
#include "meshops/front/engine.h"
#include "rbpa/paper/pivoting.h"
#include "rbpa/rbpa.h"

namespace figures {
namespace {

using meshops::Front;
using meshops::Site;
using Triangle = std::array<Site, 3>;

/// Returns the present mesh of a front. Fans on one site lie slightly apart, each on its side. Vertices that were
/// merged into others are left out.
DrawnMesh drawn_front(const Front& front, const Mesh& mesh, const std::vector<Place>& places) {
  DrawnMesh drawn;
  drawn.mesh = mesh;
  meshops::for_each_vertex(mesh, [&](Vertex v) {
    const Site s = front.site(v);
    if (mesh.is_isolated(v) && !(front.is_free(s) && v == Vertex(static_cast<int>(s))))
      drawn.mesh.status(v).set_deleted(true);
    else
      drawn.move(v, places[s]);
  });
  std::map<Vertex, Place> apart;
  for (Site s = 0; s < front.sites(); ++s) {
    std::vector<Vertex> fans;
    front.for_each_fan(s, [&](Vertex v) { fans.push_back(v); });
    if (fans.size() < 2) continue;
    for (const Vertex v : fans) {
      Place towards;
      for (const Face f : mesh.vf_range(v)) towards = towards + direction(drawn.centroid(f) - drawn.place(v));
      apart[v] = drawn.place(v) + 0.1 * direction(towards);
    }
  }
  for (const auto& [v, place] : apart) drawn.move(v, place);
  return drawn;
}

struct Events : meshops::CurveVisitor {
  std::string last;
  void curves_joined(const Front&, Halfedge) { last = "curves_joined"; }
  void curve_split(const Front&, Halfedge, Halfedge) { last = "curve_split"; }
  void curve_closed(const Front&) { last = "curve_closed"; }
};

/// Policy that attaches the triangles of a list, each counter-clockwise, and freezes an edge at which none fits.
class GivenTriangles {
 public:
  explicit GivenTriangles(std::vector<Triangle> triangles) : left_(std::move(triangles)) {}

  std::optional<Triangle> seed(const Front&) {
    if (left_.empty()) return std::nullopt;
    return take(left_.begin());
  }
  std::optional<Site> propose(const Front& front, Halfedge h) {
    const Site a = front.from_site(h), b = front.to_site(h);
    for (auto t = left_.begin(); t != left_.end(); ++t)
      for (unsigned i = 0; i < 3; ++i)
        if ((*t)[i] == a && (*t)[(i + 1) % 3] == b) return take(t)[(i + 2) % 3];
    return std::nullopt;
  }

 private:
  Triangle take(std::vector<Triangle>::iterator at) {
    const Triangle taken = *at;
    left_.erase(at);
    return taken;
  }
  std::vector<Triangle> left_;
};

std::vector<Triangle> as_triangles(const std::vector<Corners>& faces) {
  std::vector<Triangle> triangles;
  for (const Corners& f : faces)
    triangles.push_back({static_cast<Site>(f[0]), static_cast<Site>(f[1]), static_cast<Site>(f[2])});
  return triangles;
}

/// Draws a front before and after some triangles, with the last event that they caused.
void event_row(Sheet& sheet, const std::vector<Place>& places, const std::vector<Corners>& faces,
               const std::vector<Corners>& more) {
  Mesh mesh;
  Front front(mesh, places.size());
  GivenTriangles first(as_triangles(faces)), then(as_triangles(more));
  meshops::advance(front, first);
  const DrawnMesh before = drawn_front(front, mesh, places);
  Marks fitting, attached;
  for (const Triangle& t : as_triangles(more))
    for (const Halfedge h : front.fit(t[0], t[1], t[2]).sides.side)
      if (h.is_valid()) fitting.add(mesh.edge_handle(h));
  front.next_level();
  Events events;
  meshops::advance(front, then, events);
  for (std::size_t f = faces.size(); f < mesh.n_faces(); ++f) attached.add(Face(static_cast<int>(f)));
  const std::string times = more.size() > 1 ? std::to_string(more.size()) + " × " : "";
  sheet.row(counted(before, fitting), {times + "attach", "", events.last},
            counted(drawn_front(front, mesh, places), attached));
}

/// Returns a panel with a mesh, a triangle that a policy proposes, and the answer of the front.
Panel proposed(const std::vector<Place>& places, const std::vector<Corners>& faces, const Triangle& triangle) {
  Mesh mesh;
  Front front(mesh, places.size());
  for (const Triangle& t : as_triangles(faces)) front.create(t[0], t[1], t[2]);
  Panel panel{drawn_front(front, mesh, places), {}};
  panel.extent = places;
  const auto refusal = front.create_blocker(triangle[0], triangle[1], triangle[2]);
  panel.heading = refusal ? "refused: " + std::string(meshops::name(refusal->kind)) : "taken";
  panel.more = [=, ink = refusal ? color::touched : color::curve](Canvas& canvas, const Frame& frame) {
    for (unsigned i = 0; i < 3; ++i) {
      const Place a = frame(places[triangle[i]]), b = frame(places[triangle[(i + 1) % 3]]);
      canvas.segment({a, b, {}}, {ink, 2.5, true});
      canvas.dot(a, 4, ink);
    }
  };
  return panel;
}

/// Disc in which the plane cuts a ball.
struct Disc {
  Place center;
  double radius;
};

constexpr double alpha = 0.85;

Place left_of(Place d) { return {-d.y, d.x}; }
double dot(Place a, Place b) { return a.x * b.x + a.y * b.y; }

/// Returns the disc of a ball at rest on three points.
Disc ball_on(Place a, Place b, Place c) {
  const Place e = c - a, f = c - b, d = b - a;
  const double half_chords = dot(e, f) / dot(e, left_of(d));  // from the edge ab to the center, to the left
  return {0.5 * (a + b) + (half_chords / 2) * left_of(d), length(d) / 2 * std::sqrt(1 + half_chords * half_chords)};
}

/// Returns the disc of a ball that touches two points at its equator, after it turned to the left of the edge without
/// touching a third point.
Disc largest_left_of(Place a, Place b) {
  const Place d = b - a;
  return {0.5 * (a + b) + std::sqrt(alpha * alpha - dot(d, d) / 4) * direction(left_of(d)), alpha};
}

/// Visitor that keeps a panel of the first moment of each kind of a run.
class Recorder : public meshops::FrontVisitor {
 public:
  static constexpr bool follows_curves = true;

  Recorder(const Mesh& mesh, const std::vector<Place>& places) : mesh_(mesh), places_(places) {}

  void seeded(const Front& front, const meshops::InsertedTriangle& triangle) {
    const auto corner = [&](std::size_t i) { return places_[front.to_site(triangle.side[i])]; };
    free_ = free_sites(front);
    first.try_emplace("a seed", panel(front, triangle.face, {ball_on(corner(0), corner(1), corner(2))}));
  }
  void attached(const Front& front, Halfedge h, const meshops::InsertedTriangle& triangle) {
    const std::size_t free = free_sites(front);
    latest_ = panel(front, triangle.face, {ball_right_of(front, h), ball_left_of(front, h)});
    first.try_emplace(free == free_ ? "to a point of the front" : "over an edge to a free point", latest_);
    free_ = free;
  }
  void frozen(const Front& front, Halfedge h) {
    frozen_.insert(h);
    const Disc after = largest_left_of(places_[front.from_site(h)], places_[front.to_site(h)]);
    first.try_emplace("nothing to touch: frozen", panel(front, std::nullopt, {ball_right_of(front, h), after}));
  }
  void curve_split(const Front&, Halfedge, Halfedge) { first.try_emplace("the front becomes two curves", latest_); }

  /// Returns a panel of the present mesh, with the new triangle, and the balls before and after.
  Panel panel(const Front& front, std::optional<Face> fresh, const std::vector<Disc>& balls) const {
    Panel panel{drawn_front(front, mesh_, places_), {}};
    std::size_t frozen = 0;
    meshops::for_each_halfedge(mesh_, [&](Halfedge h) {
      if (!mesh_.is_boundary(h)) return;
      if (frozen_.contains(h))
        ++frozen;
      else
        panel.marks.add(mesh_.edge_handle(h));
    });
    if (fresh) panel.marks.add(*fresh);
    panel.caption = {"triangles " + std::to_string(front.faces()) + " · active " +
                     std::to_string(panel.marks.edges.size()) + " · frozen " + std::to_string(frozen)};
    for (const Disc& ball : balls)
      for (const Place corner : {Place{-1, -1}, {1, 1}}) panel.extent.push_back(ball.center + ball.radius * corner);
    panel.more = [balls](Canvas& canvas, const Frame& frame) {
      for (std::size_t i = 0; i < balls.size(); ++i) {
        const bool before = i + 1 < balls.size();
        canvas.circle(frame(balls[i].center), frame.scale * balls[i].radius,
                      {before ? color::inner : color::text, before ? 1.0 : 1.6, before});
        canvas.dot(frame(balls[i].center), 2.2, before ? color::inner : color::text);
      }
      if (balls.size() < 2) return;
      canvas.arrow({frame(balls[0].center), frame(balls[1].center), {}}, {color::text, 1.2}, 7);
    };
    return panel;
  }

  std::map<std::string, Panel> first;  ///< by what happened

 private:
  Disc ball_left_of(const Front& front, Halfedge h) const {
    return ball_on(places_[front.from_site(h)], places_[front.to_site(h)],
                   places_[front.to_site(mesh_.next_halfedge_handle(h))]);
  }
  Disc ball_right_of(const Front& front, Halfedge h) const {
    return ball_left_of(front, mesh_.opposite_halfedge_handle(h));
  }
  static std::size_t free_sites(const Front& front) {
    std::size_t free = 0;
    for (Site s = 0; s < static_cast<Site>(front.sites()); ++s) free += front.is_free(s) ? 1U : 0U;
    return free;
  }

  const Mesh& mesh_;
  const std::vector<Place>& places_;
  std::set<Halfedge> frozen_;
  std::size_t free_ = 0;
  Panel latest_;
};

}  // namespace

std::string front_events() {
  Sheet sheet("Events of a front: a curve splits, two curves join, a curve closes");
  const Ring open = ring(7, 18, 342, 0.8, 1.7);
  event_row(sheet, open.places, open.faces, {{7, 0, 8}, {7, 8, 15}});
  event_row(sheet,
            {{0, 0.2}, {1.3, 0}, {1.3, 1.7}, {0.1, 1.5}, {2.3, 0.1}, {3.5, 0.4}, {3.5, 1.3}, {2.3, 1.8}, {4.3, 0.8}},
            {{0, 1, 3}, {1, 2, 3}, {4, 5, 7}, {5, 6, 7}, {5, 8, 6}}, {{1, 4, 2}, {4, 7, 2}});
  std::vector<Place> hole;
  for (int i = 0; i < 3; ++i) hole.push_back(polar(90 + 120 * i, 0.5));
  for (int i = 0; i < 3; ++i) hole.push_back(polar(150 + 120 * i, 1.7));
  event_row(sheet, hole, {{0, 3, 1}, {3, 4, 1}, {1, 4, 2}, {4, 5, 2}, {2, 5, 0}, {5, 3, 0}}, {{0, 1, 2}});
  return sheet.svg();
}

std::string front_refusals() {
  Sheet sheet("What a front takes of what is proposed, and what it refuses", 60, 250);
  std::vector<Place> wheel = {{0, 0}};
  std::vector<Corners> spokes;
  for (std::uint32_t i = 0; i < 6; ++i) {
    wheel.push_back(polar(30 + 60 * i, 1));
    spokes.push_back({0, 1 + i, 1 + (i + 1) % 6});
  }
  for (const Place p : {Place{2.3, 0.5}, Place{2.3, -0.5}}) wheel.push_back(p);
  sheet.row({proposed({{0, 0}, {2, 0}, {1, 1.5}, {2.6, 1.3}}, {{0, 1, 2}}, {0, 1, 3}),
             proposed(wheel, spokes, {0, 8, 7}),
             proposed({{0, 0}, {1.3, -0.5}, {1.3, 0.8}, {-1.2, 0.7}, {-1.3, -0.6}}, {{0, 1, 2}}, {0, 3, 4})});
  return sheet.svg();
}

std::string pivoting() {
  const std::vector<Place> places = {{1.5, 1.5},   {2.1, 0.6},  {2.7, 1.55}, {1.0, 0.55}, {0.4, 1.6},  {0.95, 2.4},
                                     {2.05, 2.35}, {3.1, 0.65}, {3.65, 1.5}, {4.2, 0.5},  {4.8, 1.45}, {4.15, 2.45},
                                     {5.25, 2.3},  {0.45, 3.3}, {1.6, 3.25}, {2.65, 3.3}, {3.7, 3.35}, {4.75, 3.2},
                                     {2.15, 4.15}, {3.2, 4.2},  {4.3, 4.1},  {6.3, 3.7}};
  std::vector<rbpa::Point> points;
  for (const Place p : places) points.push_back({p.x, p.y});
  Mesh mesh;
  Front front(mesh, places.size());
  rbpa::paper::RestrictedBallPivoting policy(points, front.next_level().carried, rbpa::Radius(alpha));
  Recorder recorder(mesh, places);
  meshops::advance(front, policy, recorder);
  std::set<std::array<std::uint32_t, 3>> drawn;
  meshops::for_each_face(mesh, [&](Face f) {
    std::array<std::uint32_t, 3> corners{};
    auto corner = corners.begin();
    for (const Vertex v : mesh.fv_range(f)) *corner++ = static_cast<std::uint32_t>(front.site(v));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    drawn.insert(corners);
  });
  const auto expected = rbpa::triangles(rbpa::rbpa(points, alpha));
  if (!std::equal(drawn.begin(), drawn.end(), expected.begin(), expected.end()))
    throw std::logic_error("the pivoting that is drawn does not end in the solid alpha complex");
  recorder.first["the front has run dry"] = recorder.panel(front, std::nullopt, {});
  const auto of = [&](const char* heading) {
    Panel panel = recorder.first.at(heading);
    panel.heading = heading;
    return panel;
  };
  return Sheet(
             "Ball pivoting: a seed, a triangle to a free point, an edge that freezes, a triangle to the front, a "
             "curve that "
             "splits, the end",
             42)
      .row({of("a seed"), of("over an edge to a free point"), of("nothing to touch: frozen")})
      .row({of("to a point of the front"), of("the front becomes two curves"), of("the front has run dry")})
      .svg();
}

}  // namespace figures
