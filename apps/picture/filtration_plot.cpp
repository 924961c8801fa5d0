#include "picture/filtration_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace rbpa::app {
namespace {

// Positions and sizes in pixels, from the upper left corner.
constexpr int left = 80, right = 800, image_width = 970, image_height = 1090;
constexpr int curves_top = 80, curves_bottom = 500;
constexpr int diagram_top = 600, never_dies = 605, last_death = 630, diagram_bottom = 1030;

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

/// A logarithmic axis: maps logarithms from low to high to pixels.
struct Axis {
  double low, high;
  int from, to;
  int at(double logarithm) const {
    const double share = std::clamp((logarithm - low) / (high - low), 0.0, 1.0);
    return static_cast<int>(std::lround(from + share * (to - from)));
  }
};

void line(std::string& svg, int x1, int y1, int x2, int y2, const char* style) {
  svg += std::string("<path d=\"M") + std::to_string(x1) + " " + std::to_string(y1) + "L" + std::to_string(x2) + " " +
         std::to_string(y2) + "\" " + style + "/>\n";
}

void text(std::string& svg, int x, int y, const std::string& words, const char* anchor) {
  svg += std::string("<text x=\"") + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\" text-anchor=\"" + anchor +
         "\">" + words + "</text>\n";
}

/// Returns 10 to the power `exponent` as text, even beyond the range of double.
std::string power_of_ten(double exponent) {
  constexpr double safe = 300;
  if (std::abs(exponent) <= safe) return number(std::pow(10, exponent));
  const double whole = std::floor(exponent);
  return number(std::pow(10, exponent - whole)) + (whole > 0 ? "e+" : "e") + number(whole);
}

/// Returns the ticks of an axis: at most nine powers of ten, or both ends if fewer than two such powers are inside.
std::vector<std::pair<double, std::string>> ticks(const Axis& axis) {
  std::vector<std::pair<double, std::string>> all;
  const double stride = std::max(1.0, std::ceil((axis.high - axis.low) / 8));
  for (double t = stride * std::ceil(axis.low / stride); t <= axis.high; t += stride)
    all.emplace_back(t, power_of_ten(t));
  if (all.size() < 2) all = {{axis.low, power_of_ten(axis.low)}, {axis.high, power_of_ten(axis.high)}};
  return all;
}

constexpr const char* grid = "stroke=\"#d3dbe3\" fill=\"none\"";

void draw_frame(std::string& svg, const Axis& x, int top, int bottom, const char* name) {
  for (const auto& [t, label] : ticks(x)) {
    line(svg, x.at(t), top, x.at(t), bottom, grid);
    text(svg, x.at(t), bottom + 20, label, "middle");
  }
  text(svg, (left + right) / 2, bottom + 42, name, "middle");
  line(svg, left, bottom, right, bottom, "stroke=\"#1b2733\"");
  line(svg, left, top, left, bottom, "stroke=\"#1b2733\"");
}

/// Draws a curve. Each column of pixels shows its least, its greatest and its last value.
void draw_curve(std::string& svg, const FiltrationPlot& plot, const Axis& x, const Axis& y, const PlotCurve& curve) {
  svg += std::string("<path fill=\"none\" stroke-width=\"2\" stroke=\"") + curve.color + "\" d=\"M" +
         std::to_string(left) + " " + std::to_string(y.from);
  const auto column = [&](std::size_t i) { return x.at(std::log10(plot.alpha[i])); };
  for (std::size_t i = 0; i < plot.alpha.size();) {
    const int at = column(i);
    std::size_t fewest = curve.counts[i], most = fewest;
    for (; i < plot.alpha.size() && column(i) == at; ++i) {
      fewest = std::min(fewest, curve.counts[i]);
      most = std::max(most, curve.counts[i]);
    }
    svg += std::string("H") + std::to_string(at);
    for (const std::size_t count : {fewest, most, curve.counts[i - 1]})
      svg += std::string("V") + std::to_string(y.at(std::log10(1 + static_cast<double>(count))));
  }
  svg += std::string("H") + std::to_string(right) + "\"/>\n";
}

void draw_mark(std::string& svg, const Axis& x, const std::optional<double>& alpha, const std::string& name, int y) {
  if (!alpha) return;
  const int at = x.at(std::log10(*alpha));
  // Draw the line below the labels of all marks.
  line(svg, at, curves_top - 10, at, curves_bottom, "stroke=\"#1b2733\" stroke-dasharray=\"5 4\"");
  text(svg, at, y, name + " = " + number(*alpha), at < 200 ? "start" : at > 700 ? "end" : "middle");
}

void draw_band(std::string& svg, const Axis& x, const Plateau& plateau) {
  const int from = x.at(std::log10(plateau.from)), to = plateau.to ? x.at(std::log10(*plateau.to)) : right;
  svg += "<rect x=\"" + std::to_string(from) + "\" y=\"" + std::to_string(curves_top) + "\" width=\"" +
         std::to_string(to - from) + "\" height=\"" + std::to_string(curves_bottom - curves_top) +
         "\" fill=\"#e6f0f9\"/>\n";
}

/// Draws an entry of the key to the right of the plot.
void draw_key(std::string& svg, int y, const std::string& name, const std::string& color) {
  line(svg, right + 15, y - 5, right + 35, y - 5, ("stroke-width=\"3\" stroke=\"" + color + "\"").c_str());
  text(svg, right + 42, y, name, "start");
}

void draw_curves(std::string& svg, const FiltrationPlot& plot, const Axis& x) {
  std::size_t most = 1;
  for (const PlotCurve& curve : plot.curves)
    for (const std::size_t count : curve.counts) most = std::max(most, count);
  const Axis y{0, std::log10(1 + static_cast<double>(most)), curves_bottom, curves_top};
  if (plot.plateau) draw_band(svg, x, *plot.plateau);
  draw_frame(svg, x, curves_top, curves_bottom, "alpha");
  text(svg, left - 8, curves_bottom + 5, "0", "end");
  for (double t = 1; t <= static_cast<double>(most); t *= 10) {
    const int at = y.at(std::log10(1 + t));
    line(svg, left, at, right, at, grid);
    text(svg, left - 8, at + 5, number(t), "end");
  }
  int row = curves_top + 20;
  for (const PlotCurve& curve : plot.curves) {
    draw_curve(svg, plot, x, y, curve);
    draw_key(svg, row, curve.name, curve.color);
    row += 24;
  }
  if (plot.plateau) draw_mark(svg, x, plot.plateau->alpha, "plateau", 18);
  draw_mark(svg, x, plot.least_covering, "min", 40);
  draw_mark(svg, x, plot.least_connected, "auto", 62);
}

/// Draws the pairs as dots. Dots of one color at one pixel are drawn once.
void draw_diagram(std::string& svg, const FiltrationPlot& plot, const Axis& x) {
  const Axis y{x.low, x.high, diagram_bottom, last_death};
  draw_frame(svg, x, diagram_top, diagram_bottom, "birth");
  text(svg, left, diagram_top - 15, "death", "end");
  for (const auto& [t, label] : ticks(y)) text(svg, left - 8, y.at(t) + 5, label, "end");
  line(svg, left, diagram_bottom, right, last_death, grid);
  line(svg, left, never_dies, right, never_dies, "stroke=\"#7d8b98\" stroke-dasharray=\"5 4\"");
  text(svg, right + 10, never_dies + 5, "never dies", "start");
  // For each dimension, column and row of the image: whether there is a dot.
  std::vector<bool> has_dot(plot.dimensions.size() * image_width * image_height, false);
  for (const PersistencePair& pair : plot.pairs) {
    const int death = pair.death ? y.at(std::log10(*pair.death)) : never_dies;
    const int column = pair.dimension * image_width + x.at(std::log10(pair.birth));
    has_dot[static_cast<std::size_t>(column * image_height + death)] = true;
  }
  for (std::size_t i = 0; i < has_dot.size(); ++i)
    if (has_dot[i])
      svg += std::string("<circle r=\"3\" cx=\"") + std::to_string(i / image_height % image_width) + "\" cy=\"" +
             std::to_string(i % image_height) + "\" fill=\"" + plot.dimensions[i / image_height / image_width].color +
             "\"/>\n";
  int row = last_death + 20;
  for (const PlotDimension& dimension : plot.dimensions) {
    draw_key(svg, row, dimension.name, dimension.color);
    row += 24;
  }
}

constexpr const char *dark_blue = "#10335c", *orange = "#d9730d", *green = "#2f8f5b", *gray = "#7d8b98",
                     *light_blue = "#7cb7e8";

}  // namespace

