// What: how loops and sorts over a boundary let their caller end them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "rbpa/core/error.h"

namespace rbpa {

/// Counts steps of tens to hundreds of nanoseconds each, and asks now and then whether to go on.
class Steps {
 public:
  /// Keeps a reference. Empty: nothing is asked.
  explicit Steps(const std::function<bool()>& go_on) : go_on_(go_on) {}

  /// So many more steps. Throws Cancelled.
  void operator()(std::size_t steps = 1) {
    if (left_ <= steps) return ask();
    left_ -= steps;
  }

 private:
  void ask() {
    left_ = interval;
    if (go_on_ && !go_on_()) throw Cancelled();
  }

  static constexpr std::size_t interval = 16384;
  const std::function<bool()>& go_on_;
  std::size_t left_ = interval;
};

/// std::sort(), each comparison a step. Throws Cancelled, with the values in any order.
template <typename Values, typename Less>
void sort(Values& values, Steps& step, const Less& less) {
  std::sort(values.begin(), values.end(), [&](const auto& a, const auto& b) {
    step();
    return less(a, b);
  });
}

}  // namespace rbpa
