#include "stream/pass_progress.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rbpa::app {
namespace {

/// Returns the line of progress, such as "2/4 cutting, 45 %, 12.0 M points, 3.40 M/s, 20 s left".
std::string pass_text(const std::string& doing, double share, double points, double seconds) {
  share = std::clamp(share, 0.0, 1.0);
  std::string text =
      doing + ", " + std::to_string(static_cast<int>(100 * share)) + " %, " + short_number(points) + " points";
  if (seconds <= 0 || points <= 0) return text;
  text += ", " + short_number(points / seconds) + "/s";
  if (seconds < 2 || share < 0.01) return text;
  return text + ", " + short_duration(std::ceil(seconds * (1 - share) / share)) + " left";
}

}  // namespace

PassProgress::PassProgress(bool wanted, std::string doing, std::uint64_t whole)
    : doing_(std::move(doing)),
      whole_(static_cast<double>(std::max<std::uint64_t>(whole, 1))),
      line_("rbpa", wanted, doing_) {
  line_.say([this](double seconds) {
    return pass_text(doing_, static_cast<double>(done_) / whole_, static_cast<double>(points_), seconds);
  });
}

}  // namespace rbpa::app