FiltrationPlot plot_of(std::span<const FiltrationStep> steps, std::vector<PersistencePair> pairs) {
  FiltrationPlot plot{.alpha = {},
                      .curves = {{"covered points", gray},
                                 {"holes", orange},
                                 {"solid components", light_blue},
                                 {"components", dark_blue}},
                      .pairs = std::move(pairs),
                      .dimensions = {{"components", dark_blue}, {"holes", orange}}};
  for (const FiltrationStep& step : steps) {
    plot.alpha.push_back(step.alpha);
    std::size_t curve = 0;
    for (const std::size_t count : {step.covered, step.holes, step.solid_components, step.components})
      plot.curves[curve++].counts.push_back(count);
  }
  return plot;
}

FiltrationPlot plot_of(std::span<const SolidPair> pairs) {
  FiltrationPlot plot{.alpha = {},
                      .curves = {{"components", dark_blue}, {"tunnels", orange}, {"voids", green}},
                      .dimensions = {{"components", dark_blue}, {"tunnels", orange}, {"voids", green}}};
  // List the changes of counts: the radius, and the dimension plus one, negative if the count falls.
  std::vector<std::pair<double, int>> changes;
  changes.reserve(2 * pairs.size());
  plot.pairs.reserve(pairs.size());
  std::array<std::size_t, 3> count = {0, 0, 0};
  for (const SolidPair& pair : pairs) {
    plot.pairs.push_back({pair.dimension, pair.birth, pair.death});
    if (pair.birth > 0)
      changes.emplace_back(pair.birth, pair.dimension + 1);
    else
      ++count[static_cast<std::size_t>(pair.dimension)];
    if (pair.death) changes.emplace_back(*pair.death, -1 - pair.dimension);
  }
  std::sort(changes.begin(), changes.end());
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const auto& [alpha, change] = changes[i];
    change > 0 ? ++count[static_cast<std::size_t>(change - 1)] : --count[static_cast<std::size_t>(-1 - change)];
    if (i + 1 < changes.size() && changes[i + 1].first == alpha) continue;
    plot.alpha.push_back(alpha);
    for (std::size_t dimension = 0; dimension < 3; ++dimension)
      plot.curves[dimension].counts.push_back(count[dimension]);
  }
  return plot;
}

std::string svg_of(const FiltrationPlot& plot) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double alpha : plot.alpha)
    if (std::isfinite(alpha)) {
      low = std::min(low, std::log10(alpha));
      high = std::max(high, std::log10(alpha));
    }
  if (!(low <= high)) low = high = 0;
  const double margin = high > low ? (high - low) / 40 : 1;
  const Axis x{low - margin, high + margin, left, right};
  const std::string size =
      std::string("width=\"") + std::to_string(image_width) + "\" height=\"" + std::to_string(image_height) + "\"";
  std::string svg = std::string("<svg xmlns=\"http://www.w3.org/2000/svg\" ") + size +
                    " font-family=\"sans-serif\" font-size=\"14\">\n";
  svg += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  draw_curves(svg, plot, x);
  draw_diagram(svg, plot, x);
  return svg + "</svg>\n";
}

}  // namespace rbpa::app
