#include "rbpa/space/balls/full/faces_within.h"

#include "rbpa/space/predicate/least_sphere.h"
#include "rbpa/space/predicate/orthosphere.h"
#include "rbpa/space/predicate/outer_faces.h"

namespace rbpa::space {

bool is_center_in_cell(const Triangulated& regular, std::span<const double> ball_radii, std::uint32_t i,
                       std::span<const std::uint32_t> star) {
  const Ball own = {regular.positions[i], ball_radii[i]};
  return std::none_of(star.begin(), star.end(), [&](std::uint32_t t) {
    return std::any_of(regular.simplices[t].begin(), regular.simplices[t].end(), [&](std::uint32_t other) {
      return other != i && is_conflict(own, {regular.positions[other], ball_radii[other]});
    });
  });
}

bool is_edge_alone(const Triangulated& delaunay, std::span<const EdgeAt> ring, double alpha) {
  const auto end = [&](const EdgeAt& at, std::size_t k) -> const Point3& {
    return delaunay.position(at.tetrahedron, k);
  };
  if (!is_least_sphere_within(end(ring[0], ring[0].from), end(ring[0], ring[0].to), alpha)) return false;
  return std::none_of(ring.begin(), ring.end(), [&](const EdgeAt& at) {
    const auto [k, l] = others(at);
    const Point3 &a = end(at, at.from), &b = end(at, at.to);
    return in_least_sphere(a, b, end(at, k)) || in_least_sphere(a, b, end(at, l));
  });
}

namespace {

class WithinAlpha : public SimplexRule {
 public:
  WithinAlpha(const Triangulated& delaunay, std::span<const double> radii, double alpha)
      : delaunay_(delaunay), radii_(radii), alpha_(alpha) {}

  bool has_tetrahedron(std::uint32_t t) const override { return radii_[t] <= alpha_; }
  bool has_triangle_beside(std::uint32_t t, std::size_t k) const override {
    const auto face = [&](std::size_t i) -> const Point3& { return delaunay_.position(t, outer_faces[k][i]); };
    const LeastSphere sphere(face(0), face(1), face(2));
    return sphere.is_within(alpha_) && !sphere.has_inside(delaunay_.position(t, k));
  }
  bool has_edge(std::span<const EdgeAt> ring) const override { return is_edge_alone(delaunay_, ring, alpha_); }

 private:
  Triangulated delaunay_;
  std::span<const double> radii_;
  double alpha_;
};

class OfBalls : public SimplexRule {
 public:
  OfBalls(const Triangulated& regular, std::span<const double> radii) : regular_(regular), radii_(radii) {}

  bool has_tetrahedron(std::uint32_t t) const override {
    return least_power_sign(ball(t, 0), ball(t, 1), ball(t, 2), ball(t, 3)) <= 0;
  }
  bool has_triangle_beside(std::uint32_t t, std::size_t k) const override {
    const Ball a = ball(t, outer_faces[k][0]), b = ball(t, outer_faces[k][1]), c = ball(t, outer_faces[k][2]);
    return least_power_sign(a, b, c) <= 0 && !is_conflict(a, b, c, ball(t, k));
  }
  bool has_edge(std::span<const EdgeAt> ring) const override {
    const auto end = [&](std::size_t k) { return ball(ring[0].tetrahedron, k); };
    const Ball a = end(ring[0].from), b = end(ring[0].to);
    return least_power_sign(a, b) <= 0 && std::none_of(ring.begin(), ring.end(), [&](const EdgeAt& at) {
             const auto [k, l] = others(at);
             return is_conflict(a, b, ball(at.tetrahedron, k)) || is_conflict(a, b, ball(at.tetrahedron, l));
           });
  }

 private:
  Ball ball(std::uint32_t t, std::size_t k) const {
    return {regular_.position(t, k), radii_[regular_.simplices[t][k]]};
  }

  Triangulated regular_;
  std::span<const double> radii_;
};

}  // namespace

FacesWithin::FacesWithin(const Triangulated& delaunay, std::span<const double> radii, double alpha, Threads& threads,
                         const GoOn& go_on)
    : FacesWithin(delaunay, std::make_shared<WithinAlpha>(delaunay, radii, alpha), threads, go_on) {}

FacesWithin::FacesWithin(const Triangulated& regular, std::span<const double> ball_radii, Threads& threads,
                         const GoOn& go_on)
    : FacesWithin(regular, std::make_shared<OfBalls>(regular, ball_radii), threads, go_on) {}

FacesWithin::FacesWithin(const Triangulated& cells, std::shared_ptr<const SimplexRule> rule, Threads& threads,
                         const GoOn& go_on)
    : delaunay_(cells),
      rule_(std::move(rule)),
      has_tetrahedron_(cells.simplices.size()),
      has_triangle_(4 * cells.simplices.size()) {
  constexpr std::size_t at_a_time = 1u << 12;
  const auto& neighbors = delaunay_.neighbors;
  // Returns the corner of the tetrahedron beyond corner k's face that is across from t.
  const auto back = [&](std::uint32_t t, std::size_t k) {
    const auto& others = neighbors[neighbors[t][k]];
    return static_cast<std::size_t>(std::find(others.begin(), others.end(), t) - others.begin());
  };
  const auto is_alone_within = [&](std::uint32_t t, std::size_t k) {
    return rule_->has_triangle_beside(t, k) &&
           (is_on_hull(t, k) || rule_->has_triangle_beside(neighbors[t][k], back(t, k)));
  };
  CheckpointOfThreads checkpoint(go_on);
  const auto for_each_tetrahedron = [&](const auto& visit) {
    for_each_part(threads, has_tetrahedron_.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
      checkpoint();
      for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t) visit(t);
    });
  };
  for_each_tetrahedron([&](std::uint32_t t) {
    const bool is_at_hull = std::find(neighbors[t].begin(), neighbors[t].end(), Solid::none) != neighbors[t].end();
    if (rule_->has_tetrahedron(t)) has_tetrahedron_[t] = is_at_hull ? 1 : 2;
  });
  // Each triangle is decided at its first tetrahedron; the second copies the result.
  for_each_tetrahedron([&](std::uint32_t t) {
    for (std::size_t k = 0; k < 4; ++k)
      if (is_first(t, k)) has_triangle_[4 * std::size_t{t} + k] = tetrahedra_at(t, k) > 0 || is_alone_within(t, k);
  });
  for_each_tetrahedron([&](std::uint32_t t) {
    for (std::size_t k = 0; k < 4; ++k)
      if (!is_first(t, k))
        has_triangle_[4 * std::size_t{t} + k] = has_triangle_[4 * std::size_t{neighbors[t][k]} + back(t, k)];
  });
}

}  // namespace rbpa::space
