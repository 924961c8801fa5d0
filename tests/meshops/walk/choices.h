// The source of the decisions of a random walk: a generator of numbers, or the bytes of a fuzzer.
#pragma once

#include <cstdint>
#include <random>
#include <span>

namespace meshops::test {

class Choices {
 public:
  virtual ~Choices() = default;
  /// Returns a number from 0 on, below `bound`, which is not 0.
  virtual unsigned below(unsigned bound) = 0;
  /// Returns whether any choice is left; without it, every choice is 0.
  virtual bool any_left() const = 0;

  bool one_in(unsigned n) { return below(n) == 0; }
};

class RandomChoices : public Choices {
 public:
  explicit RandomChoices(std::uint64_t seed) : random_(seed) {}
  unsigned below(unsigned bound) override { return static_cast<unsigned>((random_() >> 32U) % bound); }
  bool any_left() const override { return true; }

 private:
  std::mt19937_64 random_;
};

/// Takes one byte for each choice, two if there are more than 256 options.
class ByteChoices : public Choices {
 public:
  explicit ByteChoices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  unsigned below(unsigned bound) override {
    const unsigned low = next();
    return (bound > 256 ? low | next() << 8U : low) % bound;
  }
  bool any_left() const override { return !bytes_.empty(); }

 private:
  unsigned next() {
    if (bytes_.empty()) return 0;
    const unsigned byte = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return byte;
  }
  std::span<const std::uint8_t> bytes_;
};

/// Returns a choice below `bound`; 0 without using a choice if there is at most one option.
inline unsigned below(Choices& choices, std::uint32_t bound) { return bound < 2 ? 0 : choices.below(bound); }

}  // namespace meshops::test
