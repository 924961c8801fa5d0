// What: `--alpha`: a radius as the command line gives it, or a rule by which the points choose one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/run.h"
#include "rbpa/base/point.h"
#include "rbpa/covering.h"
#include "rbpa/plateaus.h"

namespace rbpa::app {

/// What the command line says, as text: one of the first three.
struct RadiusArguments {
  std::optional<std::string> alpha;
  std::optional<std::string> squared;  ///< as CGAL and PostGIS have it
  std::optional<std::string> inverse;  ///< as Python's alphashape has it
  std::optional<std::string> components;
  std::optional<std::string> cover;
};

enum class AlphaRule {
  given,      ///< a number > 0, or "inf"
  automatic,  ///< "auto": the least that covers every distinct point, or a share, in few enough solid components
  least,      ///< "min": the least that covers every distinct point, or a share
  plateau,    ///< "plateau": where the shape hardly changes
  column      ///< "column:NAME", of groups: a number beside the points
};

struct AlphaChoice {
  AlphaRule rule = AlphaRule::given;
  double radius = 0;               ///< where it is given
  std::size_t max_components = 1;  ///< where it is automatic
  std::size_t rank = 1;            ///< of the plateau: the best is 1
  std::string column = {};         ///< where it is one
  double cover = 1;                ///< share of the distinct points, where it is automatic or least
  std::string converted = {};      ///< " of --alpha-squared 25", where the radius was given so
};

/// A number of solid components: at least 1. Throws WrongUsage.
std::size_t parse_components(const std::string& components);

/// A share of the points: above 0 and at most 1. Throws WrongUsage.
double parse_cover(const std::string& cover);

enum class ChosenFor { all_points, groups };

/// Throws WrongUsage naming the value, or an option that this choice does not take. Requires: one of the first three.
AlphaChoice parse_alpha(const RadiusArguments& arguments, ChosenFor chosen_for = ChosenFor::all_points);

/// "given", "auto", "min", "plateau", "plateau:2", "column:r".
std::string name_of(const AlphaChoice& choice);

/// The radius that the rule chooses; nothing when none covers the points, which have no triangle then at any radius.
/// Requires: no column. A rule that asks the points triangulates them, with a progress line unless quiet. Throws Cancelled after a signal,
/// WrongUsage when there are fewer plateaus than the rank.
std::optional<double> choose_alpha(const AlphaChoice& choice, const std::vector<Point>& points, const RunOptions& run);

/// Returns the remark on uneven density, where the best plateau is one piece of dense points, such as the lines of a
/// scanner, and another plateau also covers the space between them; else "".
std::string remark_on_density(const std::vector<Plateau>& plateaus);

/// ", alpha auto = 0.25" for a summary, in digits that read back to the radius; "" where the command line has given it.
std::string said(const AlphaChoice& choice, std::optional<double> alpha);

}  // namespace rbpa::app
