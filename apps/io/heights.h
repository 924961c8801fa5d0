// What: whether points that are read in the plane have heights, which are left out then.
#pragma once

#include <optional>

namespace rbpa::app {

class Heights {
 public:
  void take(double z) {
    if (!first_) first_ = z;
    differ_ = differ_ || z != *first_;
  }
  void take(const Heights& others) {
    if (others.first_) take(*others.first_);
    differ_ = differ_ || others.differ_;
  }
  /// A constant is none.
  bool differ() const { return differ_; }

 private:
  std::optional<double> first_ = std::nullopt;
  bool differ_ = false;
};

}  // namespace rbpa::app
