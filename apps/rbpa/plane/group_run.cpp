#include "plane/group_run.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "rbpa/rbpa.h"
#include "shared/arguments.h"

namespace rbpa::app {

GroupRequest parse_group_request(const ComplexArguments& arguments, const std::vector<Target>& targets) {
  const AlphaOption alpha = parse_alpha(arguments.radius, ChosenFor::groups);
  const GroupSources sources = parse_group_sources(arguments, arguments, alpha.column);
  const GroupRequest request{
      .complex = parse_request(arguments, ChosenFor::groups), .sources = sources, .targets = targets};
  std::vector<std::string> outputs = given({arguments.run.stats});
  for (const Target& target : targets) outputs.push_back(target.path);
  require_different(outputs, request.sources);
  return request;
}

namespace {

/// Returns the radius of each group, or the rule that chooses the radii. The result refers to the radii of `named`.
GroupAlpha group_alpha(const AlphaOption& option, const NamedGroups& named) {
  GroupAlpha alpha{.choice = option};
  if (option.column) alpha.given = named.radii;
  return alpha;
}

/// Replaces the problem in `shapes` by the reason in `named` for each group whose column of radii gives no radius.
void explain_radii(const NamedGroups& named, GroupShapes& shapes) {
  if (named.radius_problems.empty()) return;
  for (GroupProblem& problem : shapes.problems)
    if (!named.radius_problems[problem.group].empty()) problem.what = named.radius_problems[problem.group];
}

/// Returns the points that equal others of their group; none if the points have no heights.
std::vector<Duplicate> duplicates_in_groups(const NamedGroups& named) {
  std::vector<Duplicate> duplicates;
  if (named.file.z.empty()) return duplicates;
  const std::vector<Point>& points = named.file.points;
  for (std::size_t g = 0; g < named.groups.size(); ++g) {
    const std::span<const std::uint32_t> members = named.groups[g];
    std::vector<std::uint32_t> group(members.begin(), members.end());
    std::sort(group.begin(), group.end(), [&](std::uint32_t a, std::uint32_t b) {
      return points[a] < points[b] || (points[a] == points[b] && a < b);
    });
    for (std::size_t k = 1; k < group.size(); ++k) {
      const bool is_again = !duplicates.empty() && duplicates.back().index == group[k - 1];
      if (points[group[k]] == points[group[k - 1]])
        duplicates.push_back({group[k], is_again ? duplicates.back().stands_for : group[k - 1]});
    }
  }
  return duplicates;
}

}  // namespace

GroupRun::GroupRun(const GroupRequest& wanted, const ComplexArguments& arguments, GroupShapesOptions shape_options)
    : Run(wanted.sources.files.size() == 1 ? arguments.points : counted(wanted.sources.files.size(), "file"),
          arguments.outputs, wanted.complex.options),
      request(wanted),
      named(read_groups(*this, request.sources)) {
  take_lowest_heights(duplicates_in_groups(named), named.file.z);
  complete_heights(named.file.z);
  stats.points = named.file.points.size();
  stats.read_seconds = lap();
  {
    const ProgressLine line = options().line("shapes of groups");
    shape_options.threads = options().threads;
    shape_options.go_on = [go_on = until_interrupted()](std::size_t) { return go_on(); };
    shapes =
        shapes_of_groups(named.file.points, named.groups, group_alpha(request.complex.alpha, named), shape_options);
  }
  explain_radii(named, shapes);
  stats.build_seconds = lap();
  for (std::size_t g = 0; g < named.groups.size(); ++g) sizes.push_back(named.groups[g].size());
}

NamedShapes GroupRun::named_shapes() const {
  return {named.file.points, named.names, named.are_numbers, sizes, shapes, named.file.crs, named.file.degrees};
}

void GroupRun::finish() {
  const AlphaOption& alpha = request.complex.alpha;
  if (options().stats) {
    stats.write_seconds = lap();
    stats.threads = threads_used(named.file.points.size(), options().threads);
    stats.alpha_rule = name_of(alpha);
    if (alpha.rule == AlphaRule::given && !alpha.column) stats.alpha = alpha.radius;
    stats.groups = GroupStats{named.names.size(), shapes.problems.size(), triangles()};
    stats.polygons = shapes.polygons.size();
    stats.of_polygons = total(shapes.polygons);
    add_stats([&](OutputFile& out) { write_stats(out, stats); });
  }
  publish();
  if (shapes.problems.empty()) return;
  const GroupProblem& first = shapes.problems.front();
  warning(counted(shapes.problems.size(), "group") +
          " without a polygon: " + (shapes.problems.size() == 1 ? "" : "the first is ") +
          in_quotes(named.names[first.group]) + ", " + first.what);
}

void GroupRun::summarize(const std::string& made) const {
  Run::summarize(counted(named.file.points.size(), "point") + ", " + counted(named.names.size(), "group") + ", " +
                 made + list_of(request.targets));
}

}  // namespace rbpa::app
