#include "shared/alpha_choice.h"

#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "io/bytes/number.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/plateaus.h"
#include "rbpa/plane/smallest_covering_alpha.h"
#include "shared/method.h"

namespace rbpa::app {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Parses a number >= 0, or infinity; nothing if the text is no such number.
std::optional<double> parse_size(const std::string& text) {
  const ParsedNumber number = parse_whole_number(text);
  if (number.fault == NumberFault::not_finite && number.value > 0) return infinity;
  if (number.fault != NumberFault::none || !(number.value >= 0)) return std::nullopt;
  return number.value;
}

constexpr std::string_view alphas = "a radius (a number > 0, or inf), auto, min, plateau or plateau:K";

double parse_radius(const std::string& text) {
  const std::optional<double> radius = parse_size(text);
  if (!radius || *radius == 0)
    throw WrongUsage("--alpha: found " + in_quotes(text) + ", expected " + std::string(alphas));
  return *radius;
}

/// Returns the root of a squared radius, rounded to the nearest double.
double parse_squared(const std::string& text) {
  const std::optional<double> squared = parse_size(text);
  if (!squared || *squared == 0)
    throw WrongUsage("--alpha-squared: found " + in_quotes(text) + ", expected the square of a radius, > 0, or inf");
  return std::sqrt(*squared);
}

/// Returns one over the number; 0 gives an infinite radius.
double parse_inverse(const std::string& text) {
  const std::optional<double> inverse = parse_size(text);
  if (!inverse || *inverse == infinity)
    throw WrongUsage("--alpha-inverse: found " + in_quotes(text) + ", expected one over a radius, >= 0");
  return 1 / *inverse;
}

AlphaChoice parse_choice(const RadiusArguments& arguments) {
  if (arguments.squared)
    return {.radius = parse_squared(*arguments.squared), .converted = " of --alpha-squared " + *arguments.squared};
  if (arguments.inverse)
    return {.radius = parse_inverse(*arguments.inverse), .converted = " of --alpha-inverse " + *arguments.inverse};
  if (*arguments.alpha == "auto") return {.rule = AlphaRule::automatic};
  if (*arguments.alpha == "min") return {.rule = AlphaRule::least};
  if (*arguments.alpha == "plateau") return {.rule = AlphaRule::plateau};
  if (constexpr std::string_view ranked = "plateau:"; arguments.alpha->starts_with(ranked))
    return {.rule = AlphaRule::plateau,
            .rank = parse_whole("--alpha plateau", arguments.alpha->substr(ranked.size()), {.least = 1})};
  if (constexpr std::string_view column = "column:"; arguments.alpha->starts_with(column))
    return {.rule = AlphaRule::column, .column = arguments.alpha->substr(column.size())};
  return {.radius = parse_radius(*arguments.alpha)};
}

}  // namespace

std::size_t parse_components(const std::string& components) {
  return parse_whole("--components", components, {.least = 1});
}

double parse_cover(const std::string& cover) {
  const std::optional<double> share = parse_size(cover);
  if (!share || *share == 0 || *share > 1)
    throw WrongUsage("--cover: found " + in_quotes(cover) + ", expected a share of the points, > 0 and <= 1");
  return *share;
}

AlphaChoice parse_alpha(const RadiusArguments& arguments, ChosenFor chosen_for) {
  AlphaChoice choice = parse_choice(arguments);
  if (choice.rule == AlphaRule::column && chosen_for != ChosenFor::groups)
    throw WrongUsage("--alpha: found " + in_quotes(*arguments.alpha) + ", expected " + std::string(alphas) +
                     " (column:NAME applies only to groups, as in rbpa shape --group-by)");
  if (arguments.components && choice.rule != AlphaRule::automatic)
    throw WrongUsage("--components applies only to --alpha auto");
  if (arguments.cover && choice.rule != AlphaRule::automatic && choice.rule != AlphaRule::least)
    throw WrongUsage("--cover applies only to --alpha auto or min");
  if (arguments.components) choice.max_components = parse_components(*arguments.components);
  if (arguments.cover) choice.cover = parse_cover(*arguments.cover);
  return choice;
}

std::string name_of(const AlphaChoice& choice) {
  switch (choice.rule) {
    case AlphaRule::automatic:
      return "auto";
    case AlphaRule::least:
      return "min";
    case AlphaRule::plateau:
      return choice.rank == 1 ? "plateau" : "plateau:" + std::to_string(choice.rank);
    case AlphaRule::column:
      return "column:" + choice.column;
    case AlphaRule::given:
      break;
  }
  return "given";
}

std::string warning_on_density(const std::vector<Plateau>& plateaus) {
  constexpr double much_larger = 1.25;
  if (plateaus.empty() || plateaus.front().kind != PlateauKind::one_piece) return "";
  const FiltrationStep& best = plateaus.front().step;
  for (std::size_t i = 1; i < plateaus.size(); ++i) {
    const FiltrationStep& other = plateaus[i].step;
    if (plateaus[i].kind != PlateauKind::one_piece || other.solid_components >= best.solid_components) continue;
    if (!(other.area >= much_larger * best.area)) continue;
    const std::string choice = "plateau:" + std::to_string(i + 1);
    return "at " + rounded(plateaus.front().alpha, 4) + " there are " + counted(best.solid_components, "part") +
           ", as points are not evenly dense, and at " + choice + ", which is " + rounded(plateaus[i].alpha, 4) + ", " +
           counted(other.solid_components, "part") + " of " + rounded(other.area / best.area, 3) +
           " times the area: for the footprint of a scan take --alpha " + choice;
  }
  return "";
}

std::optional<double> choose_alpha(const AlphaChoice& choice, const std::vector<Point>& points, const RunOptions& run) {
  if (choice.rule == AlphaRule::given) return choice.radius;
  const Delaunay delaunay = build_delaunay(points, run);
  std::optional<ProgressLine> line(std::in_place, "rbpa", !run.quiet, "choosing alpha");
  if (choice.rule != AlphaRule::plateau) {
    Covering covering{.share = choice.cover};
    if (choice.rule == AlphaRule::automatic) covering.max_components = choice.max_components;
    return smallest_covering(delaunay, covering, until_interrupted());
  }
  const std::vector<Plateau> found = plateaus(delaunay, filtration(delaunay, until_interrupted()), until_interrupted());
  line.reset();  // nothing may be said beside it
  if (found.empty()) return std::nullopt;
  if (choice.rank > found.size())
    throw WrongUsage("--alpha " + name_of(choice) + (found.size() == 1 ? ": there is only " : ": there are only ") +
                     counted(found.size(), "plateau") + " (rbpa alpha POINTS lists them)");
  if (!found.front().is_long && !run.quiet)
    say("rbpa", "--alpha " + name_of(choice) +
                    ": no range of alpha stands out, and the longest one may be chance (rbpa alpha POINTS shows the "
                    "choices, and recommends auto)");
  if (const std::string warning = warning_on_density(found); choice.rank == 1 && !warning.empty() && !run.quiet)
    say("rbpa", "--alpha plateau: " + warning);
  return found[choice.rank - 1].alpha;
}

std::string said(const AlphaChoice& choice, std::optional<double> alpha) {
  if (choice.rule == AlphaRule::given)
    return choice.converted.empty() ? "" : ", alpha " + text_of(choice.radius) + choice.converted;
  std::string text = ", alpha " + name_of(choice) + " = " + text_of(alpha);
  if (choice.cover < 1) text += " with --cover " + text_of(choice.cover);
  return text;
}

}  // namespace rbpa::app
