// What: times of repeated runs, and their text in a table.
#pragma once

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

namespace rbpa_bench {

struct Timings {
  std::vector<double> of;  ///< time of each run, in one unit

  double sum() const { return std::accumulate(of.begin(), of.end(), 0.0); }
  /// Returns the lower quartile: the cost of a run that is little disturbed.
  double lower_quartile() const {
    std::vector<double> sorted = of;
    std::sort(sorted.begin(), sorted.end());
    return sorted[(sorted.size() - 1) / 4];
  }
  double median() const {
    std::vector<double> sorted = of;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t middle = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
  }
  /// Returns a text: median (least–most).
  std::string text(int digits = 0) const {
    const auto [least, most] = std::minmax_element(of.begin(), of.end());
    char line[96];
    std::snprintf(line, sizeof line, "%.*f (%.*f–%.*f)", digits, median(), digits, *least, digits, *most);
    return line;
  }
};

}  // namespace rbpa_bench
