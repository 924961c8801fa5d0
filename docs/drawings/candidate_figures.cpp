#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "drawings/ball_in_plane.h"
#include "drawings/caption.h"
#include "drawings/drawn_complex.h"
#include "drawings/figures.h"
#include "drawings/sheet.h"
#include "rbpa/paper/circle.h"

namespace figures {
namespace {

using meshops::Site;

/// Point left of the edge, and the angle in degrees under which it sees the edge.
struct Candidate {
  Site site;
  double angle;
};

/// Ends of the edge and third point of the triangle behind it, as indices into `places`, which also has the points
/// around.
constexpr Site a = 0, b = 1, behind = 2;
const std::vector<Place> places = {{0, 0},       {2, 0},    {0.9, -1.9}, {1.3, 1.7},   {0.15, 2.15}, {2.6, 1.65},
                                   {1.05, 2.95}, {-1.0, 1}, {3.25, 0.8}, {-0.9, -1.3}, {2.9, -1.4}};
constexpr double alpha = 1.75;

std::vector<Candidate> candidates() {
  constexpr double degrees = 180 / 3.14159265358979323846;
  std::vector<Candidate> found;
  for (Site s = 0; s < places.size(); ++s) {
    const Place e = places[s] - places[a], f = places[s] - places[b];
    if (s == a || s == b || cross(places[b] - places[a], e) <= 0) continue;
    found.push_back({s, degrees * std::atan2(cross(e, f), dot(e, f))});
  }
  std::sort(found.begin(), found.end(), [](const Candidate& l, const Candidate& r) { return l.angle > r.angle; });
  return found;
}

/// Returns the answer of the paper's pivot. Throws unless it is the first candidate, so that no wrong figure is drawn.
Site apex_of(const std::vector<Candidate>& candidates) {
  Points points;
  std::vector<Site> sites;
  for (const Place p : places) {
    sites.push_back(static_cast<Site>(points.size()));
    points.push_back({p.x, p.y});
  }
  const rbpa::paper::Ball ball(points, sites, rbpa::Radius::of(alpha));
  if (ball.pivot(a, b) != candidates.front().site)
    throw std::logic_error("the ball does not touch the point that sees the edge under the largest angle");
  return candidates.front().site;
}

void draw_ball(Canvas& canvas, const Frame& frame, const Disc& ball, const Stroke& stroke, double dot) {
  canvas.circle(frame(ball.center), frame.scale * ball.radius, stroke);
  canvas.dot(frame(ball.center), dot, stroke.color);
}

std::string paper_3_candidate() {
  const std::vector<Candidate> seen = candidates();
  const Site apex = apex_of(seen);
  const BallInPlane ball(places, alpha);
  const double from = ball.half_chords(a, b, behind), to = ball.half_chords(a, b, apex);
  const Disc at_rest = ball.on(a, b, apex);

  const Corners first = {static_cast<std::uint32_t>(behind), static_cast<std::uint32_t>(b),
                         static_cast<std::uint32_t>(a)};
  Panel turning{drawn_mesh(places, {first}), {}};
  turning.marks.add(turning.drawn.mesh.edge_handle(turning.drawn.boundary_between(a, b)));
  turning.marks.labels = {{places[a] + Place{-0.22, -0.1}, "a"}, {places[b] + Place{0.22, -0.1}, "b"}};
  turning.heading = "(a) the ball turns over the edge ab";
  turning.caption = {"circles through a and b, until one",
                     "touches a point: radius " + rounded(at_rest.radius) + " ≤ α = " + rounded(alpha)};
  turning.more = [=](Canvas& canvas, const Frame& frame) {
    constexpr int steps = 4;
    for (int i = 1; i < steps; ++i) {
      const Disc between = ball.on_edge(a, b, from + (to - from) * i / steps);
      canvas.circle(frame(between.center), frame.scale * between.radius, {color::pale, 1});
    }
    draw_ball(canvas, frame, ball.on_edge(a, b, from), {color::inner, 1, true}, 2.2);
    draw_ball(canvas, frame, at_rest, {color::text, 1.6}, 2.2);
    canvas.arrow({frame(ball.on_edge(a, b, from).center), frame(at_rest.center), {}}, {color::text, 1.2}, 7);
  };

  const Corners second = {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                          static_cast<std::uint32_t>(apex)};
  Panel angles{drawn_mesh(places, {first, second}), {}};
  angles.marks = turning.marks;
  angles.marks.edges = {angles.drawn.mesh.edge_handle(angles.drawn.between(a, b))};
  angles.marks.faces = {Face(1)};
  angles.heading = "(b) the largest angle";
  angles.caption = {"the point that sees ab under the largest", "angle has the first circle, and it is empty"};
  angles.more = [=](Canvas& canvas, const Frame& frame) {
    std::vector<Segment> sights;
    for (const Candidate& c : seen)
      for (const Site end : {a, b})
        if (c.site != apex) sights.push_back({frame(places[c.site]), frame(places[end]), {}});
    canvas.segments(sights, {color::pale, 1});
    draw_ball(canvas, frame, at_rest, {color::text, 1.6}, 2.2);
    for (const Candidate& c : seen)
      canvas.text(frame(places[c.site]) - Place{0, 9}, rounded(c.angle, "%.0f") + "°",
                  c.site == apex ? Lettering::plain : Lettering::small, Align::middle);
  };
  for (Panel* panel : {&turning, &angles}) {
    panel->extent.push_back({1, 3.3});  // room for the angle of the highest point
    for (const double half_chords : {from, to})
      for (const Place corner : {Place{-1, -1}, {1, 1}}) {
        const Disc disc = ball.on_edge(a, b, half_chords);
        panel->extent.push_back(disc.center + disc.radius * corner);
      }
  }
  return Sheet("Which point the ball touches first: the one that sees the edge under the largest angle", 62)
      .row({turning, angles})
      .svg();
}

}  // namespace

std::span<const Figure> candidate_figures() {
  static constexpr std::array figures = {Figure{"paper_3_candidate", paper_3_candidate}};
  return figures;
}

}  // namespace figures
