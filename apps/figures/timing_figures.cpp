#include <array>
#include <charconv>
#include <fstream>
#include <stdexcept>

#include "figures/figures.h"
#include "figures/log_chart.h"

namespace figures {
namespace {

/// What bench_timing has written: the date and the machine, what was measured, and a row for every number of points.
struct Measured {
  std::vector<std::string> head;
  struct Row {
    double points, triangles, hrbpa, hrbpa_small_leaves, rbpa, paper;  // from the third on in seconds
  };
  std::vector<Row> rows;
};

Measured measured(const std::string& path) {
  std::ifstream file(path);
  std::size_t number = 0;
  std::string line;
  const auto refuse = [&](const std::string& expected) {
    throw std::runtime_error(path + ":" + std::to_string(number) + ": found '" + line + "', expected " + expected);
  };
  Measured result;
  constexpr std::string_view columns = "points,triangles,hrbpa,hrbpa_small_leaves,rbpa,paper";
  bool begun = false;
  while (std::getline(file, line)) {
    ++number;
    if (line.starts_with("# ")) {
      result.head.push_back(line.substr(2));
    } else if (!begun) {
      if (line != columns) refuse(std::string(columns));
      begun = true;
    } else {
      std::array<double, 6> values{};
      const char* at = line.data();
      const char* const end = at + line.size();
      for (double& value : values) {
        const auto [rest, error] = std::from_chars(at, end, value);
        const bool is_last = &value == &values.back();
        if (error != std::errc{} || !(value > 0) || (is_last ? rest != end : rest == end || *rest != ','))
          refuse("six numbers above 0 with commas between them");
        at = is_last ? rest : rest + 1;
      }
      result.rows.push_back({values[0], values[1], values[2], values[3], values[4], values[5]});
    }
  }
  if (result.head.size() != 2 || result.rows.size() < 2)
    throw std::runtime_error(path + ": found " + std::to_string(result.head.size()) + " lines of head and " +
                             std::to_string(result.rows.size()) + " rows, expected 2 and at least 2");
  return result;
}

/// `scale(row)` is what a second is on the y axis.
template <typename Scale>
std::vector<Curve> curves_of(const Measured& all, Scale scale) {
  std::vector<Curve> curves{{"the paper's RBPA: cells of side 2α", colour::inner},
                            {"rbpa", colour::curve},
                            {"hrbpa, leaves of 16 points", colour::touched, true},
                            {"hrbpa", colour::touched}};
  for (const Measured::Row& row : all.rows) {
    const std::array seconds{row.paper, row.rbpa, row.hrbpa_small_leaves, row.hrbpa};
    for (std::size_t i = 0; i < curves.size(); ++i) curves[i].points.push_back({row.points, seconds[i] * scale(row)});
  }
  return curves;
}

std::string paper_6_timing() {
  const Measured all = measured(std::string(RBPA_FIGURE_DATA) + "/paper_6_timing.csv");
  const auto count = [](double value) { return with_unit(value, ""); };
  const auto seconds = [](double value) { return with_unit(value, "s"); };
  const LogChart total{"(a) time", "points", count, seconds, curves_of(all, [](const auto&) { return 1.0; })};
  const LogChart each{"(b) time a point", "points", count, seconds,
                      curves_of(all, [](const auto& row) { return 1 / row.points; })};
  constexpr Place size{400, 300};
  Canvas canvas;
  draw(canvas, total, {80, 76}, size);
  draw(canvas, each, {580, 76}, size);
  draw_legend(canvas, total.curves, {80, 24});
  constexpr double middle = 510;
  canvas.text({middle, 452}, all.head[1], Lettering::small, Align::middle);
  canvas.text({middle, 472}, all.head[0], Lettering::small, Align::middle);
  return canvas.svg("Time against the number of points: HRBPA, RBPA and the paper's RBPA", 1020, 490);
}

}  // namespace

std::span<const Figure> timing_figures() {
  static constexpr std::array figures = {Figure{"paper_6_timing", paper_6_timing}};
  return figures;
}

}  // namespace figures
