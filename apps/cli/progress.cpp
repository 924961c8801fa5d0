#include "cli/progress.h"

#include <algorithm>
#include <cmath>

#include "io/interrupt.h"

namespace rbpa::app {

std::string progress_text(const Progress& progress, double seconds) {
  const double done = static_cast<double>(progress.triangles);
  const double most = std::max(2 * static_cast<double>(progress.points), done);
  std::string text = short_number(done) + " triangles";
  if (seconds <= 0 || done <= 0) return text;
  const double rate = done / seconds;
  text += ", " + short_number(rate) + "/s";
  if (seconds < 2 || done < most / 100) return text;
  return text + ", at most " + short_duration(std::ceil((most - done) / rate)) + " left";
}

std::function<bool(const Progress&)> TriangleProgress::watch() {
  return [this](const Progress& progress) {
    triangles_ = progress.triangles;
    points_ = progress.points;
    if (!begun_) line_.say([this](double seconds) { return progress_text({triangles_, points_}, seconds); });
    begun_ = true;
    return !interrupted();
  };
}

}  // namespace rbpa::app
