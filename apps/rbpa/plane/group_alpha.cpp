#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/polygon/write_shapes.h"
#include "io/words.h"
#include "plane/named_groups.h"
#include "plane/radii_run.h"
#include "rbpa/plane/groups.h"
#include "rbpa/plane/smallest_covering_alpha.h"
#include "shared/alpha_report.h"
#include "shared/arguments.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

/// The radii of a group. If the group has no radii, `problem` is the reason.
struct GroupRadii {
  std::size_t points = 0, distinct = 0;
  std::optional<double> least_covering = std::nullopt, least_connected = std::nullopt, plateau = std::nullopt;
  std::optional<Recommendation> best = std::nullopt;
  std::string problem = {};
};

GroupRadii radii_of(const Group& group, const Radii& request) {
  Radii radii = request;
  radii.points = group.points.size();
  const Delaunay delaunay(group.points, {.threads = 1});
  find_radii(delaunay, radii, true);
  GroupRadii found{group.points.size(), radii.filtration.distinct, radii.least_covering, radii.least_connected};
  if (!radii.plateaus.empty()) found.plateau = radii.plateaus.front().alpha;
  found.best = recommended(radii);
  if (const std::optional<std::string> why = why_no_radius(radii.filtration)) found.problem = *why;
  return found;
}

std::string cell(const std::optional<double>& value, int digits) { return value ? rounded(*value, digits) : "none"; }

void write_for_people(OutputFile& out, const NamedGroups& named, const std::vector<GroupRadii>& all) {
  char line[128];
  const auto numbers = [&](const char* points, const char* distinct, const std::string& min,
                           const std::string& connected, const std::string& plateau, const std::string& choice) {
    std::snprintf(line, sizeof line, "%9s %9s %10s %10s %10s  %-11s  ", points, distinct, min.c_str(),
                  connected.c_str(), plateau.c_str(), choice.c_str());
    out.write(line);
  };
  numbers("points", "distinct", "min", "auto", "plateau", "recommended");
  out.write("group\n");
  for (std::size_t g = 0; g < all.size(); ++g) {
    const GroupRadii& of = all[g];
    numbers(std::to_string(of.points).c_str(), std::to_string(of.distinct).c_str(), cell(of.least_covering, 6),
            cell(of.least_connected, 6), cell(of.plateau, 6), of.best ? of.best->choice : "none");
    out.write(printable(named.names[g]) + (of.problem.empty() ? "" : "  (" + of.problem + ")") + "\n");
  }
}

void write_csv(OutputFile& out, const NamedGroups& named, const std::vector<GroupRadii>& all) {
  out.write("group,points,distinct,min,auto,plateau,recommended,problem\n");
  for (std::size_t g = 0; g < all.size(); ++g) {
    const GroupRadii& of = all[g];
    const auto number = [](const std::optional<double>& value) { return value ? text_of(*value) : ""; };
    out.write(csv_text(named.names[g]) + "," + std::to_string(of.points) + "," + std::to_string(of.distinct) + "," +
              number(of.least_covering) + "," + number(of.least_connected) + "," + number(of.plateau) + "," +
              (of.best ? of.best->choice : "") + "," + csv_text(of.problem) + "\n");
  }
}

void write_json(OutputFile& out, const NamedGroups& named, const std::vector<GroupRadii>& all) {
  const auto number = [](const std::optional<double>& value) {
    const std::string text = text_of(value);
    return !value ? std::string("null") : text == "inf" ? "\"inf\"" : text;
  };
  out.write("[");
  for (std::size_t g = 0; g < all.size(); ++g) {
    const GroupRadii& of = all[g];
    out.write(g == 0 ? "\n" : ",\n");
    out.write("{\"group\": " + json_name(named.names[g], named.are_numbers) +
              ", \"points\": " + std::to_string(of.points) + ", \"distinct\": " + std::to_string(of.distinct) +
              ", \"min\": " + number(of.least_covering) + ", \"auto\": " + number(of.least_connected) +
              ", \"plateau\": " + number(of.plateau) + ", \"recommended\": ");
    out.write(of.best ? "{\"choice\": \"" + of.best->choice + "\", \"alpha\": " + number(of.best->alpha) +
                            ", \"why\": \"" + of.best->why + "\"}"
                      : "null");
    if (!of.problem.empty()) out.write(", \"problem\": \"" + of.problem + "\"");
    out.write("}");
  }
  out.write("\n]\n");
}

}  // namespace

void run_group_alpha(const AlphaArguments& arguments) {
  refuse_given({{arguments.persistence, "--persistence"},
                {arguments.complex.has_value(), "--complex"},
                {arguments.picture.has_value(), "-o"},
                {arguments.run.stats.has_value(), "--stats"}},
               not_with_groups);
  const Radii request = parse_radii(arguments);
  const RunOptions options = parse_run(arguments.run);
  const GroupSources sources = parse_group_sources(arguments, arguments);
  require_different({"-"}, sources);
  Run run(sources.files.size() == 1 ? arguments.points : counted(sources.files.size(), "file"), {"-"}, options);
  const NamedGroups named = read_groups(run, sources);
  std::vector<GroupRadii> all(named.groups.size());
  {
    const ProgressLine line = options.line("radii of groups");
    const std::function<bool()> go_on = until_interrupted();
    for_each_group(named.file.points, named.groups,
                   [&](const Group& group) { all[group.number] = radii_of(group, request); },
                   {.threads = options.threads, .go_on = [&](std::size_t) { return go_on(); }});
  }
  run.add("-", [&](OutputFile& out) {
    if (arguments.json)
      write_json(out, named, all);
    else if (arguments.csv)
      write_csv(out, named, all);
    else
      write_for_people(out, named, all);
  });
  run.publish();
}

}  // namespace rbpa::app
