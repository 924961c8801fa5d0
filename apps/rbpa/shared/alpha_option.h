// What: parses `--alpha`, a radius or a rule that chooses a radius from the points, and applies the rule.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rbpa/base/alpha_choice.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/plateaus.h"
#include "shared/run.h"

namespace rbpa::app {

/// The options about the radius, as text. Exactly one of `alpha`, `squared` and `inverse` has a value.
struct RadiusArguments {
  std::optional<std::string> alpha = std::nullopt;
  std::optional<std::string> squared = std::nullopt;  ///< the square of the radius, as in CGAL and PostGIS
  std::optional<std::string> inverse = std::nullopt;  ///< one over the radius, as in Python's alphashape
  std::optional<std::string> components = std::nullopt;
  std::optional<std::string> cover = std::nullopt;
};

/// A choice of the radius, and the form of the choice on the command line.
struct AlphaOption : AlphaChoice {
  std::optional<std::string> column = std::nullopt;  ///< column of the radii, from "column:NAME"; only for groups
  std::string converted =
      {};  ///< such as " of --alpha-squared 25"; "" unless --alpha-squared or --alpha-inverse was given
};

/// Parses a number of solid components, at least 1. Throws WrongUsage.
std::size_t parse_components(const std::string& components);

/// Parses a share of the points, above 0 and at most 1. Throws WrongUsage.
double parse_cover(const std::string& cover);

enum class ChosenFor { all_points, groups };

/// Parses the options about the radius. Throws WrongUsage that names the value, or an option that does not apply to the
/// choice; "column:NAME" applies only to groups. Requires: exactly one of `alpha`, `squared` and `inverse` has a value.
AlphaOption parse_alpha(const RadiusArguments& arguments, ChosenFor chosen_for = ChosenFor::all_points);

/// Returns the choice in the form of --alpha, such as "auto" or "column:NAME"; "given" for a radius.
std::string name_of(const AlphaOption& option);

/// Returns a given radius, or the radius that the rule chooses, or nothing if the points have no triangle at any
/// radius. A rule triangulates the points, with a progress line and warnings about plateaus unless quiet. Throws
/// Cancelled after a signal, WrongUsage if there are fewer plateaus than the rank.
std::optional<double> choose_alpha(const AlphaChoice& choice, const std::vector<Point>& points, const RunOptions& run);

/// Returns "" or a warning about uneven density, as on the lines of a scanner: the best plateau is of the kind
/// one_piece, and another plateau of this kind has fewer parts and at least 1.25 times the area.
std::string warning_on_density(const std::vector<Plateau>& plateaus);

/// Returns ", alpha auto = 0.25" for a summary, in digits that read back to an equal radius, or ", alpha 5 of
/// --alpha-squared 25"; "" for a radius given by --alpha.
std::string alpha_text(const AlphaOption& option, std::optional<double> alpha);

}  // namespace rbpa::app
