#include "space/space_alpha.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/bytes/same_file.h"
#include "io/bytes/write_json.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "picture/filtration_plot.h"
#include "rbpa/base/error.h"
#include "rbpa/base/pair_choice.h"
#include "rbpa/space/balls/weighted_filtration.h"
#include "rbpa/space/persistence/solid_representatives.h"
#include "shared/alpha_report.h"
#include "shared/progress.h"
#include "shared/representative_files.h"
#include "space/balls_files.h"
#include "space/solid_request.h"
#include "space/space_persistence.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::array<const char*, 3> names = {"components", "tunnels", "voids"};

/// Returns the number of pairs of dimension `dimension`.
std::size_t count(const std::vector<SolidPair>& pairs, int dimension) {
  return static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [&](const SolidPair& pair) { return pair.dimension == dimension; }));
}

Json number_or_inf(double radius) { return std::isinf(radius) ? Json("inf") : Json(radius); }

/// Writes a report, to which the numbers of pairs are added, and, if `with_pairs`, the pairs.
void write_with_pairs(OutputFile& file, Json json, const std::vector<SolidPair>& pairs, bool with_pairs) {
  for (int dimension = 0; dimension < 3; ++dimension)
    json[names[static_cast<std::size_t>(dimension)]] = count(pairs, dimension);
  if (with_pairs) {
    json["pairs"] = Json::array();
    for (const SolidPair& pair : pairs) {
      stop_if_interrupted();
      json["pairs"].push_back(
          {{"dimension", pair.dimension}, {"birth", pair.birth}, {"death", pair.death ? Json(*pair.death) : Json()}});
    }
  }
  write_json(file, json, 1);
}

void write_json(OutputFile& file, const SpacePersistence& report, const std::vector<SolidPlateau>& plateaus,
                bool with_pairs) {
  Json json = {{"points", report.file.points.size()},
               {"distinct", report.filtration.delaunay.distinct},
               {"min", number_or_inf(report.least)},
               {"auto", number_or_inf(report.automatic)},
               {"plateaus", Json::array()}};
  for (const SolidPlateau& plateau : plateaus)
    json["plateaus"].push_back({{"alpha", plateau.alpha},
                                {"from", plateau.from},
                                {"to", plateau.to ? number_or_inf(*plateau.to) : Json()},
                                {"ratio", plateau.ratio},
                                {"kind", plateau.is_structured ? "structured" : "one piece"},
                                {"long", plateau.is_long},
                                {"effective_parts", plateau.effective_parts},
                                {"void_share", plateau.void_share},
                                {"tetrahedra", plateau.tetrahedra},
                                {"components", plateau.components},
                                {"covered", plateau.covered},
                                {"volume", plateau.volume}});
  write_with_pairs(file, std::move(json), report.pairs, with_pairs);
}

void write_csv(OutputFile& file, const std::vector<SolidPair>& pairs) {
  file.write("dimension,birth,death\n");
  for (const SolidPair& pair : pairs) {
    file.write_all(static_cast<std::uint64_t>(pair.dimension), ",", pair.birth, ",");
    if (pair.death) file.write_number(*pair.death);
    file.write("\n");
  }
}

/// Returns "plateau 0.1142, from 0.06577 to 0.1984: 1 part, 100.0 % of the points covered, voids 0.0 % of the volume".
std::string line_of(const SolidPlateau& plateau, std::size_t rank, std::size_t distinct) {
  const auto percent = [](double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", std::floor(1000 * share) / 10);
    return std::string(text);
  };
  return (rank == 1 ? "plateau " : "plateau:" + std::to_string(rank) + " ") + rounded(plateau.alpha, 4) + ", from " +
         rounded(plateau.from, 4) + " to " + (plateau.to ? rounded(*plateau.to, 4) : "inf") + ": " +
         counted(plateau.components, "part") + ", " +
         percent(static_cast<double>(plateau.covered) / static_cast<double>(distinct)) +
         " of the points covered, voids " + percent(plateau.void_share) + " of the volume" +
         (plateau.is_long ? "\n" : "; it may be chance\n");
}

/// Writes the most persistent tunnels and voids.
void write_longest(OutputFile& file, const std::vector<SolidPair>& pairs) {
  constexpr std::size_t shown = 5;
  std::vector<SolidPair> longest = chosen(pairs, {.top = shown});
  std::stable_sort(longest.begin(), longest.end(), [](const SolidPair& a, const SolidPair& b) {
    return a.death.value_or(0) - a.birth > b.death.value_or(0) - b.birth;
  });
  for (int dimension = 1; dimension < 3; ++dimension) {
    const std::size_t all = count(pairs, dimension);
    file.write(counted(all, dimension == 1 ? "tunnel" : "void") +
               (all == 0 ? "\n" : "; those that last longest, death - birth:\n"));
    for (const SolidPair& pair : longest)
      if (pair.dimension == dimension)
        file.write("  from " + rounded(pair.birth, 6) + " to " + rounded(*pair.death, 6) + ", " +
                   rounded(*pair.death - pair.birth, 6) + "\n");
  }
}

