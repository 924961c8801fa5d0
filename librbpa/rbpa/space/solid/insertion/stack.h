// What: a list to which values are added without a check of the capacity, after make_room().
// Why:  processors cannot predict whether a value is wanted, so every value is written and only wanted ones are
//       counted.
#pragma once

#include <array>
#include <cstddef>

#include "meshops/core/fresh_vector.h"

namespace rbpa::space {

template <typename T>
class Stack {
 public:
  /// Makes room for `more` further values.
  void make_room(std::size_t more) {
    if (count_ + more > items_.size()) items_.resize(2 * (count_ + more));
  }
  /// Requires: room for one.
  void push(const T& value) { items_[count_++] = value; }
  /// Writes the value, and counts it only if `is_meant`. Requires: room for one.
  void push_if(bool is_meant, const T& value) {
    items_[count_] = value;
    count_ += is_meant ? 1 : 0;
  }
  /// Writes three values, and counts them only if `is_meant`. Requires: room for three.
  void push_if(bool is_meant, const std::array<T, 3>& values) {
    for (std::size_t i = 0; i < 3; ++i) items_[count_ + i] = values[i];
    count_ += is_meant ? 3 : 0;
  }
  T pop() { return items_[--count_]; }
  void clear() { count_ = 0; }

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  T& operator[](std::size_t i) { return items_[i]; }
  const T& operator[](std::size_t i) const { return items_[i]; }

 private:
  meshops::FreshVector<T> items_;
  std::size_t count_ = 0;
};

}  // namespace rbpa::space
