#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/arguments.h"
#include "cli/run.h"
#include "cli/stats.h"
#include "cli/verbs.h"
#include "io/bytes/number.h"
#include "io/bytes/same_file.h"
#include "io/sort.h"

namespace rbpa::app {
namespace {

struct Box {
  Point least, greatest;
};

struct Info {
  std::size_t points = 0;
  std::size_t distinct = 0;
  std::optional<Box> box = std::nullopt;  ///< none when there are no points
  std::optional<Crs> crs = std::nullopt;
  bool flattened = false;                        ///< heights that differ were left out
  std::optional<double> spacing = std::nullopt;  ///< √(area of the box / distinct points); none when the area is zero
};

Info examine(std::vector<Point> points, const RunOptions& run) {
  const ProgressLine line = run.line("sorting " + short_number(static_cast<double>(points.size())) + " points");
  Info info{.points = points.size()};
  if (points.empty()) return info;
  sort(points);
  info.distinct = static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
  Box box{points.front(), points.front()};
  for (std::size_t i = 0; i < info.distinct; ++i) {
    const Point& p = points[i];
    box = {{std::min(box.least.x, p.x), std::min(box.least.y, p.y)},
           {std::max(box.greatest.x, p.x), std::max(box.greatest.y, p.y)}};
  }
  info.box = box;
  // Half the width, and roots before products: nothing overflows.
  const double half_width = box.greatest.x / 2 - box.least.x / 2, half_height = box.greatest.y / 2 - box.least.y / 2;
  const double spacing =
      2 * std::sqrt(half_width) * (std::sqrt(half_height) / std::sqrt(static_cast<double>(info.distinct)));
  if (spacing > 0) info.spacing = spacing;
  return info;
}

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
  return text + "spacing     " + (info.spacing ? rounded(*info.spacing, 4) : "none") +
         "  (square root of box area / distinct points)\n";
}

std::string as_json(const Info& info) {
  using Json = nlohmann::ordered_json;
  Json box = nullptr;
  if (info.box)
    box = {{"min", Json::array({info.box->least.x, info.box->least.y})},
           {"max", Json::array({info.box->greatest.x, info.box->greatest.y})}};
  Json report = {{"points", info.points},
                 {"distinct", info.distinct},
                 {"duplicates", info.points - info.distinct},
                 {"box", box},
                 {"spacing", info.spacing ? Json(*info.spacing) : Json(nullptr)}};
  if (info.crs) report["crs"] = info.crs->text();
  return report.dump(2) + "\n";
}

}  // namespace

void run_info(const InfoArguments& arguments) {
  const PointSource source = parse_source(arguments);
  std::vector<std::string> outputs = given({"-", arguments.stats});
  require_different(outputs, arguments.points, "points");
  Run run(arguments.points, outputs, {.quiet = arguments.quiet});
  PointFile file = run.read_points(source);
  Stats stats{.read_seconds = run.lap()};
  Info info = examine(std::move(file.points), run.options());
  info.crs = file.crs;
  info.flattened = file.heights.differ();

  if (arguments.stats) {
    stats.points = info.points;
    stats.distinct = info.distinct;
    run.add(*arguments.stats, [&](OutputFile& report) { write_stats(report, stats); });
  }
  run.add("-", [&](OutputFile& out) { out.write(arguments.json ? as_json(info) : for_people(info)); });
  run.publish();
}

}  // namespace rbpa::app
