// What: a JSON text while it is parsed, and the member "id" of an object in it, for messages.
#pragma once

#include <cstddef>
#include <iterator>
#include <string>

namespace rbpa::app {

/// The text as nlohmann's parser wants it; how far it has come is seen by others.
class JsonPosition {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  explicit JsonPosition(const char*& at) : at_(&at) {}
  reference operator*() const { return **at_; }
  JsonPosition& operator++() {
    ++*at_;
    return *this;
  }
  friend bool operator==(const JsonPosition& a, const JsonPosition& b) { return *a.at_ == *b.at_; }
  friend bool operator!=(const JsonPosition& a, const JsonPosition& b) { return !(a == b); }

 private:
  const char** at_;
};

/// The "id" of the object that begins at `begin`, of a text with its quotes; empty where its first mebibyte has none.
std::string json_id(const char* begin, const char* end);

}  // namespace rbpa::app
