// What: reports the position of a JSON parser in its text, and finds the member "id" of an object, for messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>

#include "io/interrupt.h"

namespace rbpa::app {

/// An iterator for nlohmann's parser that advances the caller's pointer, so that the caller knows the position.
class JsonPosition {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  explicit JsonPosition(const char*& at) : at_(&at) {}
  reference operator*() const { return **at_; }
  /// Advances by a character. Throws Cancelled after a signal: a text or a number may have hundreds of megabytes.
  JsonPosition& operator++() {
    constexpr std::uintptr_t often = std::uintptr_t{1} << 20U;
    if (reinterpret_cast<std::uintptr_t>(++*at_) % often == 0) stop_if_interrupted();
    return *this;
  }
  friend bool operator==(const JsonPosition& a, const JsonPosition& b) { return *a.at_ == *b.at_; }
  friend bool operator!=(const JsonPosition& a, const JsonPosition& b) { return !(a == b); }

 private:
  const char** at_;
};

/// Returns the "id" of the JSON object from `begin` on, with quotes if it is a text; empty if the first mebibyte of the
/// object, at most up to `end`, has no "id".
std::string json_id(const char* begin, const char* end);

}  // namespace rbpa::app
