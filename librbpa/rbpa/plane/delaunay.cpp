#include "rbpa/plane/delaunay.h"

#include <limits>
#include <string>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/arrays/distinct.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {
namespace {

AlphaComplex triangulated(std::span<const Point> points, const AlphaComplexOptions& options) {
  return alpha_complex(points, std::numeric_limits<double>::infinity(),
                       {.neighbors = true, .threads = options.threads, .progress = options.progress});
}

void check(const AlphaComplex& delaunay, std::span<const Point> points, const GoOn& go_on, const char* function) {
  const auto require = [&](bool is_so, const char* why_not) {
    if (!is_so) throw meshops::ContractViolation(std::string(function) + ": " + why_not);
  };
  constexpr const char* other_points = "the triangulation is of other points than those given";
  require(delaunay.distinct + delaunay.duplicates.size() == points.size(), other_points);
  require(delaunay.triangles.empty() || delaunay.isolated.empty(),
          "the triangulation leaves points out, so it is not the Delaunay triangulation");
  require_duplicates(function, delaunay.duplicates, points.size());
  require_linked(delaunay, points.size(), go_on);
  Steps step(go_on);
  for (const auto& [a, b, c] : delaunay.triangles) {
    step();
    require(Predicates<long double>::orientation(points[a], points[b], points[c]) > 0, other_points);
  }
}

}  // namespace

Delaunay::Delaunay(std::span<const Point> points, const AlphaComplexOptions& options)
    : triangulation_(std::make_shared<const AlphaComplex>(triangulated(points, options))), points_(points) {}

Delaunay::Delaunay(const AlphaComplex& triangulation, std::span<const Point> points, const GoOn& go_on,
                   const char* function)
    : triangulation_(std::shared_ptr<void>(), &triangulation), points_(points) {  // the pointer owns nothing
  check(triangulation, points, go_on, function);
}

Delaunay::Delaunay(AlphaComplex&& triangulation, std::span<const Point> points, const GoOn& go_on, const char* function)
    : triangulation_(std::make_shared<const AlphaComplex>(std::move(triangulation))), points_(points) {
  check(*triangulation_, points, go_on, function);
}

}  // namespace rbpa
