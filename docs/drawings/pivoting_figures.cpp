#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <stdexcept>

#include "drawings/ball_in_plane.h"
#include "drawings/drawn_complex.h"
#include "drawings/drawn_front.h"
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

/// State of a run after one of its events.
struct Moment {
  enum class Event { seeded, attached, frozen } event;
  DrawnMesh drawn;
  std::set<Edge> active;
  std::optional<Face> fresh;  ///< the new triangle
  bool to_front = false;      ///< the apex of the triangle was on the front already
  bool splits = false;        ///< a curve of the front has become two
  std::vector<Disc> balls;    ///< before, then after
  std::size_t triangles, frozen;
};

/// Visitor that records every moment of a run.
class Recorder : public meshops::FrontVisitor {
 public:
  Recorder(const Mesh& mesh, const std::vector<Place>& places, double alpha)
      : mesh_(mesh), places_(places), ball_(places, alpha) {}

  void seeded(const Front& front, const meshops::InsertedTriangle& triangle) {
    std::array<Site, 3> corner{};
    for (std::size_t i = 0; i < 3; ++i) corner[i] = front.to_site(triangle.side[i]);
    keep(front, Moment::Event::seeded, triangle.face, {ball_.on(corner[0], corner[1], corner[2])});
  }
  void attached(const Front& front, Halfedge h, const meshops::InsertedTriangle& triangle) {
    keep(front, Moment::Event::attached, triangle.face, {at_rest_right_of(front, h), at_rest_left_of(front, h)});
  }
  void frozen(const Front& front, Halfedge h) {
    frozen_.insert(h);
    keep(front, Moment::Event::frozen, std::nullopt,
         {at_rest_right_of(front, h), ball_.largest_left_of(front.from_site(h), front.to_site(h))});
  }
  static constexpr bool follows_curves = true;
  void curve_split(const Front&, Halfedge, Halfedge) { moments_.back().splits = true; }
  const std::vector<Moment>& moments() const { return moments_; }

 private:
  /// Returns the ball at rest on the triangle left of a halfedge.
  Disc at_rest_left_of(const Front& front, Halfedge h) const {
    return ball_.on(front.from_site(h), front.to_site(h), front.to_site(mesh_.next_halfedge_handle(h)));
  }
  Disc at_rest_right_of(const Front& front, Halfedge h) const {
    return at_rest_left_of(front, mesh_.opposite_halfedge_handle(h));
  }
  void keep(const Front& front, Moment::Event event, std::optional<Face> fresh, std::vector<Disc> balls) {
    Moment moment{event, drawn_front(front, mesh_, places_), {}, fresh, false, false, std::move(balls), front.faces(),
                  0};
    meshops::for_each_halfedge(mesh_, [&](Halfedge h) {
      if (!mesh_.is_boundary(h)) return;
      if (frozen_.contains(h))
        ++moment.frozen;
      else
        moment.active.insert(mesh_.edge_handle(h));
    });
    std::size_t free = 0;
    for (Site s = 0; s < static_cast<Site>(front.sites()); ++s) free += front.is_free(s) ? 1U : 0U;
    moment.to_front = event == Moment::Event::attached && free == free_;
    free_ = free;
    moments_.push_back(std::move(moment));
  }

  const Mesh& mesh_;
  const std::vector<Place>& places_;
  BallInPlane ball_;
  std::set<Halfedge> frozen_;
  std::size_t free_ = 0;
  std::vector<Moment> moments_;
};

Panel panel_of(const Moment& moment, const std::string& heading) {
  Marks marks;
  marks.edges = moment.active;
  if (moment.fresh) marks.add(*moment.fresh);
  Panel panel{moment.drawn, marks};
  panel.heading = heading;
  panel.caption = {"triangles " + std::to_string(moment.triangles) + " · active " +
                   std::to_string(moment.active.size()) + " · frozen " + std::to_string(moment.frozen)};
  for (const Disc& ball : moment.balls)
    for (const Place corner : {Place{-1, -1}, {1, 1}}) panel.extent.push_back(ball.center + ball.radius * corner);
  panel.more = [balls = moment.balls](Canvas& canvas, const Frame& frame) {
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

/// Throws unless the triangles equal those of the library, so that no wrong figure is drawn.
void require_complex(const Front& front, const Points& points, double alpha) {
  std::vector<std::array<std::uint32_t, 3>> drawn;
  meshops::for_each_face(front.mesh(), [&](Face f) {
    std::array<std::uint32_t, 3> corners{};
    std::size_t i = 0;
    for (const Vertex v : front.mesh().fv_range(f)) corners[i++] = static_cast<std::uint32_t>(front.site(v));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    drawn.push_back(corners);
  });
  std::sort(drawn.begin(), drawn.end());
  if (drawn != rbpa::triangles(rbpa::rbpa(points, alpha)))
    throw std::logic_error("the pivoting that is drawn does not end in the solid alpha complex");
}

std::string paper_2_pivoting() {
  const std::vector<Place> places = {{1.5, 1.5},   {2.1, 0.6},  {2.7, 1.55}, {1.0, 0.55}, {0.4, 1.6},  {0.95, 2.4},
                                     {2.05, 2.35}, {3.1, 0.65}, {3.65, 1.5}, {4.2, 0.5},  {4.8, 1.45}, {4.15, 2.45},
                                     {5.25, 2.3},  {0.45, 3.3}, {1.6, 3.25}, {2.65, 3.3}, {3.7, 3.35}, {4.75, 3.2},
                                     {2.15, 4.15}, {3.2, 4.2},  {4.3, 4.1},  {6.3, 3.7}};
  constexpr double alpha = 0.85;
  Points points;
  for (const Place p : places) points.push_back({p.x, p.y});
  Mesh mesh;
  Front front(mesh, places.size());
  rbpa::paper::RestrictedBallPivoting policy(points, front.next_level().carried, rbpa::Radius(alpha));
  Recorder recorder(mesh, places, alpha);
  meshops::advance(front, policy, recorder);
  require_complex(front, points, alpha);

  const std::vector<Moment>& moments = recorder.moments();
  const auto first = [&](auto&& wanted) -> const Moment& {
    const auto found = std::find_if(moments.begin(), moments.end(), wanted);
    if (found == moments.end()) throw std::logic_error("the run has no moment of this kind");
    return *found;
  };
  using Event = Moment::Event;
  Moment last = moments.back();
  last.balls.clear();
  Sheet sheet(
      "Ball pivoting: a seed, a triangle to a free point, an edge that freezes, a triangle to the front, a curve that "
      "splits, the end",
      42);
  sheet.row({panel_of(moments.front(), "a seed"),
             panel_of(first([](const Moment& m) { return m.event == Event::attached && !m.to_front; }),
                      "over an edge to a free point"),
             panel_of(first([](const Moment& m) { return m.event == Event::frozen; }), "nothing to touch: frozen")});
  sheet.row({panel_of(first([](const Moment& m) { return m.event == Event::attached && m.to_front; }),
                      "to a point of the front"),
             panel_of(first([](const Moment& m) { return m.splits; }), "the front becomes two curves"),
             panel_of(last, "the front has run dry")});
  return sheet.svg();
}

}  // namespace

std::span<const Figure> pivoting_figures() {
  static constexpr std::array figures = {Figure{"paper_2_pivoting", paper_2_pivoting}};
  return figures;
}

}  // namespace figures
