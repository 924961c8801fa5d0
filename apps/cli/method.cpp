#include "cli/method.h"

#include "cli/progress.h"
#include "io/bytes/number.h"
#include "io/failure.h"
#include "rbpa/paper.h"

namespace rbpa::app {
namespace {

bool is_by_paper(const std::string& search) {
  if (search != "near" && search != "paper")
    throw WrongUsage("--search: found " + in_quotes(search) + ", expected near or paper");
  return search == "paper";
}

}  // namespace

Method parse_method(const MethodArguments& arguments) {
  Method method{.by_paper = is_by_paper(arguments.search)};
  if (arguments.method != "rbpa" && arguments.method != "hrbpa")
    throw WrongUsage("--method: found " + in_quotes(arguments.method) + ", expected rbpa or hrbpa");
  const bool hierarchical = arguments.method == "hrbpa";
  if (arguments.leaf_capacity && !hierarchical)
    throw WrongUsage("--leaf-capacity: found --method rbpa, expected hrbpa, which has leaves");
  if (hierarchical)
    method.leaf_capacity = arguments.leaf_capacity
                               ? parse_whole("--leaf-capacity", *arguments.leaf_capacity, {.least = 1}, "points")
                           : method.by_paper ? paper::usual_leaf_capacity
                                             : usual_leaf_capacity;
  return method;
}

Hierarchy build(const std::vector<Point>& points, double alpha, const Method& method, const RunOptions& run) {
  TriangleProgress progress(!run.quiet);
  if (!method.leaf_capacity) {
    const auto of_one_radius = method.by_paper ? paper::rbpa : rbpa;
    return {.complex = of_one_radius(points, alpha, {.threads = run.threads, .progress = progress.watch()}),
            .levels = {}};
  }
  const auto by_levels = method.by_paper ? paper::hrbpa : hrbpa;
  return by_levels(points, alpha,
                   {.leaf_capacity = *method.leaf_capacity, .threads = run.threads, .progress = progress.watch()});
}

}  // namespace rbpa::app
