#include "report/write_space_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/text/markup.h"
#include "rbpa/base/pair_choice.h"
#include "report/blob.h"
#include "report/page_parts.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t none = Solid::none;

Json radius(double alpha) { return std::isinf(alpha) ? Json("inf") : Json(alpha); }

/// Numbers the distinct points in the order in which the tetrahedra use them, so that corners of a tetrahedron have
/// close numbers.
class Numbering {
 public:
  explicit Numbering(const SpaceReport& report) : number_(report.points.size(), none) {
    const Solid& delaunay = report.filtration.delaunay;
    for (const auto& row : delaunay.simplices)
      for (const std::uint32_t corner : row) add(corner);
    for (const std::uint32_t point : delaunay.isolated) add(point);
  }
  std::span<const std::uint32_t> points() const { return points_; }
  std::uint32_t operator[](std::uint32_t point) const { return number_[point]; }

 private:
  void add(std::uint32_t point) {
    if (number_[point] != none) return;
    number_[point] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
  }
  std::vector<std::uint32_t> number_, points_;
};

/// Returns the steps of the slider: radii that have a name or belong to a shown pair, and radii in even ratios from the
/// least radius of an edge to 1.2 times the largest of these radii. The complex at each step is exact.
std::vector<double> steps_of(const SpaceReport& report) {
  constexpr std::size_t even_steps = 600;
  std::vector<double> steps;
  const auto add = [&](double alpha) {
    if (alpha > 0 && std::isfinite(alpha)) steps.push_back(alpha);
  };
  for (const double alpha : {report.least_covering, report.least_connected, report.plateau.value_or(0)}) add(alpha);
  for (const SolidPair& pair : report.shown) {
    add(pair.birth);
    add(pair.death.value_or(0));
  }
  const auto& edges = report.filtration.edge_alpha;
  if (edges.empty()) return steps;
  const double least = *std::min_element(edges.begin(), edges.end());
  double greatest = least;
  for (const double alpha : steps) greatest = std::max(greatest, alpha);
  for (std::size_t i = 0; i <= even_steps; ++i)
    add(least * std::pow(1.2 * greatest / least, static_cast<double>(i) / even_steps));
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

/// Returns the first step at which elements that appear at `alpha` are present; the number of steps if none has them.
std::uint64_t step_at(const std::vector<double>& steps, double alpha) {
  return static_cast<std::uint64_t>(std::lower_bound(steps.begin(), steps.end(), alpha) - steps.begin());
}

struct Wall {
  Triangle corners;
  std::array<std::uint64_t, 3> steps;  ///< first steps with it, with a tetrahedron on one side, on both
};

/// Returns the triangles that are visible at some step: they exist at the step, and lack a tetrahedron on a side.
std::vector<Wall> walls_of(const SpaceReport& report, const Numbering& number, const std::vector<double>& steps) {
  const SolidFiltration& filtration = report.filtration;
  std::vector<std::array<double, 2>> sides(filtration.triangles.size(), {infinity, infinity});
  for (std::size_t t = 0; t < filtration.triangles_of.size(); ++t)
    for (const std::uint32_t triangle : filtration.triangles_of[t])
      sides[triangle][sides[triangle][0] == infinity ? 0 : 1] = filtration.tetrahedron_alpha[t];
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i % 65536 == 0) stop_if_interrupted();
    const auto [first, second] = std::minmax(sides[i][0], sides[i][1]);
    Wall wall{filtration.triangles[i],
              {step_at(steps, filtration.triangle_alpha[i]), step_at(steps, first), step_at(steps, second)}};
    if (wall.steps[0] == wall.steps[2]) continue;
    for (std::uint32_t& corner : wall.corners) corner = number[corner];
    walls.push_back(wall);
  }
  return walls;
}

void write_walls(OutputFile& file, const std::vector<Wall>& walls) {
  Blob blob(file, "triangles");
  std::int64_t before = 0;
  for (const Wall& wall : walls) {
    for (const std::int64_t corner : wall.corners) {
      blob.put_signed(corner - before);
      before = corner;
    }
    blob.put_whole(wall.steps[0]);
    blob.put_whole(wall.steps[1] - wall.steps[0]);
    blob.put_whole(wall.steps[2] - wall.steps[1]);
  }
  blob.end();
}

