#include "rbpa/rbpa.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>

#include "meshops/core/contract.h"
#include "meshops/core/validate.h"
#include "meshops/front/engine.h"
#include "rbpa/core/error.h"
#include "rbpa/pivot/paper_pivot.h"
#include "rbpa/policy.h"
#include "rbpa/predicate/magnitude.h"

namespace rbpa {
namespace {

/// The shortest text that reads back to the number.
std::string text(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

void check(std::span<const Point> points, double alpha) {
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");
  if (points.size() >= (std::size_t{1} << 30))
    throw InvalidInput(std::to_string(points.size()) + " points, expected fewer than 2^30");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw InvalidInput("point " + std::to_string(i) + " is (" + text(points[i].x) + ", " + text(points[i].y) +
                         "), expected finite coordinates");
}

#ifdef NDEBUG
constexpr bool debug = false;
#else
constexpr bool debug = true;
#endif

/// Asks the caller, now and then, whether to go on. In the debug build, validates the mesh after every triangle while
/// it is small, and each time it has grown by a sixteenth when it is large.
class Report : public meshops::FrontVisitor {
 public:
  Report(const Options& options, std::size_t points) : progress_(options.progress), points_(points) {}

  void seeded(const meshops::Front& front, const meshops::InsertedTriangle&) { count(front); }
  void attached(const meshops::Front& front, meshops::Halfedge, const meshops::InsertedTriangle&) { count(front); }

  /// For the stretches in which no triangle is found.
  void searched(const meshops::Front& front) {
    if (!progress_) return;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(20)) return;
    last_ = now;
    ask(front);
  }

 private:
  void count(const meshops::Front& front) {
    if (debug && front.faces() >= next_validation_) {
      const auto defects = meshops::validate(front.mesh());
      if (!defects.empty()) throw meshops::ContractViolation("rbpa: " + meshops::describe(defects.front()));
      next_validation_ = front.faces() <= 256 ? 0 : front.faces() + front.faces() / 16;
    }
    if (++events_ % interval == 0 && progress_) ask(front);
  }
  void ask(const meshops::Front& front) {
    if (!progress_({front.faces(), points_})) throw Cancelled();
  }

  static constexpr std::size_t interval = 4096;  // triangles: about a millisecond
  const std::function<bool(const Progress&)>& progress_;
  std::size_t points_;
  std::size_t events_ = 0;
  std::size_t next_validation_ = 0;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

template <typename Real>
bool on_a_line(std::span<const Point> points) {
  if (points.size() < 3) return true;
  return std::all_of(points.begin() + 2, points.end(),
                     [&](const Point& p) { return Predicates<Real>::orientation(points[0], points[1], p) == 0; });
}

template <typename Real>
class Run {
 public:
  Run(std::span<const Point> input, Radius radius, Real grid_unit, const Options& options)
      : grid_(input), radius_(radius), grid_unit_(grid_unit), options_(options) {}

  SolidAlphaComplex operator()() {
    const auto points = grid_.points();
    SolidAlphaComplex complex;
    complex.distinct = points.size();
    for (const auto& r : grid_.repetitions()) complex.duplicates.push_back({r.index, r.stands_for});

    // A planar triangulation of n points has fewer than 3n edges and 2n faces; vertices there are a few more while fans
    // on one point wait to grow together. What is not used is never touched.
    complex.mesh.reserve(points.size() + points.size() / 16 + 64, 3 * points.size() + elements_at_a_time,
                         2 * points.size() + elements_at_a_time);
    meshops::Front front(complex.mesh, points.size(), elements_at_a_time);
    if (!on_a_line<Real>(points)) advance(front);

    for (std::size_t s = 0; s < points.size(); ++s)
      if (front.is_free(static_cast<meshops::Site>(s))) complex.isolated.push_back(grid_.input_index()[s]);
    std::sort(complex.isolated.begin(), complex.isolated.end());

    const std::vector<meshops::Site> site = front.finish();
    complex.input_index.resize(site.size());
    for (std::size_t v = 0; v < site.size(); ++v) {
      const auto s = static_cast<std::size_t>(site[v]);
      complex.input_index[v] = grid_.input_index()[s];
      complex.mesh.set_point(meshops::Vertex(static_cast<int>(v)), {points[s].x, points[s].y, 0.0});
    }
    return complex;
  }

 private:
  static constexpr std::size_t elements_at_a_time = debug ? 1 : 4096;  // 1: what is validated has no spare elements

  void advance(meshops::Front& front) {
    const Pivot<Real> pivot(grid_, radius_, grid_unit_);
    if (options_.search == Search::near_to_far)
      advance(front, pivot, pivot);
    else
      advance(front, pivot, PaperPivot<Real>(grid_.points(), grid_.diameter_bound(), radius_, grid_unit_));
  }

  template <typename FrontPivot>
  void advance(meshops::Front& front, const Pivot<Real>& seed_pivot, const FrontPivot& pivot) {
    Seeds<Real> seeds(grid_, radius_, seed_pivot);
    Report report(options_, grid_.points().size());
    RestrictedBallPivoting<Real, FrontPivot, Report> policy(seeds, pivot, report);
    meshops::advance(front, policy, report);
  }

  PointGrid<Real> grid_;
  Radius radius_;
  Real grid_unit_;
  const Options& options_;
};

}  // namespace

SolidAlphaComplex rbpa(std::span<const Point> points, double alpha, const Options& options) {
  check(points, alpha);
  const Magnitude span = magnitude(points);
  if (fits_double(span)) {
    const RadiusBounds bounds = radius_bounds(span);
    const Radius radius = alpha > std::ldexp(1.0, bounds.above_all)
                              ? Radius()
                              : Radius(std::max(alpha, std::ldexp(1.0, bounds.below_all)));
    return Run<double>(points, radius, std::ldexp(1.0, span.lowest), options)();
  }
  const Radius radius = std::isinf(alpha) ? Radius() : Radius(alpha);
  return Run<long double>(points, radius, 0.0L, options)();
}

std::vector<std::array<std::uint32_t, 3>> triangles(const SolidAlphaComplex& complex) {
  std::vector<std::array<std::uint32_t, 3>> result(complex.mesh.n_faces());
  for (std::size_t f = 0; f < result.size(); ++f) {
    auto h = complex.mesh.halfedge_handle(meshops::Face(static_cast<int>(f)));
    for (std::uint32_t& corner : result[f]) {
      corner = complex.input_index[static_cast<std::size_t>(complex.mesh.to_vertex_handle(h).idx())];
      h = complex.mesh.next_halfedge_handle(h);
    }
    std::rotate(result[f].begin(), std::min_element(result[f].begin(), result[f].end()), result[f].end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace rbpa
