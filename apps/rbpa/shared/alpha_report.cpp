#include "shared/alpha_report.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <utility>

#include "io/failure.h"
#include "io/formats.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "shared/alpha_option.h"

namespace rbpa::app {
namespace {

/// Calls write(line) for each line. Throws Cancelled after a signal.
template <typename Lines, typename Write>
void for_each_line(const Lines& lines, const Write& write) {
  std::size_t count = 0;
  for (const auto& line : lines) {
    if (++count % 65536 == 0) stop_if_interrupted();
    write(line);
  }
}

void write_value(OutputFile& out, std::size_t value) { out.write_number(static_cast<std::uint64_t>(value)); }

void write_value(OutputFile& out, bool value) { out.write(value ? "true" : "false"); }

void write_value(OutputFile& out, std::string_view value) { out.write_all("\"", value, "\""); }

void write_value(OutputFile& out, double value) {
  if (std::isinf(value))
    write_value(out, std::string_view("inf"));
  else
    out.write_number(value);
}

void write_value(OutputFile& out, const std::optional<double>& value) {
  value ? write_value(out, *value) : out.write("null");
}

/// Writes a JSON object on one line, such as {"alpha": 1, "to": null}.
class JsonLine {
 public:
  explicit JsonLine(OutputFile& out) : out_(out) {}

  template <typename Value>
  JsonLine& item(std::string_view name, const Value& value) {
    out_.write_all(std::exchange(before_, ", \""), name, "\": ");
    write_value(out_, value);
    return *this;
  }
  JsonLine& counts(const FiltrationStep& step) {
    return item("triangles", step.triangles)
        .item("solid_components", step.solid_components)
        .item("components", step.components)
        .item("holes", step.holes)
        .item("covered", step.covered)
        .item("area", step.area);
  }
  void end() { out_.write("}"); }

