#include "shared/alpha_option.h"

#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/choose_alpha.h"
#include "shared/method.h"

namespace rbpa::app {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr Range any_radius{.least = above_0.least, .greatest = infinity};

AlphaOption parse_option(const RadiusArguments& arguments) {
  AlphaOption option;
  if (arguments.squared) {
    option.radius =
        std::sqrt(parse_real("--alpha-squared", *arguments.squared, any_radius, "the square of a radius, > 0, or inf"));
    option.converted = " of --alpha-squared " + *arguments.squared;
  } else if (arguments.inverse) {
    option.radius = 1 / parse_real("--alpha-inverse", *arguments.inverse, {}, "one over a radius, finite and >= 0");
    option.converted = " of --alpha-inverse " + *arguments.inverse;
  } else if (constexpr std::string_view column = "column:"; arguments.alpha->starts_with(column)) {
    option.column = arguments.alpha->substr(column.size());
  } else if (const std::optional<AlphaChoice> rule = parse_alpha_rule(*arguments.alpha)) {
    static_cast<AlphaChoice&>(option) = *rule;
  } else {
    option.radius = parse_real("--alpha", *arguments.alpha, any_radius, std::string(expected_alpha));
  }
  return option;
}

}  // namespace

std::size_t parse_components(const std::string& components) {
  return parse_whole("--components", components, {.least = 1});
}

double parse_cover(const std::string& cover) {
  return parse_real("--cover", cover, {above_0.least, 1}, "a share of the points, > 0 and <= 1");
}

AlphaOption parse_alpha(const RadiusArguments& arguments, ChosenFor chosen_for) {
  AlphaOption option = parse_option(arguments);
  if (option.column && chosen_for != ChosenFor::groups)
    bad_usage("--alpha", in_quotes(*arguments.alpha),
              std::string(expected_alpha) + " (column:NAME applies only to groups, as in rbpa shape --group-by)");
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

std::string alpha_text(const AlphaOption& option, std::optional<double> alpha) {
  if (option.rule == AlphaRule::given)
    return option.converted.empty() ? "" : ", alpha " + text_of(option.radius) + option.converted;
  std::string text = ", alpha " + name_of(option) + " = " + text_of(alpha);
  if (option.cover < 1) text += " with --cover " + text_of(option.cover);
  return text;
}

}  // namespace rbpa::app
