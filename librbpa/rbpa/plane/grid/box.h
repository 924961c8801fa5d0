// What: axis-parallel boxes around points.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point.h"

namespace rbpa {

struct Box {
  Point low, high;
};

inline Box common_box(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

/// Returns the least box around points. Requires: at least one point.
inline Box box_of(std::span<const Point> points) {
  Box box{points[0], points[0]};
  for (const Point& p : points) box = common_box(box, {p, p});
  return box;
}

/// Returns the least box around points, computed by several threads. Requires: at least one point.
inline Box box_of(std::span<const Point> points, Threads& threads) {
  constexpr std::size_t at_a_time = 1u << 16;  // points for one thread
  std::vector<Box> boxes((points.size() + at_a_time - 1) / at_a_time);
  for_each_part(threads, points.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    boxes[first / at_a_time] = box_of(points.subspan(first, last - first));
  });
  Box box = boxes[0];
  for (const Box& other : boxes) box = common_box(box, other);
  return box;
}

}  // namespace rbpa
