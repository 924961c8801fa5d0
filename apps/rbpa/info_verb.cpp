#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "io/box.h"
#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/polygon/write_shapes.h"
#include "io/sort.h"
#include "plane/named_groups.h"
#include "shared/arguments.h"
#include "shared/run.h"
#include "shared/stats.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

struct Info {
  std::size_t points = 0;
  std::size_t distinct = 0;
  std::optional<Box> box = std::nullopt;  ///< nullopt if there are no points
  std::optional<Crs> crs = std::nullopt;
  std::optional<ScanFacts> scan = std::nullopt;  ///< nullopt unless the points come from a laser scan
  bool flattened = false;                        ///< whether the points have different heights, which are ignored
  std::optional<double> spacing = std::nullopt;  ///< √(area of the box / distinct points); nullopt if the area is 0
};

Info examine(std::vector<Point> points, const RunOptions& run) {
  const ProgressLine line = run.line("sorting " + short_number(static_cast<double>(points.size())) + " points");
  Info info{.points = points.size()};
  if (points.empty()) return info;
  sort(points);
  info.distinct = static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
  Box box;
  InterruptibleSteps step;
  for (std::size_t i = 0; i < info.distinct; ++i) {
    step();
    box.add(points[i]);
  }
  info.box = box;
  // Halve the sides, and multiply roots, so that nothing overflows.
  const double half_width = box.greatest.x / 2 - box.least.x / 2, half_height = box.greatest.y / 2 - box.least.y / 2;
  const double spacing =
      2 * std::sqrt(half_width) * (std::sqrt(half_height) / std::sqrt(static_cast<double>(info.distinct)));
  if (spacing > 0) info.spacing = spacing;
  return info;
}

std::string version_of(const ScanFacts& scan) { return "1." + std::to_string(scan.minor); }

std::string for_people(const Info& info) {
  std::string text = "points      " + std::to_string(info.points) + "\n";
  text += "distinct    " + std::to_string(info.distinct) + "\n";
  text += "duplicates  " + std::to_string(info.points - info.distinct) +
          (info.flattened && info.points > info.distinct ? "  (of x and y; z was ignored)\n" : "\n");
  if (info.crs) text += "crs         " + info.crs->text() + "\n";
  if (info.box) {
    text += "box         x " + text_of(info.box->least.x) + " .. " + text_of(info.box->greatest.x) + "\n";
    text += "            y " + text_of(info.box->least.y) + " .. " + text_of(info.box->greatest.y) + "\n";
  } else {
    text += "box         none\n";
  }
  text += "spacing     " + (info.spacing ? rounded(*info.spacing, 4) : "none") +
          "  (square root of box area / distinct points)\n";
  if (!info.scan) return text;
  const ScanFacts& scan = *info.scan;
  text += "format      LAS " + version_of(scan) + ", point format " + std::to_string(scan.format) +
          (scan.compressor > 0 ? ", LASzip " + std::to_string(scan.compressor) + (scan.is_copc ? ", COPC" : "")
                               : ", not compressed") +
          "\n";
  for (const auto& [name, numbers] : {std::pair("scale       ", scan.scale), {"offset      ", scan.offset}})
    text += name + text_of(numbers[0]) + " " + text_of(numbers[1]) + " " + text_of(numbers[2]) + "\n";
  const auto counts = [&](const char* name, std::span<const std::size_t> points) {
    std::string list;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i] > 0) list += (list.empty() ? "" : ", ") + std::to_string(i) + ": " + std::to_string(points[i]);
    text += name + (list.empty() ? "none" : list) + "\n";
  };
  counts("classes     ", scan.classes);
  counts("returns     ", scan.returns);
  return text;
}

using Json = nlohmann::ordered_json;

Json json_of(const Info& info) {
  Json box = nullptr;
  if (info.box)
    box = {{"min", Json::array({info.box->least.x, info.box->least.y})},
           {"max", Json::array({info.box->greatest.x, info.box->greatest.y})}};
  return {{"points", info.points},
          {"distinct", info.distinct},
          {"duplicates", info.points - info.distinct},
          {"box", box},
          {"spacing", info.spacing ? Json(*info.spacing) : Json(nullptr)}};
}

