// What: random numbers that are the same with every standard library (the standard distributions are not).
// Law:  a seed names one sequence, on every platform.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace rbpa_test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Returns a uniform number in [0, 2⁶⁴).
  std::uint64_t bits() { return engine_(); }

  /// Returns a number in [0, bound), bound > 0. The bias is below bound / 2⁶⁴.
  std::uint64_t below(std::uint64_t bound) { return engine_() % bound; }

  /// Returns a number in [first, last], both included.
  int integer(int first, int last) {
    return first + static_cast<int>(below(static_cast<std::uint64_t>(std::int64_t{last} - first + 1)));
  }

  /// Returns a multiple of 2⁻⁵³ in [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  double between(double low, double high) { return low + (high - low) * unit(); }

  bool chance(double probability) { return unit() < probability; }

  template <typename Value>
  void shuffle(std::vector<Value>& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
  }

 private:
  std::mt19937_64 engine_;  // its output is fixed by the standard
};

}  // namespace rbpa_test
