#include "cli/method.h"

#include "cli/build.h"
#include "cli/progress.h"
#include "io/failure.h"
#include "io/whole_number.h"

namespace rbpa::app {
namespace {

Search parse_search(const std::string& text) {
  if (text == "near") return Search::near_to_far;
  if (text == "paper") return Search::paper;
  throw WrongUsage("--search: found " + in_quotes(text) + ", expected near or paper");
}

}  // namespace

Method parse_method(const MethodArguments& arguments) {
  Method method{.search = parse_search(arguments.search)};
  if (arguments.method != "rbpa" && arguments.method != "hrbpa")
    throw WrongUsage("--method: found " + in_quotes(arguments.method) + ", expected rbpa or hrbpa");
  const bool hierarchical = arguments.method == "hrbpa";
  if (arguments.leaf_capacity && !hierarchical)
    throw WrongUsage("--leaf-capacity: found --method rbpa, expected hrbpa, which has leaves");
  if (hierarchical)
    method.leaf_capacity = arguments.leaf_capacity
                               ? parse_whole("--leaf-capacity", *arguments.leaf_capacity, {.least = 1}, "points")
                               : usual_leaf_capacity(method.search);
  return method;
}

Hierarchy build(const std::vector<Point>& points, double alpha, const Method& method, const RunOptions& run) {
  if (!method.leaf_capacity) return {.complex = build(points, alpha, run, method.search), .levels = {}};
  TriangleProgress progress(!run.quiet);
  return hrbpa(points, alpha,
               {.search = method.search,
                .leaf_capacity = *method.leaf_capacity,
                .threads = run.threads,
                .progress = progress.watch()});
}

}  // namespace rbpa::app
