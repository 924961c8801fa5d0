// What: `--alpha`: a radius as the command line gives it, or a rule by which the points choose one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/plane/plateaus.h"
#include "rbpa/plane/smallest_covering_alpha.h"
#include "shared/run.h"

namespace rbpa::app {

/// The options about the radius, as text: exactly one of the first three is present.
struct RadiusArguments {
  std::optional<std::string> alpha;
  std::optional<std::string> squared;  ///< the square of the radius, as in CGAL and PostGIS
  std::optional<std::string> inverse;  ///< one over the radius, as in Python's alphashape
  std::optional<std::string> components;
  std::optional<std::string> cover;
};

enum class AlphaRule {
  given,      ///< a number > 0, or "inf"
  automatic,  ///< "auto": the least that covers all distinct points, or a share, in few enough solid components
  least,      ///< "min": the least that covers all distinct points, or a share
  plateau,    ///< "plateau": a radius around which the shape hardly changes
  column      ///< "column:NAME": for groups only; the radius is in a column of the points
};

struct AlphaChoice {
  AlphaRule rule = AlphaRule::given;
  double radius = 0;               ///< for `given`
  std::size_t max_components = 1;  ///< for `automatic`
  std::size_t rank = 1;            ///< for `plateau`: 1 is the best
  std::string column = {};         ///< name of the column, for `column`
  double cover = 1;                ///< share of the distinct points, for `automatic` and `least`
  std::string converted = {};      ///< " of --alpha-squared 25" if the radius was given that way
};

/// Parses a number of solid components: at least 1. Throws WrongUsage.
std::size_t parse_components(const std::string& components);

/// Parses a share of the points: above 0 and at most 1. Throws WrongUsage.
double parse_cover(const std::string& cover);

enum class ChosenFor { all_points, groups };

/// Parses the options about the radius. Throws WrongUsage that names the value, or an option that does not apply to
/// this choice. Requires: exactly one of the first three arguments is present.
AlphaChoice parse_alpha(const RadiusArguments& arguments, ChosenFor chosen_for = ChosenFor::all_points);

/// Returns "given", "auto", "min", "plateau", "plateau:2" or "column:r".
std::string name_of(const AlphaChoice& choice);

/// Returns the radius that the rule chooses, or nothing if the points have no triangle at any radius. Every rule but
/// `given` triangulates the points, with a progress line unless quiet.
/// Requires: the rule is not `column`. Throws Cancelled after a signal, WrongUsage if there are fewer plateaus than the
/// rank.
std::optional<double> choose_alpha(const AlphaChoice& choice, const std::vector<Point>& points, const RunOptions& run);

/// Returns a warning about uneven density if the best plateau is one piece of dense points, such as the lines of a
/// scanner, and another plateau also covers the space between them; else "".
std::string warning_on_density(const std::vector<Plateau>& plateaus);

/// Returns ", alpha auto = 0.25" for a summary, in digits that read back to the same radius; "" for a radius that was
/// given as such.
std::string said(const AlphaChoice& choice, std::optional<double> alpha);

}  // namespace rbpa::app