/// Writes for each step the number of tetrahedra and the Betti numbers 0 to 2, as differences from the previous step.
void write_counts(OutputFile& file, const SpaceReport& report, const std::vector<double>& steps) {
  std::vector<std::array<std::int64_t, 4>> changes(steps.size() + 1, {0, 0, 0, 0});
  for (const double alpha : report.filtration.tetrahedron_alpha) ++changes[step_at(steps, alpha)][0];
  for (const SolidPair& pair : report.pairs) {
    const auto of = static_cast<std::size_t>(pair.dimension) + 1;
    ++changes[step_at(steps, pair.birth)][of];
    if (pair.death) --changes[step_at(steps, *pair.death)][of];
  }
  Blob blob(file, "counts");
  for (std::size_t i = 0; i < steps.size(); ++i)
    for (const std::int64_t change : changes[i]) blob.put_signed(change);
  blob.end();
}

Json representative_of(const SpaceReport& report, const Numbering& number, std::size_t i) {
  const SolidPair& pair = report.shown[i];
  const SolidRepresentative& of = report.representatives[i];
  Json cells = Json::array();
  if (pair.dimension == 2)
    for (const Triangle& face : of.faces)
      for (const std::uint32_t corner : face) cells.push_back(number[corner]);
  else
    for (const std::uint32_t edge : of.cells)
      for (const std::uint32_t end : report.filtration.edges[edge]) cells.push_back(number[end]);
  return {{"dimension", pair.dimension},
          {"birth", pair.birth},
          {"death", pair.death ? radius(*pair.death) : Json()},
          {pair.dimension == 2 ? "volume" : "length", pair.dimension == 2 ? of.volume : of.length},
          {"cells", cells}};
}

}  // namespace

void write_space_report(OutputFile& file, const SpaceReport& report) {
  constexpr std::size_t dots = 4000;  // the most pairs of each dimension in the diagram
  const Numbering number(report);
  const std::vector<double> steps = steps_of(report);
  const std::vector<Wall> walls = walls_of(report, number, steps);
  const std::vector<SolidPair> in_diagram =
      chosen(std::vector<SolidPair>(report.pairs.begin(), report.pairs.end()), {.top = dots});
  Json facts = {{"source", printable(report.source)},
                {"points", report.points.size()},
                {"distinct", number.points().size()},
                {"tetrahedra", report.filtration.tetrahedron_alpha.size()},
                {"triangles", walls.size()},
                {"steps", steps.size()},
                {"pairs", report.pairs.size()},
                {"dots", in_diagram.size()},
                {"cover", report.cover},
                {"min", radius(report.least_covering)},
                {"auto", radius(report.least_connected)},
                {"plateau", report.plateau ? radius(*report.plateau) : Json()},
                {"representatives", Json::array()}};
  for (std::size_t i = 0; i < report.shown.size(); ++i)
    facts["representatives"].push_back(representative_of(report, number, i));

  file.write(space_page_before_title);
  file.write(markup_escaped(printable(report.source)));
  file.write(space_page_before_data);
  file.write("<script type=\"application/json\" id=\"data-facts\">\n");
  file.write(facts_text(facts.dump()));
  file.write("\n</script>\n");
  {
    Blob blob(file, "points");
    for (const std::uint32_t point : number.points())
      for (const double x : {report.points[point].x, report.points[point].y, report.points[point].z}) blob.put(x);
    blob.end();
  }
  {
    Blob blob(file, "radii");
    for (const double alpha : steps) blob.put(alpha);
    blob.end();
  }
  write_walls(file, walls);
  write_counts(file, report, steps);
  {
    Blob blob(file, "pairs");
    for (const SolidPair& pair : in_diagram) {
      blob.put(pair.dimension);
      blob.put(pair.birth);
      blob.put(pair.death.value_or(infinity));
    }
    blob.end();
  }
  file.write(space_page_after_data);
}

}  // namespace rbpa::app
