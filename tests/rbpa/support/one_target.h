// What: selects one target of the vector library at a time, among those that were compiled and that this processor has.
#pragma once

#include <hwy/targets.h>

#include <cstdint>

namespace rbpa_test {

class OneTarget {
 public:
  explicit OneTarget(std::int64_t target) { hwy::SetSupportedTargetsForTest(target); }
  ~OneTarget() { hwy::SetSupportedTargetsForTest(0); }
  OneTarget(const OneTarget&) = delete;
  OneTarget& operator=(const OneTarget&) = delete;
};

}  // namespace rbpa_test