std::string as_json(const Info& info) {
  Json report = json_of(info);
  if (info.crs) report["crs"] = info.crs->text();
  if (info.scan) {
    const ScanFacts& scan = *info.scan;
    const auto counts = [](std::span<const std::size_t> points) {
      Json object = Json::object();
      for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i] > 0) object[std::to_string(i)] = points[i];
      return object;
    };
    report["las"] = {{"version", version_of(scan)},
                     {"point_format", scan.format},
                     {"laszip", scan.compressor > 0 ? Json(scan.compressor) : Json(nullptr)},
                     {"copc", scan.is_copc},
                     {"scale", scan.scale},
                     {"offset", scan.offset},
                     {"classes", counts(scan.classes)},
                     {"returns", counts(scan.returns)}};
  }
  return report.dump(2) + "\n";
}

/// Writes a table with a line for each group of points; with `json`, a list with an object for each group.
void write_groups(OutputFile& out, const NamedGroups& named, bool json) {
  char line[160];
  const auto row = [&](const std::string& points, const std::string& distinct, const std::string& spacing,
                       const std::string& x, const std::string& y) {
    std::snprintf(line, sizeof line, "%9s %9s %10s  %-23s %-23s  ", points.c_str(), distinct.c_str(), spacing.c_str(),
                  x.c_str(), y.c_str());
    out.write(line);
  };
  const auto range = [](double least, double greatest) { return rounded(least, 8) + " .. " + rounded(greatest, 8); };
  if (json) {
    out.write("[");
  } else {
    row("points", "distinct", "spacing", "x", "y");
    out.write("group\n");
  }
  for (std::size_t g = 0; g < named.groups.size(); ++g) {
    if (g % 256 == 0) stop_if_interrupted();
    std::vector<Point> points;
    for (const std::uint32_t i : named.groups[g]) points.push_back(named.file.points[i]);
    const Info info = examine(std::move(points), {.quiet = true});
    if (json) {
      const std::string facts = json_of(info).dump();
      out.write((g == 0 ? "\n{\"group\":" : ",\n{\"group\":") + json_name(named.names[g], named.are_numbers) + "," +
                facts.substr(1));
      continue;
    }
    row(std::to_string(info.points), std::to_string(info.distinct), info.spacing ? rounded(*info.spacing, 4) : "none",
        info.box ? range(info.box->least.x, info.box->greatest.x) : "none",
        info.box ? range(info.box->least.y, info.box->greatest.y) : "none");
    out.write(printable(named.names[g]) + "\n");
  }
  if (json) out.write("\n]\n");
}

void run_group_info(const InfoArguments& arguments) {
  refuse_given({{arguments.run.stats.has_value(), "--stats"}}, not_with_groups);
  const GroupSources sources = parse_group_sources(arguments, arguments);
  require_different({"-"}, sources);
  Run run(sources.files.size() == 1 ? arguments.points : counted(sources.files.size(), "file"), {"-"},
          parse_run(arguments.run));
  const NamedGroups named = read_groups(run, sources);
  run.add("-", [&](OutputFile& out) { write_groups(out, named, arguments.json); });
  run.publish();
}

}  // namespace

void run_info(const InfoArguments& arguments) {
  if (arguments.has_groups()) return run_group_info(arguments);
  PointSource source = parse_source(arguments);
  source.scan_counts = true;
  std::vector<std::string> outputs = given({"-", arguments.run.stats});
  require_different(outputs, arguments.points, "points");
  Run run(arguments.points, outputs, parse_run(arguments.run));
  PointFile file = run.read_points(source);
  const double read_seconds = run.lap();
  Info info = examine(std::move(file.points), run.options());
  info.crs = file.crs;
  info.scan = file.scan;
  info.flattened = file.heights.differ();

  run.add_stats([&](OutputFile& report) {
    write_stats(report, {.points = info.points, .distinct = info.distinct, .read_seconds = read_seconds});
  });
  run.add("-", [&](OutputFile& out) { out.write(arguments.json ? as_json(info) : for_people(info)); });
  run.publish();
}

}  // namespace rbpa::app
