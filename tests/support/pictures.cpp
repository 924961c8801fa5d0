#include "support/pictures.h"

#include <algorithm>
#include <set>
#include <utility>

namespace rbpa_test {
namespace {

constexpr double pixel_area = 4, side = 2;

/// Labels of a grid with a margin of one; pixels are connected through sides. −1: not labeled.
struct Labels {
  std::size_t rows, columns;
  std::vector<int> of;
  int count = 0;

  int& at(std::size_t row, std::size_t column) { return of[row * columns + column]; }
};

template <typename Include>
Labels flood(std::size_t rows, std::size_t columns, Include&& include) {
  Labels labels{rows, columns, std::vector<int>(rows * columns, -1)};
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      if (!include(r, c) || labels.at(r, c) >= 0) continue;
      std::vector<std::pair<std::size_t, std::size_t>> open = {{r, c}};
      labels.at(r, c) = labels.count;
      while (!open.empty()) {
        const auto [y, x] = open.back();
        open.pop_back();
        const auto visit = [&](std::size_t row, std::size_t column) {
          if (row >= rows || column >= columns || !include(row, column) || labels.at(row, column) >= 0) return;
          labels.at(row, column) = labels.count;
          open.emplace_back(row, column);
        };
        visit(y + 1, x);
        visit(y, x + 1);
        if (y > 0) visit(y - 1, x);
        if (x > 0) visit(y, x - 1);
      }
      ++labels.count;
    }
  return labels;
}

}  // namespace

Points points_of(const Picture& picture) {
  std::set<std::pair<int, int>> places;
  for (std::size_t r = 0; r < picture.size(); ++r)
    for (std::size_t c = 0; c < picture[r].size(); ++c) {
      if (picture[r][c] != '#') continue;
      const int x = static_cast<int>(2 * c), y = -static_cast<int>(2 * r);
      places.insert({{x, y}, {x + 2, y}, {x, y + 2}, {x + 2, y + 2}, {x + 1, y + 1}});
    }
  Points points;
  for (const auto& [x, y] : places) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  return points;
}

Picture random_picture(std::size_t rows, std::size_t columns, double solid, Random& random) {
  Picture picture(rows, std::string(columns, '.'));
  for (std::string& row : picture)
    for (char& pixel : row)
      if (random.chance(solid)) pixel = '#';
  return picture;
}

std::vector<Part> parts_of(const Picture& picture, double min_hole, double min_part) {
  if (picture.empty()) return {};
  const std::size_t rows = picture.size() + 2, columns = picture[0].size() + 2;
  const auto solid = [&](std::size_t r, std::size_t c) {
    return r > 0 && c > 0 && r + 1 < rows && c + 1 < columns && picture[r - 1][c - 1] == '#';
  };
  Labels components = flood(rows, columns, solid);
  struct Filled {
    std::vector<bool> pixels;
    std::size_t holes = 0;
  };
  std::vector<Filled> parts;
  std::vector<int> covered_by(rows * columns, -1);  // the last part that filled the pixel
  for (int k = 0; k < components.count; ++k) {
    Filled part{std::vector<bool>(rows * columns, false)};
    Labels outside = flood(rows, columns, [&](std::size_t r, std::size_t c) { return components.at(r, c) != k; });
    std::vector<double> area(static_cast<std::size_t>(outside.count), 0);
    for (const int label : outside.of)
      if (label >= 0) area[static_cast<std::size_t>(label)] += pixel_area;
    for (std::size_t i = 0; i < outside.of.size(); ++i) {
      const int label = outside.of[i];
      const bool filled = label > 0 && area[static_cast<std::size_t>(label)] < min_hole;  // label 0 is the outside
      part.pixels[i] = label < 0 || filled;
      if (filled && components.of[i] >= 0) covered_by[i] = k;
    }
    for (std::size_t label = 1; label < area.size(); ++label) part.holes += area[label] >= min_hole ? 1U : 0U;
    parts.push_back(std::move(part));
  }

  std::vector<Part> result;
  std::vector<bool> covered(parts.size(), false);
  for (std::size_t i = 0; i < covered_by.size(); ++i)
    if (covered_by[i] >= 0) covered[static_cast<std::size_t>(components.of[i])] = true;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (covered[k]) continue;
    const std::vector<bool>& pixels = parts[k].pixels;
    Part part{0, 0, parts[k].holes};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (!pixels[i]) continue;  // the margin is never solid
      part.area += pixel_area;
      for (const std::size_t neighbor : {i - 1, i + 1, i - columns, i + columns})
        if (!pixels[neighbor]) part.perimeter += side;
    }
    if (part.area >= min_part) result.push_back(part);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace rbpa_test
