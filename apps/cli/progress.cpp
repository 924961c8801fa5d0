#include "cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "io/interrupt.h"

namespace rbpa::app {
namespace {

/// Three digits and a unit: 950, 1.23 k, 45.6 M.
std::string short_number(double value) {
  const char* unit = "";
  for (const char* larger : {" k", " M", " G"}) {
    if (value < 999.5) break;
    value /= 1000;
    unit = larger;
  }
  char text[32];
  const int decimals = *unit == '\0' || value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2;
  std::snprintf(text, sizeof text, "%.*f%s", decimals, value, unit);
  return text;
}

}  // namespace

std::string progress_text(const Progress& progress, double seconds) {
  const double done = static_cast<double>(progress.triangles);
  const double most = std::max(2 * static_cast<double>(progress.points), done);
  std::string text = short_number(done) + " triangles";
  if (seconds <= 0 || done <= 0) return text;
  const double rate = done / seconds;
  return text + ", " + short_number(rate) + "/s, at most " + short_number(std::ceil((most - done) / rate)) + " s left";
}

ProgressLine::ProgressLine(bool wanted) : shown_(wanted && isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (written_) std::fputs("\r\x1b[K", stderr);
}

std::function<bool(const Progress&)> ProgressLine::watch() {
  return [this](const Progress& progress) {
    show([&](double seconds) { return progress_text(progress, seconds); });
    return !interrupted();
  };
}

std::function<bool()> ProgressLine::watch(std::string doing) {
  return [this, doing = std::move(doing)] {
    show([&](double seconds) { return doing + ", " + short_number(std::floor(seconds)) + " s"; });
    return !interrupted();
  };
}

template <typename Text>
void ProgressLine::show(const Text& text) {
  const Clock::time_point now = Clock::now();
  if (!shown_ || now < next_) return;
  next_ = now + std::chrono::milliseconds(200);
  const double seconds = std::chrono::duration<double>(now - start_).count();
  std::fprintf(stderr, "\r\x1b[Krbpa: %s", text(seconds).c_str());
  std::fflush(stderr);
  written_ = true;
}

}  // namespace rbpa::app