 private:
  OutputFile& out_;
  std::string_view before_ = "{\"";
};

void write_line(OutputFile& out, const FiltrationStep& step) {
  JsonLine(out).item("alpha", step.alpha).counts(step).end();
}

void write_line(OutputFile& out, const PersistencePair& pair) {
  JsonLine(out)
      .item("dimension", static_cast<std::size_t>(pair.dimension))
      .item("birth", pair.birth)
      .item("death", pair.death)
      .end();
}

void write_line(OutputFile& out, const Plateau& plateau) {
  const std::string_view kind = plateau.kind == PlateauKind::structured ? "structured" : "one piece";
  JsonLine line(out);
  line.item("alpha", plateau.alpha).item("from", plateau.from).item("to", plateau.to).item("ratio", plateau.ratio);
  line.item("kind", kind).item("long", plateau.is_long);
  line.item("effective_parts", plateau.effective_parts).item("hole_share", plateau.hole_share);
  line.counts(plateau.step).end();
}

template <typename Lines>
void write_array(OutputFile& out, std::string_view name, const Lines& lines) {
  out.write_all(",\n  \"", name, "\": [");
  const char* before = "\n    ";
  for_each_line(lines, [&](const auto& line) {
    out.write(before);
    write_line(out, line);
    before = ",\n    ";
  });
  out.write(lines.empty() ? "]" : "\n  ]");
}

/// Significant digits of the numbers in the table.
constexpr int digits = 4;

/// Returns count / all in percent as text, rounded down, so that 100 means all.
std::string percent(std::size_t count, std::size_t all) {
  const double tenths = std::floor(1000 * static_cast<double>(count) / static_cast<double>(all));
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", tenths / 10);
  return text;
}

/// Returns a line of the table of choices. `others` are the names of the choice in other programs.
std::string row(const std::string& choice, const std::string& alpha, const std::string& from, const std::string& to,
                const std::string& parts, const std::string& holes, const std::string& covered, const std::string& area,
                const std::string& others = "") {
  char text[160];
  std::snprintf(text, sizeof text, "%-10s %9s %9s %9s %7s %6s %8s %10s", choice.c_str(), alpha.c_str(), from.c_str(),
                to.c_str(), parts.c_str(), holes.c_str(), covered.c_str(), area.c_str());
  return text + (others.empty() ? "" : "  " + others) + "\n";
}

std::string row(const std::string& choice, double alpha, const std::string& from, const std::string& to,
                const FiltrationStep& step, std::size_t distinct, const std::string& others = "") {
  return row(choice, rounded(alpha, digits), from, to, std::to_string(step.solid_components),
             std::to_string(step.holes), percent(step.covered, distinct), rounded(step.area, digits), others);
}

/// Returns the step of the filtration at `alpha`. Requires: `alpha` is a critical radius.
const FiltrationStep& step_at(const Filtration& filtration, double alpha) {
  return *std::find_if(filtration.steps.begin(), filtration.steps.end(),
                       [&](const FiltrationStep& step) { return step.alpha == alpha; });
}

/// Returns the range of `count` on a plateau with its noun: "1 part", "0 to 5 holes".
std::string counts_in(const Filtration& filtration, const Plateau& plateau, std::size_t FiltrationStep::*count,
                      const char* noun) {
  std::size_t least = plateau.step.*count, most = least;
  for (const FiltrationStep& step : filtration.steps) {
    if (step.alpha < plateau.from || (plateau.to && step.alpha >= *plateau.to)) continue;
    least = std::min(least, step.*count);
    most = std::max(most, step.*count);
  }
  return (least == most ? "" : std::to_string(least) + " to ") + counted(most, noun);
}

std::string table_of(const Radii& radii) {
  const Filtration& all = radii.filtration;
  std::string text = row("choice", "alpha", "from", "to", "parts", "holes", "covered", "area");
  for (std::size_t i = 0; i < radii.plateaus.size(); ++i) {
    const Plateau& plateau = radii.plateaus[i];
    text += row(i == 0 ? "plateau" : "plateau:" + std::to_string(i + 1), plateau.alpha, rounded(plateau.from, digits),
                plateau.to ? rounded(*plateau.to, digits) : "inf", plateau.step, all.distinct);
  }
  const bool every = radii.cover == 1;
  if (radii.least_covering)
    text += row("min", *radii.least_covering, "", "", step_at(all, *radii.least_covering), all.distinct,
                every ? "MATLAB 'all-points'" : "");
  if (radii.least_connected)
    text += row("auto", *radii.least_connected, "", "", step_at(all, *radii.least_connected), all.distinct,
                every && radii.max_components == 1 ? "MATLAB 'one-region', CGAL find_optimal_alpha(1)" : "");
  return text;
}

}  // namespace

std::optional<Recommendation> recommended(const Radii& radii) {
  if (radii.plateaus.empty()) return std::nullopt;
  const Plateau& best = radii.plateaus.front();
  const std::string from = rounded(best.from, digits), factor = "a factor of " + rounded(best.ratio, digits);
  const std::string up_to = best.to ? " up to " + rounded(*best.to, digits) : " from there on";
  if (!best.is_long && radii.least_connected)
    return Recommendation{
        "auto", *radii.least_connected,
        "no range of alpha stands out: the longest plateau is " + factor + ", which may be chance for so few points"};
  if (best.kind == PlateauKind::one_piece)
    return Recommendation{"plateau", best.alpha,
                          "from " + from + up_to + ", " + factor +
                              ", one part holds nearly all covered points, and little but its area changes"};
  return Recommendation{"plateau", best.alpha,
                        "from " + from + up_to + ", " + factor + ", the shape has " +
                            counts_in(radii.filtration, best, &FiltrationStep::solid_components, "part") + " and " +
                            counts_in(radii.filtration, best, &FiltrationStep::holes, "hole")};
}

void require_plot(const std::string& path) {
  target_of(path, path, Use::shape, [](Format format) { return format == Format::svg; });
}

std::string for_people(const AlphaReport& report) {
  const Radii& radii = report.radii;
  const auto& steps = radii.filtration.steps;
  std::string text = "points    " + std::to_string(radii.points) + ", " + std::to_string(radii.filtration.distinct) +
                     " of them distinct\n";
  const std::string pieces = counted(radii.max_components, "solid component");
  const bool every = radii.cover == 1;
  text += "min       " + text_of(radii.least_covering) + "  (least alpha that covers " +
          (every ? "every point" : "a share of " + text_of(radii.cover) + " of the points") + ")\n";
  text += "auto      " + text_of(radii.least_connected) +
          (every ? "  (moreover in at most " + pieces : "  (moreover with at most " + pieces + ", without the others") +
          ")\n";
  text += "critical  " + std::to_string(steps.size()) + (steps.size() == 1 ? " radius" : " radii");
  if (!steps.empty()) text += ", from " + text_of(steps.front().alpha) + " to " + text_of(steps.back().alpha);
  text += "\n";
  if (report.pairs) {
    const auto holes = std::count_if(report.pairs->begin(), report.pairs->end(),
                                     [](const PersistencePair& pair) { return pair.dimension == 1; });
    const auto components = static_cast<std::ptrdiff_t>(report.pairs->size()) - holes;
    text += "pairs     " + std::to_string(components) + " of components, " + std::to_string(holes) + " of holes\n";
  }
  const std::optional<Recommendation> best = recommended(radii);
  if (!best) return text;
  std::string density = warning_on_density(radii.plateaus);
  if (!density.empty()) density = "But " + density + ".\n";
  return text + "\n" + table_of(radii) + "\nRecommended: --alpha " + best->choice + ", which is " +
         text_of(best->alpha) + ":\n" + best->why + ".\n" + density;
}

void write_json(OutputFile& out, const AlphaReport& report) {
  out.write("{\n  \"auto\": ");
  write_value(out, report.radii.least_connected);
  out.write(",\n  \"min\": ");
  write_value(out, report.radii.least_covering);
  out.write(",\n  \"recommended\": ");
  if (const std::optional<Recommendation> best = recommended(report.radii)) {
    JsonLine(out)
        .item("choice", std::string_view(best->choice))
        .item("alpha", best->alpha)
        .item("why", std::string_view(best->why))
        .end();
  } else {
    out.write("null");
  }
  write_array(out, "plateaus", report.radii.plateaus);
  write_array(out, "critical", report.radii.filtration.steps);
  if (report.pairs) write_array(out, "pairs", *report.pairs);
  out.write("\n}\n");
}

void write_csv(OutputFile& out, const AlphaReport& report) {
  if (report.pairs) {
    out.write("dimension,birth,death\n");
    for_each_line(*report.pairs, [&](const PersistencePair& pair) {
      out.write_all(static_cast<std::size_t>(pair.dimension), ",", pair.birth, ",");
      if (pair.death) out.write_number(*pair.death);
      out.write("\n");
    });
    return;
  }
  out.write("alpha,triangles,solid_components,components,holes,covered,area\n");
  for_each_line(report.radii.filtration.steps, [&](const FiltrationStep& step) {
    out.write_all(step.alpha, ",", step.triangles, ",", step.solid_components, ",", step.components, ",", step.holes,
                  ",", step.covered, ",", step.area, "\n");
  });
}

}  // namespace rbpa::app
