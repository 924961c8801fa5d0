// What: random numbers in [0, 1) for samplings, equal on every platform.
#pragma once

#include <cstdint>
#include <random>

namespace figures {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace figures
