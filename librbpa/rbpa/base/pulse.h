// What: asks the caller, now and then, whether to go on.
// Cost: a count; a call of the caller's function every few milliseconds.
#pragma once

#include <cstdint>
#include <functional>

#include "rbpa/base/error.h"

namespace rbpa {

class Pulse {
 public:
  /// Keeps a reference. An empty function always goes on.
  explicit Pulse(const std::function<bool()>& go_on) : go_on_(go_on) {}

  /// After a small step, the comparison of two numbers or a triangle. Throws Cancelled.
  void beat() {
    if (++steps_ % interval == 0 && go_on_ && !go_on_()) throw Cancelled();
  }

 private:
  static constexpr std::uint32_t interval = 16384;

  const std::function<bool()>& go_on_;
  std::uint32_t steps_ = 0;
};

}  // namespace rbpa
