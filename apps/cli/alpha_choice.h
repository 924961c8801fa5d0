// What: `--alpha`: a radius as the command line gives it, or a rule by which the points choose one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/run_options.h"
#include "rbpa/rbpa.h"

namespace rbpa::app {

enum class AlphaRule {
  given,      ///< a number > 0, or "inf"
  automatic,  ///< "auto": the least that covers every distinct point, in few enough solid components
  least       ///< "min": the least that covers every distinct point
};

struct AlphaChoice {
  AlphaRule rule = AlphaRule::given;
  double radius = 0;                ///< where it is given
  std::size_t most_components = 1;  ///< where it is automatic
};

/// A number of solid components: at least 1. Throws WrongUsage.
std::size_t parse_components(const std::string& components);

/// `components` as --components says; only "auto" takes it. Throws WrongUsage naming the value.
AlphaChoice parse_alpha(const std::string& text, const std::optional<std::string>& components);

/// "given", "auto", "min".
const char* name_of(AlphaRule rule);

/// The radius that the rule chooses; nothing when none covers the points, which have no triangle then at any radius.
/// A rule that asks the points triangulates them, with a progress line unless quiet. Throws Cancelled after a signal.
std::optional<double> choose_alpha(const AlphaChoice& choice, const std::vector<Point>& points, const RunOptions& run);

/// ", alpha auto = 0.25" for a summary, in digits that read back to the radius; "" where the command line has given it.
std::string said(const AlphaChoice& choice, std::optional<double> alpha);

}  // namespace rbpa::app
