// What: the rank of a system of equations over Z/2 that are added one by one.
// Cost: that of Gaussian elimination on the remaining terms of each; an equation in one unknown costs next to nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <vector>

#include "meshops/core/progress.h"

namespace meshops::detail {

class Z2Rank {
 public:
  /// Adds the equation that the sum of these unknowns is 0. An unknown that is named twice cancels. Throws Cancelled.
  void add(std::vector<std::size_t> unknowns, Steps& step) {
    std::sort(unknowns.begin(), unknowns.end());
    std::vector<std::size_t> row, sum;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      if (!row.empty() && row.back() == unknowns[i])
        row.pop_back();
      else
        row.push_back(unknowns[i]);
    while (!row.empty()) {
      step(row.size());
      const auto [slot, is_new] = rows_.try_emplace(row.front());
      if (is_new) {
        slot->second = std::move(row);
        return;
      }
      sum.clear();
      std::set_symmetric_difference(row.begin(), row.end(), slot->second.begin(), slot->second.end(),
                                    std::back_inserter(sum));
      row.swap(sum);
    }
  }
  std::size_t rank() const { return rows_.size(); }

 private:
  std::unordered_map<std::size_t, std::vector<std::size_t>> rows_;  // by the first unknown of each row
};

}  // namespace meshops::detail
