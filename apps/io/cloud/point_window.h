// What: a choice of points by their places: `--bounds` and `--resolution`.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <unordered_set>

namespace rbpa::app {

/// A box with its boundary.
struct PointBox {
  std::array<double, 3> least, greatest;  ///< for z, −inf and inf if heights are not bounded

  bool contains(const std::array<double, 3>& point) const {
    bool inside = true;
    for (std::size_t k = 0; k < (has_heights() ? 3 : 2); ++k)
      inside = inside && least[k] <= point[k] && point[k] <= greatest[k];
    return inside;
  }
  bool has_heights() const { return std::isfinite(least[2]); }
};

struct PointWindow {
  std::optional<PointBox> bounds = std::nullopt;
  /// Side of cells, each with at most one selected point; for COPC, the greatest spacing of the finest level.
  std::optional<double> resolution = std::nullopt;

  bool selects() const { return bounds || resolution; }
};

/// Returns the box of x0, y0, x1, y1, and perhaps z0, z1. Throws WrongUsage that names `option`.
PointBox box_of(const std::string& option, std::span<const double> numbers);

/// Parses the numbers of a box, with commas between them. Throws WrongUsage that names `option`.
PointBox parse_box(const std::string& option, const std::string& text);

/// Parses the values of --bounds and --resolution. Throws WrongUsage.
PointWindow parse_window(const std::optional<std::string>& bounds, const std::optional<std::string>& resolution);

/// Tests one point after another. Keeps points within the bounds, and of the points in a cell, a square in the plane or
/// a cube in space, only the first.
class WindowFilter {
 public:
  /// Takes window.resolution into account only if `thins`.
  WindowFilter(const PointWindow& window, bool in_space, bool thins)
      : bounds_(window.bounds), side_(thins ? window.resolution : std::nullopt), in_space_(in_space) {}

  bool keeps(const std::array<double, 3>& point);

 private:
  struct Hash {
    std::size_t operator()(const std::array<double, 3>& cell) const;
  };

  std::optional<PointBox> bounds_;
  std::optional<double> side_;
  bool in_space_;
  std::unordered_set<std::array<double, 3>, Hash> cells_ = {};
};

}  // namespace rbpa::app
