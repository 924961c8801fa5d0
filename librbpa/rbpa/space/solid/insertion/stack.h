// What: a list that appends values without a check of the capacity, after a call of make_room().
// Why:  a branch on whether a value is wanted would be mispredicted. All values are written; only wanted ones are
//       counted.
#pragma once

#include <array>
#include <cstddef>

#include "meshops/core/fresh_vector.h"

namespace rbpa::space {

template <typename T>
class Stack {
 public:
  /// Ensures that `more` further values can be written.
  void make_room(std::size_t more) {
    if (count_ + more > items_.size()) items_.resize(2 * (count_ + more));
  }
  /// Appends a value. Requires: room for one value.
  void push(const T& value) { items_[count_++] = value; }
  /// Appends a value if `is_meant`, without a branch. Requires: room for one value.
  void push_if(bool is_meant, const T& value) {
    items_[count_] = value;
    count_ += is_meant ? 1 : 0;
  }
  /// Appends three values if `is_meant`, without a branch. Requires: room for three values.
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
