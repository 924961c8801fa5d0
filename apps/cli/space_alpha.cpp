#include "cli/space_alpha.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/point_arguments.h"
#include "cli/progress.h"
#include "cli/run.h"
#include "cli/solid_request.h"
#include "cli/stats.h"
#include "io/bytes/number.h"
#include "io/bytes/same_file.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/base/error.h"
#include "rbpa/solid_filtration.h"
#include "rbpa/solid_persistence.h"
#include "rbpa/solid_radii.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::array<const char*, 3> names = {"components", "tunnels", "voids"};

struct SpaceRadii {
  std::size_t points = 0, distinct = 0;
  double least = 0, automatic = 0;
  std::vector<SolidPair> pairs;
};

/// Those of one dimension.
std::size_t count(const SpaceRadii& report, int dimension) {
  return static_cast<std::size_t>(std::count_if(report.pairs.begin(), report.pairs.end(),
                                                [&](const SolidPair& pair) { return pair.dimension == dimension; }));
}

Json number_or_inf(double radius) { return std::isinf(radius) ? Json("inf") : Json(radius); }

void write_json(OutputFile& file, const SpaceRadii& report, bool with_pairs) {
  Json json = {{"points", report.points},
               {"distinct", report.distinct},
               {"min", number_or_inf(report.least)},
               {"auto", number_or_inf(report.automatic)}};
  for (int dimension = 0; dimension < 3; ++dimension)
    json[names[static_cast<std::size_t>(dimension)]] = count(report, dimension);
  if (with_pairs) {
    json["pairs"] = Json::array();
    for (const SolidPair& pair : report.pairs)
      json["pairs"].push_back(
          {{"dimension", pair.dimension}, {"birth", pair.birth}, {"death", pair.death ? Json(*pair.death) : Json()}});
  }
  file.write(json.dump(1) + "\n");
}

void write_csv(OutputFile& file, const SpaceRadii& report) {
  file.write("dimension,birth,death\n");
  for (const SolidPair& pair : report.pairs) {
    file.write_number(static_cast<std::uint64_t>(pair.dimension));
    file.write(",");
    file.write_number(pair.birth);
    file.write(",");
    if (pair.death) file.write_number(*pair.death);
    file.write("\n");
  }
}

/// The tunnels and voids that last longest, by ratio.
void write_for_people(OutputFile& file, const SpaceRadii& report) {
  constexpr std::size_t shown = 5;
  file.write(text_of_points(report.points, report.points - report.distinct) + "\nmin " + text_of(report.least) +
             ", auto " + text_of(report.automatic) + "\n");
  for (int dimension = 1; dimension < 3; ++dimension) {
    std::vector<SolidPair> of;
    for (const SolidPair& pair : report.pairs)
      if (pair.dimension == dimension && pair.death) of.push_back(pair);
    const auto ratio = [](const SolidPair& pair) { return *pair.death / pair.birth; };
    std::stable_sort(of.begin(), of.end(), [&](const SolidPair& a, const SolidPair& b) { return ratio(a) > ratio(b); });
    file.write(counted(of.size(), dimension == 1 ? "tunnel" : "void") +
               (of.empty() ? "\n" : "; longest, by death / birth:\n"));
    for (std::size_t i = 0; i < std::min(of.size(), shown); ++i)
      file.write("  from " + rounded(of[i].birth, 6) + " to " + rounded(*of[i].death, 6) + ", ratio " +
                 rounded(ratio(of[i]), 3) + "\n");
  }
}

void check(const AlphaArguments& arguments) {
  const auto refuse = [](bool is_given, const std::string& option) {
    if (is_given) throw WrongUsage(option + ": found --dimension 3 as well, with which it has no meaning yet");
  };
  refuse(arguments.picture.has_value(), "--output");
  refuse(arguments.complex.has_value(), "--complex");
  refuse(arguments.cover.has_value(), "--cover");
  refuse(arguments.components != "1", "--components");
  refuse(arguments.group_by.has_value() || arguments.group_by_file, "--group-by");
}

}  // namespace

void run_space_alpha(const AlphaArguments& arguments) {
  check(arguments);
  const RunOptions options = parse_run(arguments.run);
  SpacePointArguments points;
  points.points = arguments.points;
  points.format = arguments.format;
  points.columns = arguments.columns;
  points.where = arguments.where;
  points.skip_invalid = arguments.skip_invalid;
  const SpacePointSource source = parse_space_source(points);
  const std::vector<std::string> outputs = given({"-", arguments.stats});
  require_different(outputs, arguments.points, "points");

  Run run(source.path, outputs, options);
  const SpacePoints file = run.read([&] { return read_space_points(source.path, source.format, source.choice); });
  run.remark(file.remarks);
  const double read_seconds = run.lap();
  SpaceRadii report{.points = file.points.size(), .distinct = 0, .least = 0, .automatic = 0, .pairs = {}};
  try {
    SolidFiltration filtration;
    {
      TriangleProgress progress(!options.quiet, "tetrahedra", text_of_progress);
      filtration = solid_filtration(file.points, {.threads = options.threads, .progress = progress.watch()});
    }
    const ProgressLine line = options.line("persistence");
    report.distinct = filtration.delaunay.distinct;
    report.least = min_alpha(filtration.delaunay, filtration.tetrahedron_alpha);
    report.automatic = auto_alpha(filtration.delaunay, filtration.tetrahedron_alpha);
    report.pairs = solid_persistence(filtration, until_interrupted());
  } catch (const InvalidInput& e) {
    throw BadInput(run.input() + ": " + e.what());
  }
  const double build_seconds = run.lap();
  run.add("-", [&](OutputFile& out) {
    if (arguments.json)
      write_json(out, report, arguments.persistence);
    else if (arguments.csv)
      write_csv(out, report);
    else
      write_for_people(out, report);
  });
  if (arguments.stats)
    run.add(*arguments.stats, [&](OutputFile& out) {
      const Json seconds = {{"read", read_seconds}, {"build", build_seconds}, {"write", run.lap()}};
      const Json stats = {{"points", report.points},
                          {"distinct", report.distinct},
                          {"threads", options.threads_or_all()},
                          {"seconds", seconds},
                          {"peak_bytes", peak_bytes()}};
      out.write(stats.dump(2) + "\n");
    });
  run.publish();
}

}  // namespace rbpa::app
