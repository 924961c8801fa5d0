#include "shared/alpha_option.h"

#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "io/bytes/number.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/choose_alpha.h"
#include "shared/method.h"

namespace rbpa::app {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Parses a number >= 0, or infinity; returns nothing for other texts.
std::optional<double> parse_size(const std::string& text) {
  const ParsedNumber number = parse_whole_number(text);
  if (number.fault == NumberFault::not_finite && number.value > 0) return infinity;
  if (number.fault != NumberFault::none || !(number.value >= 0)) return std::nullopt;
  return number.value;
}

std::string not_an_alpha(const std::string& text) {
  return "--alpha: found " + in_quotes(text) + ", expected " + std::string(expected_alpha);
}

/// Parses a squared radius, and returns the radius, rounded to the nearest double.
double parse_squared(const std::string& text) {
  const std::optional<double> squared = parse_size(text);
  if (!squared || *squared == 0)
    throw WrongUsage("--alpha-squared: found " + in_quotes(text) + ", expected the square of a radius, > 0, or inf");
  return std::sqrt(*squared);
}

/// Parses one over a radius, and returns the radius; infinity for 0.
double parse_inverse(const std::string& text) {
  const std::optional<double> inverse = parse_size(text);
  if (!inverse || *inverse == infinity)
    throw WrongUsage("--alpha-inverse: found " + in_quotes(text) + ", expected one over a radius, finite and >= 0");
  return 1 / *inverse;
}

AlphaOption parse_option(const RadiusArguments& arguments) {
  AlphaOption option;
  if (arguments.squared) {
    option.radius = parse_squared(*arguments.squared);
    option.converted = " of --alpha-squared " + *arguments.squared;
  } else if (arguments.inverse) {
    option.radius = parse_inverse(*arguments.inverse);
    option.converted = " of --alpha-inverse " + *arguments.inverse;
  } else if (constexpr std::string_view column = "column:"; arguments.alpha->starts_with(column)) {
    option.column = arguments.alpha->substr(column.size());
  } else if (const std::optional<AlphaChoice> rule = parse_alpha_rule(*arguments.alpha)) {
    static_cast<AlphaChoice&>(option) = *rule;
  } else if (const std::optional<double> radius = parse_size(*arguments.alpha); radius && *radius > 0) {
    option.radius = *radius;
  } else {
    throw WrongUsage(not_an_alpha(*arguments.alpha));
  }
  return option;
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

AlphaOption parse_alpha(const RadiusArguments& arguments, ChosenFor chosen_for) {
  AlphaOption option = parse_option(arguments);
  if (option.column && chosen_for != ChosenFor::groups)
    throw WrongUsage(not_an_alpha(*arguments.alpha) +
                     " (column:NAME applies only to groups, as in rbpa shape --group-by)");
  if (arguments.components && !takes_components(option.rule))
    throw WrongUsage("--components applies only to --alpha auto");
  if (arguments.cover && !takes_cover(option.rule)) throw WrongUsage("--cover applies only to --alpha auto or min");
  if (arguments.components) option.max_components = parse_components(*arguments.components);
  if (arguments.cover) option.cover = parse_cover(*arguments.cover);
  return option;
}

std::string name_of(const AlphaOption& option) {
  return option.column ? "column:" + *option.column : name_of(static_cast<const AlphaChoice&>(option));
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
  ChosenAlpha chosen;
  try {
    chosen = rbpa::choose_alpha(choice, delaunay, until_interrupted());
  } catch (const InvalidInput& e) {
    throw WrongUsage("--" + std::string(e.what()) + " (rbpa alpha POINTS lists them)");
  }
  line.reset();  // erase the progress line before messages
  if (chosen.plateaus.empty() || run.quiet) return chosen.alpha;
  if (!chosen.plateaus.front().is_long)
    say("rbpa", "--alpha " + name_of(choice) +
                    ": no range of alpha stands out, and the longest one may be chance (rbpa alpha POINTS shows the "
                    "choices, and recommends auto)");
  if (const std::string warning = warning_on_density(chosen.plateaus); choice.rank == 1 && !warning.empty())
    say("rbpa", "--alpha plateau: " + warning);
  return chosen.alpha;
}

std::string said(const AlphaOption& option, std::optional<double> alpha) {
  if (option.rule == AlphaRule::given)
    return option.converted.empty() ? "" : ", alpha " + text_of(option.radius) + option.converted;
  std::string text = ", alpha " + name_of(option) + " = " + text_of(alpha);
  if (option.cover < 1) text += " with --cover " + text_of(option.cover);
  return text;
}

}  // namespace rbpa::app