/// Writes the radii to choose from, and the most persistent tunnels and voids.
void write_for_people(OutputFile& file, const SpacePersistence& report, const std::vector<SolidPlateau>& plateaus) {
  file.write(text_of_points(report.file.points.size(), report.filtration.delaunay.duplicates.size()) + "\nmin " +
             text_of(report.least) + ", auto " + text_of(report.automatic) +
             (!report.filtration.delaunay.simplices.empty() ? "\n"
              : report.filtration.delaunay.distinct < 4
                  ? ": there is no tetrahedron, as there are fewer than four distinct points\n"
                  : ": there is no tetrahedron, as all points are in a plane\n"));
  constexpr std::size_t plateaus_shown = 4;
  for (std::size_t i = 0; i < std::min(plateaus.size(), plateaus_shown); ++i)
    file.write(line_of(plateaus[i], i + 1, report.filtration.delaunay.distinct));
  write_longest(file, report.pairs);
}

FiltrationPlot marked_plot(const SpacePersistence& report) {
  FiltrationPlot plot = plot_of(report.pairs);
  if (std::isfinite(report.least)) plot.least_covering = report.least;
  if (std::isfinite(report.automatic)) plot.least_connected = report.automatic;
  return plot;
}

/// Prints the pairs of balls, with powers in place of radii.
void run_ball_alpha(const AlphaArguments& arguments, const SpacePointSource& source) {
  refuse_given({{arguments.representatives.has_value(), "--representatives"},
                {arguments.picture.has_value(), "--output"},
                {arguments.run.stats.has_value(), "--stats"},
                {arguments.cover.has_value(), "--cover"},
                {arguments.columns.has_value(), "--columns"},
                {arguments.bounds.has_value(), "--bounds"},
                {arguments.resolution.has_value(), "--resolution"},
                {arguments.skip_invalid, "--skip-invalid"}},
               "cannot be combined with --radii");
  BallRadii radii = parse_ball_radii(arguments);
  Run run(source.path, {"-"}, parse_run(arguments.run));
  AtomFrames file(source.path, source.format,
                  {.waters = arguments.waters,
                   .where = arguments.where,
                   .radius = radii.column(),
                   .threads = run.options().threads});
  AtomFrame atoms;
  run.read([&] { return file.next(atoms); });
  run.warning(file.warnings());
  const std::vector<double> of_atoms = radii.of(atoms, file.name());
  SolidFiltration filtration;
  try {
    TriangleProgress progress(!run.options().quiet, "tetrahedra", text_of_progress);
    filtration = weighted_filtration(atoms.column(&AtomRow::center), of_atoms,
                                     {.threads = run.options().threads, .progress = progress.watch()});
  } catch (const InvalidInput& e) {
    throw BadInput(run.input() + ": " + e.what());
  }
  const std::size_t hidden = filtration.delaunay.isolated.size();
  const std::vector<SolidPair> pairs = solid_persistence(filtration, until_interrupted(), run.options().threads);
  run.add("-", [&](OutputFile& out) {
    if (arguments.json) {
      Json json = {{"balls", of_atoms.size()}, {"hidden", hidden}, {"radii", json_of(0, radii, {})["radii"]}};
      write_with_pairs(out, std::move(json), pairs, arguments.persistence);
    } else if (arguments.csv) {
      write_csv(out, pairs);
    } else {
      BallTotals totals;
      totals.counts = atoms.counts;
      totals.kept = of_atoms.size();
      const auto lines = text_of(0, radii, {totals}, atoms.rows.front().line > 0 ? "atom" : "point");
      out.write(lines[0] + "; " + std::to_string(hidden) + " without a cell\n" + lines[1] + "\n");
      write_longest(out, pairs);
    }
  });
  run.publish();
}

}  // namespace

void run_space_alpha(const AlphaArguments& arguments) {
  refuse_given({{arguments.complex.has_value(), "--complex"},
                {arguments.group_by.has_value(), "--group-by"},
                {arguments.group_by_file, "--group-by-file"}},
               "applies only to --dimension 2");
  const SpacePointSource source = parse_space_points(arguments);
  if (arguments.picture) require_plot(*arguments.picture);
  const std::optional<RepresentativeRequest> request = parse_representatives(arguments, true);
  if (arguments.radii) return run_ball_alpha(arguments, source);
  refuse_given({{arguments.radius_default.has_value(), "--radius-default"}}, "requires --radii");
  const std::vector<std::string> outputs =
      given({"-", arguments.picture, arguments.representatives, arguments.run.stats});
  require_different(outputs, arguments.points, "points");

  SpacePersistence run(source, outputs, arguments);
  if (!request) run.drop_faces();
  std::string plot;
  std::vector<SolidPlateau> plateaus;
  const auto draw = [&](const GoOn&) { plot = arguments.picture ? svg_of(marked_plot(run)) : ""; };
  arguments.csv ? draw({}) : void(plateaus = run.find_plateaus(draw));
  if (arguments.picture) run.add(*arguments.picture, [&](OutputFile& out) { out.write(plot); });
  if (request) {
    const ProgressLine line = run.options().line("representatives");
    const std::vector<SolidPair> pairs = chosen(run.pairs, request->choice);
    const auto found = solid_representatives(run.file.points, run.filtration, pairs, until_interrupted());
    run.add(request->target.path, [&](OutputFile& out) {
      write_representatives(out, request->target.format,
                            {run.file.points, run.filtration, pairs, found, run.file.index});
    });
  }
  run.add("-", [&](OutputFile& out) {
    if (arguments.json)
      write_json(out, run, plateaus, arguments.persistence);
    else if (arguments.csv)
      write_csv(out, run.pairs);
    else
      write_for_people(out, run, plateaus);
  });
  run.add_stats([&](OutputFile& out) { run.write_stats(out); });
  run.publish();
}

}  // namespace rbpa::app
