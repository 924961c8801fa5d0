#include "rbpa/plane/filtration/delaunay_input.h"

#include <string>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {
namespace {

[[noreturn]] void refuse(const char* function, const char* why) {
  throw meshops::ContractViolation(std::string(function) + ": " + why);
}

}  // namespace

void require_delaunay(const Triangulation& delaunay, std::span<const Point> points, const char* function,
                      const std::function<bool()>& go_on) {
  if (delaunay.distinct + delaunay.duplicates.size() != points.size())
    refuse(function, "the triangulation is of other points than those given");
  if (!delaunay.triangles.empty() && !delaunay.isolated.empty())
    refuse(function, "the triangulation leaves points out, so it is not the Delaunay triangulation");
  require_linked(delaunay, points.size(), go_on);
  for (std::size_t t = 0; t < delaunay.triangles.size(); ++t) {
    if (t % 65536 == 0 && go_on && !go_on()) throw Cancelled();
    const auto [a, b, c] = corners_of(points, delaunay.triangles[t]);
    if (Predicates<long double>::orientation(a, b, c) <= 0)
      refuse(function, "the triangulation is of other points than those given");
  }
}

void require_same(const Filtration& filtration, const Triangulation& delaunay, const char* function) {
  if (filtration.triangle_alpha.size() != delaunay.triangles.size() || filtration.distinct != delaunay.distinct)
    refuse(function, "the filtration is of another triangulation");
}

}  // namespace rbpa
