#include "rbpa/space/solid/periodic/torus.h"

#include <algorithm>
#include <cmath>

#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"

namespace rbpa::space {
namespace {

double checked(double side) {
  if (!(side >= 0x1p-900) || !(side <= 0x1p900))
    throw InvalidInput("a side of the box is " + text(side) + ", expected three lengths above 0, from 2^-900 to 2^900");
  return side;
}

double step_of(double side) {
  constexpr int bits = 51;  // bits of a wrapped coordinate; an image needs one more, 52
  int exponent = 0;
  std::frexp(checked(side), &exponent);
  return std::ldexp(1.0, exponent - bits);
}

double rounded(double x, double step) { return std::nearbyint(x / step) * step; }

double wrapped(double x, double given, double step, double side) {
  double result = std::fmod(x, given);  // exact
  if (result < 0) result += given;
  result = rounded(result, step);
  return result < side ? result + 0.0 : result - side;  // no −0
}

}  // namespace

Torus::Torus(const Point3& box)
    : given_(box),
      step_{step_of(box.x), step_of(box.y), step_of(box.z)},
      box_{rounded(box.x, step_.x), rounded(box.y, step_.y), rounded(box.z, step_.z)},
      most_radius_(std::nextafter(std::min({box_.x, box_.y, box_.z}) / 2, 0.0)) {}

Point3 Torus::wrapped(const Point3& p) const {
  return {space::wrapped(p.x, given_.x, step_.x, box_.x), space::wrapped(p.y, given_.y, step_.y, box_.y),
          space::wrapped(p.z, given_.z, step_.z, box_.z)};
}

}  // namespace rbpa::space
