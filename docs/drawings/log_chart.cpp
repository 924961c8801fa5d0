#include "drawings/log_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drawings/caption.h"

namespace figures {
namespace {

/// Axis from low to high, both of them ticks, on pixels.
struct LogAxis {
  double low, high;
  double from, to;
  double at(double value) const { return from + (to - from) * std::log(value / low) / std::log(high / low); }
};

/// Returns 1, 2 and 5 times powers of ten, from the last one not above `low` to the first one not below `high`.
std::vector<double> ticks_around(double low, double high) {
  std::vector<double> ticks;
  for (int power = static_cast<int>(std::floor(std::log10(low)));; ++power)
    for (const int times : {1, 2, 5}) {
      // A negative power divides, so that 0.002 is the double of that literal.
      const double scale = std::pow(10, std::abs(power)), tick = power < 0 ? times / scale : times * scale;
      if (tick <= low) ticks.clear();
      ticks.push_back(tick);
      if (tick >= high) return ticks;
    }
}

bool is_power_of_ten(double tick) {
  const double logarithm = std::log10(tick);
  return std::abs(logarithm - std::round(logarithm)) < 0.1;
}

struct Scale {
  LogAxis axis;
  std::vector<double> ticks;
};

template <typename Value>
Scale scale_over(const std::vector<Curve>& curves, Value value, double from, double to) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const Curve& curve : curves)
    for (const Place p : curve.points) {
      low = std::min(low, value(p));
      high = std::max(high, value(p));
    }
  std::vector<double> ticks = ticks_around(low, high);
  const LogAxis axis{ticks.front(), ticks.back(), from, to};
  constexpr std::ptrdiff_t enough = 3;
  if (std::count_if(ticks.begin(), ticks.end(), is_power_of_ten) >= enough)
    std::erase_if(ticks, std::not_fn(is_power_of_ten));
  return {axis, ticks};
}

}  // namespace

std::string with_unit(double value, std::string_view unit) {
  constexpr std::array<std::string_view, 7> prefixes{"n", "µ", "m", "", "k", "M", "G"};
  std::size_t prefix = 3;
  for (; value >= 999.5 && prefix + 1 < prefixes.size(); ++prefix) value /= 1000;
  for (; value < 0.9995 && prefix > 0; --prefix) value *= 1000;
  const std::string said = std::string(prefixes[prefix]) + std::string(unit);
  return rounded(value) + (said.empty() ? "" : " ") + said;
}

void draw(Canvas& canvas, const LogChart& chart, Place upper_left, Place size) {
  const Place corner = upper_left + Place{0, size.y};  // the point at which the axes meet
  const Scale x = scale_over(
      chart.curves, [](Place p) { return p.x; }, corner.x, corner.x + size.x);
  const Scale y = scale_over(
      chart.curves, [](Place p) { return p.y; }, corner.y, corner.y - size.y);
  std::vector<Segment> grid;
  for (const double tick : x.ticks) {
    const Place foot{x.axis.at(tick), corner.y};
    grid.push_back({foot, foot - Place{0, size.y}, {}});
    canvas.text(foot + Place{0, 20}, chart.x_label(tick), Lettering::plain, Align::middle);
  }
  for (const double tick : y.ticks) {
    const Place foot{corner.x, y.axis.at(tick)};
    grid.push_back({foot, foot + Place{size.x, 0}, {}});
    canvas.text(foot + Place{-8, 5}, chart.y_label(tick), Lettering::plain, Align::end);
  }
  canvas.segments(grid, {color::pale, 1});
  canvas.segments({{upper_left, corner, {}}, {corner, corner + Place{size.x, 0}, {}}}, {color::text, 1});
  for (const Curve& curve : chart.curves) {
    std::vector<Place> places;
    for (const Place p : curve.points) places.push_back({x.axis.at(p.x), y.axis.at(p.y)});
    std::vector<Segment> pieces;
    for (std::size_t i = 1; i < places.size(); ++i) pieces.push_back({places[i - 1], places[i], {}});
    canvas.segments(pieces, {curve.color, 2, curve.dashed});
    canvas.dots(places, 3, curve.color);
  }
  canvas.text(upper_left + Place{size.x / 2, -14}, chart.heading, Lettering::plain, Align::middle);
  canvas.text(corner + Place{size.x / 2, 42}, chart.below, Lettering::plain, Align::middle);
}

void draw_legend(Canvas& canvas, const std::vector<Curve>& curves, Place at) {
  constexpr double letter = 8;  // approximate width of a letter
  for (const Curve& curve : curves) {
    canvas.segment({at, at + Place{26, 0}, {}}, {curve.color, 2, curve.dashed});
    canvas.dot(at + Place{13, 0}, 3, curve.color);
    canvas.text(at + Place{34, 5}, curve.name, Lettering::plain);
    at = at + Place{60 + letter * static_cast<double>(curve.name.size()), 0};
  }
}

}  // namespace figures
