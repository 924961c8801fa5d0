#include "report/write_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "io/failure.h"
#include "io/text/markup.h"
#include "report/blob.h"
#include "report/page_parts.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

Json radius(const std::optional<double>& alpha) {
  if (!alpha) return nullptr;
  return std::isinf(*alpha) ? Json("inf") : Json(*alpha);
}

Json as_json(const std::vector<Plateau>& plateaus) {
  Json list = Json::array();
  for (const Plateau& plateau : plateaus)
    list.push_back({{"alpha", radius(plateau.alpha)},
                    {"from", radius(plateau.from)},
                    {"to", radius(plateau.to)},
                    {"long", plateau.is_long}});
  return list;
}

Json as_json(const std::optional<Recommendation>& recommended) {
  if (!recommended) return nullptr;
  return {{"choice", recommended->choice}, {"alpha", radius(recommended->alpha)}, {"why", recommended->why}};
}

/// Returns the data that are not arrays, as JSON.
std::string facts(const Report& report) {
  const auto& pairs = report.arrays.pairs;
  const auto components =
      std::count_if(pairs.begin(), pairs.end(), [](const PlacedPair& p) { return p.pair.dimension == 0; });
  const Json facts = {{"source", printable(report.source)},
                      {"points", report.radii.points},
                      {"distinct", report.arrays.points.size()},
                      {"triangles", report.arrays.triangles.size()},
                      {"steps", report.radii.filtration.steps.size()},
                      {"freeEdges", report.arrays.free_edges.size()},
                      {"componentPairs", components},
                      {"holePairs", static_cast<std::ptrdiff_t>(pairs.size()) - components},
                      {"mostComponents", report.radii.max_components},
                      {"min", radius(report.radii.least_covering)},
                      {"auto", radius(report.radii.least_connected)},
                      {"cover", report.radii.cover},
                      {"unit", report.unit ? Json(*report.unit) : Json()},
                      {"plateaus", as_json(report.radii.plateaus)},
                      {"recommended", as_json(report.recommended)}};
  return facts_text(facts.dump(2));
}

void write_points(OutputFile& file, std::span<const Point> points) {
  Blob blob(file, "points");
  for (const Point& p : points) {
    blob.put(p.x);
    blob.put(p.y);
  }
  blob.end();
}

void write_triangles(OutputFile& file, const FiltrationArrays& arrays) {
  Blob blob(file, "triangles");
  for (const auto& [a, b, c] : arrays.triangles) {
    blob.put_whole(a);
    blob.put_whole(b - a);
    blob.put_whole(c - a);
  }
  blob.end();
}

void write_radii(OutputFile& file, const std::vector<FiltrationStep>& steps) {
  Blob blob(file, "radii");
  for (const FiltrationStep& step : steps) blob.put(step.alpha);
  blob.end();
}

void write_areas(OutputFile& file, const std::vector<FiltrationStep>& steps) {
  Blob blob(file, "areas");
  for (const FiltrationStep& step : steps) blob.put(step.area);
  blob.end();
}

/// Writes the counts of all steps as differences from the previous step.
void write_counts(OutputFile& file, const std::vector<FiltrationStep>& steps) {
  Blob blob(file, "counts");
  FiltrationStep before;
  for (const FiltrationStep& step : steps) {
    for (const auto count : {&FiltrationStep::triangles, &FiltrationStep::solid_components, &FiltrationStep::components,
                             &FiltrationStep::holes, &FiltrationStep::covered})
      blob.put_signed(static_cast<std::int64_t>(step.*count) - static_cast<std::int64_t>(before.*count));
    before = step;
  }
  blob.end();
}

/// Returns the first step whose radius is at least `alpha`, from which on elements that appear at `alpha` are visible.
std::size_t step_at(const std::vector<FiltrationStep>& steps, double alpha) {
  const auto step = std::lower_bound(steps.begin(), steps.end(), alpha,
                                     [](const FiltrationStep& s, double a) { return s.alpha < a; });
  return static_cast<std::size_t>(step - steps.begin());
}

void write_free_edges(OutputFile& file, const Report& report) {
  Blob blob(file, "free-edges");
  std::size_t before = 0;
  for (const FreeEdge& edge : report.arrays.free_edges) {
    const std::size_t step = step_at(report.radii.filtration.steps, edge.alpha);
    blob.put_whole(step - before);
    blob.put_whole(std::uint64_t{3} * edge.triangle + edge.side);
    before = step;
  }
  blob.end();
}

/// Writes the pairs. A birth is a step. A death is the number of steps after the birth, or 0 if the pair never dies.
void write_pairs(OutputFile& file, const Report& report) {
  Blob blob(file, "pairs");
  for (const auto& [pair, triangle] : report.arrays.pairs) {
    const std::size_t birth = step_at(report.radii.filtration.steps, pair.birth);
    blob.put_whole(birth);
    blob.put_whole(pair.death ? step_at(report.radii.filtration.steps, *pair.death) - birth : 0);
    blob.put_whole(triangle);
  }
  blob.end();
}

}  // namespace

void write_report(OutputFile& file, const Report& report) {
  file.write(page_before_title);
  file.write(markup_escaped(printable(report.source)));
  file.write(page_before_data);
  file.write("<script type=\"application/json\" id=\"data-facts\">\n");
  file.write(facts(report));
  file.write("\n</script>\n");
  write_points(file, report.arrays.points);
  write_triangles(file, report.arrays);
  write_radii(file, report.radii.filtration.steps);
  write_areas(file, report.radii.filtration.steps);
  write_counts(file, report.radii.filtration.steps);
  write_free_edges(file, report);
  write_pairs(file, report);
  file.write(page_after_data);
}

}  // namespace rbpa::app
