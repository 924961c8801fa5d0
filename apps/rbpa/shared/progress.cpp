#include "shared/progress.h"

#include <algorithm>
#include <cmath>

#include "io/interrupt.h"

namespace rbpa::app {

std::string progress_text(const Progress& progress, double seconds) {
  const double done = static_cast<double>(progress.triangles);
  const double most = std::max(2 * static_cast<double>(progress.points), done);
  std::string text = triangles_text(progress, seconds);
  if (seconds <= 0 || done <= 0) return text;
  const double rate = done / seconds;
  text += ", " + short_number(rate) + "/s";
  if (seconds < 2 || done < most / 100) return text;
  return text + ", at most " + short_duration(std::ceil((most - done) / rate)) + " left";
}

std::string triangles_text(const Progress& progress, double /*seconds*/) {
  return short_number(static_cast<double>(progress.triangles)) + " triangles";
}

std::function<bool(const Progress&)> TriangleProgress::watch() {
  return [this](const Progress& progress) {
    triangles_ = progress.triangles;
    points_ = progress.points;
    if (!begun_ && progress.triangles > 0) {
      begun_ = true;
      line_.say([this](double seconds) { return text_({triangles_, points_}, seconds); });
    }
    return !interrupted();
  };
}

}  // namespace rbpa::app
