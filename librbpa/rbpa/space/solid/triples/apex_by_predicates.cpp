#include "rbpa/space/solid/triples/apex_by_predicates.h"

#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/predicate/sphere.h"

namespace rbpa::space {

std::optional<Site> exact_apex(std::span<const Point3> sites, std::span<const Site> around, double alpha, Site a,
                               Site b, Site c) {
  std::optional<Site> apex;
  for (const Site p : around) {
    if (p == a || p == b || p == c || orientation(sites[a], sites[b], sites[c], sites[p]) <= 0) continue;
    if (!apex || in_sphere(sites[a], sites[b], sites[c], sites[*apex], sites[p])) apex = p;
  }
  if (!apex || exact::compare_circumradius(sites[a], sites[b], sites[c], sites[*apex], alpha) > 0) return std::nullopt;
  for (const Site p : around)
    if (p != a && p != b && p != c && p != *apex && in_sphere(sites[a], sites[b], sites[c], sites[*apex], sites[p]))
      return std::nullopt;
  return apex;
}

}  // namespace rbpa::space
