#include <array>
#include <stdexcept>
#include <vector>

#include "drawings/caption.h"
#include "drawings/figures.h"
#include "drawings/log_chart.h"
#include "drawings/measured.h"

namespace figures {
namespace {

/// Measured column, and the style of its curve.
struct Look {
  std::string_view column, name, color;
  bool dashed = false;
};

constexpr double nanosecond = 1e-9;

/// Returns the curves of those columns that exist, against the first column. A value is in `unit` seconds, divided by
/// the column `by` if that is given.
std::vector<Curve> curves_of(const Measured& all, std::span<const Look> looks, double unit, std::string_view by = {}) {
  std::vector<Curve> curves;
  const auto divisor = all.column(by);
  for (const Look& look : looks) {
    const auto column = all.column(look.column);
    if (!column) continue;
    Curve curve{look.name, look.color, look.dashed};
    for (const std::vector<double>& row : all.rows)
      curve.points.push_back({row[0], row[*column] * unit / (divisor ? row[*divisor] : 1)});
    curves.push_back(std::move(curve));
  }
  if (curves.empty()) throw std::runtime_error("found no column to draw in '" + all.head[1] + "'");
  return curves;
}

std::string thousands(double value) { return with_unit(value, ""); }
std::string seconds(double value) { return with_unit(value, "s"); }
std::string plain(double value) { return rounded(value, "%g"); }

constexpr Place one_size{560, 300}, pair_size{400, 300};

/// Writes the subject and the machine of the measurement below the charts.
void draw_head(Canvas& canvas, const Measured& all, double middle) {
  canvas.text({middle, 452}, all.head[1], Lettering::small, Align::middle);
  canvas.text({middle, 472}, all.head[0], Lettering::small, Align::middle);
}

std::string one_chart(const std::string& title, const Measured& all, const LogChart& chart) {
  Canvas canvas;
  draw(canvas, chart, {90, 76}, one_size);
  draw_legend(canvas, chart.curves, {60, 24});
  draw_head(canvas, all, 370);
  return canvas.svg(title, 740, 490);
}

std::string two_charts(const std::string& title, const Measured& all, const LogChart& left, const LogChart& right) {
  Canvas canvas;
  draw(canvas, left, {80, 76}, pair_size);
  draw(canvas, right, {580, 76}, pair_size);
  draw_legend(canvas, left.curves, {80, 24});
  draw_head(canvas, all, 510);
  return canvas.svg(title, 1020, 490);
}

std::string paper_6_timing() {
  static constexpr std::array looks{Look{"paper", "the paper's RBPA: cells of side 2α", color::inner},
                                    Look{"rbpa", "rbpa", color::curve},
                                    Look{"hrbpa_small_leaves", "hrbpa, leaves of 16 points", color::touched, true},
                                    Look{"hrbpa", "hrbpa", color::touched}};
  const Measured all = read_measured("paper_6_timing.csv");
  return two_charts("Time against the number of points: HRBPA, RBPA and the paper's RBPA", all,
                    {"(a) time", "points", thousands, seconds, curves_of(all, looks, 1)},
                    {"(b) time a point", "points", thousands, seconds, curves_of(all, looks, 1, "points")});
}

constexpr Look rbpa_look{"rbpa", "rbpa", color::curve},
    rbpa_2_look{"rbpa_2_threads", "rbpa 2 threads", color::curve, true},
    cgal_look{"cgal_points", "CGAL points", color::touched};

std::string performance_scaling() {
  static constexpr std::array looks{rbpa_look, rbpa_2_look, cgal_look,
                                    Look{"cgal_indices", "CGAL indices", color::inner}};
  const Measured all = read_measured("performance_scaling.csv");
  return one_chart("Time a point against the number of points: rbpa and CGAL", all,
                   {"time a point", "points", thousands, seconds, curves_of(all, looks, nanosecond)});
}

std::string performance_alpha() {
  static constexpr std::array looks{rbpa_look, rbpa_2_look,
                                    Look{"cgal_points_filter", "CGAL points + filter", color::touched}};
  const Measured all = read_measured("performance_alpha.csv");
  std::vector<Curve> of_triangles = curves_of(all, looks, nanosecond, "triangles");
  // The time per point, times points per triangle.
  const auto points = all.column("points");
  if (!points) throw std::runtime_error("found no column of points in '" + all.head[1] + "'");
  for (Curve& curve : of_triangles)
    for (std::size_t i = 0; i < curve.points.size(); ++i) curve.points[i].y *= all.rows[i][*points];
  return two_charts("Time against alpha: rbpa and CGAL", all,
                    {"(a) time a point", "alpha in mean spacings", plain, seconds, curves_of(all, looks, nanosecond)},
                    {"(b) time a triangle", "alpha in mean spacings", plain, seconds, std::move(of_triangles)});
}

std::string performance_density() {
  static constexpr std::array looks{rbpa_look, rbpa_2_look, cgal_look,
                                    Look{"cgal_indices", "CGAL indices", color::inner}};
  const Measured all = read_measured("performance_density.csv");
  return one_chart(
      "Time a point against how uneven the points are: rbpa and CGAL", all,
      {"time a point", "widest cluster / narrowest cluster", thousands, seconds, curves_of(all, looks, nanosecond)});
}

std::string bytes(double value) { return with_unit(value, "B"); }

/// Returns curves whose values are no times.
std::vector<Curve> curves_of(const Measured& all, std::span<const Look> looks) { return curves_of(all, looks, 1); }

/// Returns a chart of memory and disk use of a run, from its first tenth of a second on.
std::string scale_run() {
  static constexpr std::array looks{Look{"resident", "resident memory", color::curve},
                                    Look{"memory", "--memory", color::touched, true},
                                    Look{"scratch", "files in the scratch", color::inner}};
  Measured all = read_measured("scale_run.csv");
  std::erase_if(all.rows, [](const std::vector<double>& row) { return row[0] < 0.1; });
  return one_chart("Memory and disk of a run of rbpa stream over time", all,
                   {"bytes", "seconds since the beginning", plain, bytes, curves_of(all, looks)});
}

}  // namespace

std::span<const Figure> timing_figures() {
  static constexpr std::array figures = {
      Figure{"paper_6_timing", paper_6_timing}, Figure{"performance_scaling", performance_scaling},
      Figure{"performance_alpha", performance_alpha}, Figure{"performance_density", performance_density},
      Figure{"scale_run", scale_run}};
  return figures;
}

}  // namespace figures
