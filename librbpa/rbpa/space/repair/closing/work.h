// What: keeps the budget for closing holes: the number of pairs of triangles, and of edges, that may still be compared.
// Law:  the budget is a count, not a time, so it does not depend on the order of the input, the machine or the threads.
#pragma once

#include <algorithm>
#include <cstddef>

#include "meshops/core/progress.h"
#include "rbpa/base/progress.h"

namespace rbpa::space {

class Work {
 public:
  /// Keeps a reference to `go_on`.
  Work(std::size_t most, const GoOn& go_on) : left_(most), step_(go_on) {}

  /// Spends `pairs` of the budget. Throws: Cancelled.
  void operator()(std::size_t pairs = 1) {
    step_(pairs);
    left_ -= std::min(left_, pairs);
  }
  bool is_over() const { return left_ == 0; }
  meshops::Steps& steps() { return step_; }

 private:
  std::size_t left_;
  meshops::Steps step_;
};

}  // namespace rbpa::space
