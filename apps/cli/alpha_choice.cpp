#include "cli/alpha_choice.h"

#include <limits>
#include <string_view>

#include "cli/build.h"
#include "cli/progress.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/whole_number.h"
#include "rbpa/filtration/filtration.h"

namespace rbpa::app {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double parse_radius(const std::string& text) {
  const ParsedNumber number = parse_whole_number(text);
  const bool infinite = number.fault == NumberFault::not_finite && number.value > 0;
  if (infinite) return infinity;
  if (number.fault != NumberFault::none || !(number.value > 0))
    throw WrongUsage("--alpha: found " + in_quotes(text) + ", expected a radius (a number > 0, or inf), auto or min");
  return number.value;
}

}  // namespace

std::size_t parse_components(const std::string& components) {
  return parse_whole("--components", components, {.least = 1});
}

AlphaChoice parse_alpha(const std::string& text, const std::optional<std::string>& components) {
  AlphaChoice choice;
  if (text == "auto")
    choice.rule = AlphaRule::automatic;
  else if (text == "min")
    choice.rule = AlphaRule::least;
  else
    choice.radius = parse_radius(text);
  if (components && choice.rule != AlphaRule::automatic)
    throw WrongUsage("--components: found --alpha " + text + ", expected --alpha auto, which is what it is about");
  if (components) choice.most_components = parse_components(*components);
  return choice;
}

const char* name_of(AlphaRule rule) {
  switch (rule) {
    case AlphaRule::automatic:
      return "auto";
    case AlphaRule::least:
      return "min";
    case AlphaRule::given:
      break;
  }
  return "given";
}

std::optional<double> choose_alpha(const AlphaChoice& choice, const std::vector<Point>& points, const RunOptions& run) {
  if (choice.rule == AlphaRule::given) return choice.radius;
  const SolidAlphaComplex delaunay = build(points, infinity, run);
  const ProgressLine line("rbpa", !run.quiet, "choosing alpha");
  const Filtration all = filtration(delaunay, points, until_interrupted());
  return choice.rule == AlphaRule::least ? smallest_covering(all) : smallest_covering(all, choice.most_components);
}

std::string said(const AlphaChoice& choice, std::optional<double> alpha) {
  if (choice.rule == AlphaRule::given) return "";
  const std::string before = std::string(", alpha ") + name_of(choice.rule) + " = ";
  return before + (alpha ? std::string(std::string_view(ShortestText(*alpha))) : "none");
}

}  // namespace rbpa::app
