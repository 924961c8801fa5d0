// What: a list that is filled without looking whether there is room, after room was made for all.
// Why:  what is next cannot be predicted, so that values are written in any case and counted where they are meant.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "meshops/core/fresh_vector.h"

namespace rbpa::space {

template <typename T>
class Stack {
 public:
  void make_room(std::size_t more) {
    if (count_ + more > items_.size()) items_.resize(2 * (count_ + more));
  }
  /// Requires: room for one.
  void push(const T& value) { items_[count_++] = value; }
  /// Counts only if `is_meant`. Requires: room for one.
  void push_if(bool is_meant, const T& value) {
    items_[count_] = value;
    count_ += is_meant ? 1 : 0;
  }
  /// The same for three.
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
