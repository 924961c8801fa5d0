// What: counts how many of some integer vectors are linearly independent, exactly.
#pragma once

#include <array>
#include <cstdint>

#include "rbpa/base/exact/integer128.h"

namespace rbpa::space {

/// A number of boxes along each axis.
using Boxes = std::array<std::int32_t, 3>;

inline Boxes plus(const Boxes& a, const Boxes& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Boxes minus(const Boxes& a, const Boxes& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

class Rank {
 public:
  void add(const Boxes& v) {
    if (rank_ == 3 || v == Boxes{0, 0, 0}) return;
    if (rank_ == 0) {
      first_ = v;
      rank_ = 1;
    } else if (rank_ == 1) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        normal_[i] = Integer128{first_[j]} * v[k] - Integer128{first_[k]} * v[j];
      }
      if (normal_[0] != 0 || normal_[1] != 0 || normal_[2] != 0) rank_ = 2;
    } else if (normal_[0] * v[0] + normal_[1] * v[1] + normal_[2] * v[2] != 0) {
      rank_ = 3;
    }
  }
  unsigned value() const { return rank_; }

 private:
  unsigned rank_ = 0;
  Boxes first_ = {0, 0, 0};
  std::array<Integer128, 3> normal_ = {0, 0, 0};
};

}  // namespace rbpa::space
