#include "meshtopo/exact.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "io/interrupt.h"

namespace rbpa::app {
namespace {

using Integer = boost::multiprecision::cpp_int;

/// Returns an exponent e such that the finite double x is an integer times 2^e; the greatest int if x is 0.
int unit_exponent(double x) { return x == 0 ? std::numeric_limits<int>::max() : std::ilogb(x) - 52; }

Integer in_units(double x, int exponent) {
  if (x == 0) return 0;
  int own = 0;
  const auto digits = static_cast<std::int64_t>(std::scalbn(std::frexp(x, &own), 53));
  return Integer(digits) << static_cast<unsigned>(own - 53 -
                                                  exponent);  // not negative, as `exponent` is the least of all
}

/// Returns the sign of the volume, computed in integers: exact, but slow.
int volume_sign_in_integers(std::span<const Position> positions, std::span<const Triangle> triangles) {
  int exponent = std::numeric_limits<int>::max();
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t corner : triangle)
      for (const double x : positions[corner]) exponent = std::min(exponent, unit_exponent(x));
  Integer sum = 0;
  std::array<std::array<Integer, 3>, 3> p;
  for (const Triangle& triangle : triangles) {
    stop_if_interrupted();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) p[i][k] = in_units(positions[triangle[i]][k], exponent);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
      sum += p[0][k] * (p[1][x] * p[2][y] - p[1][y] * p[2][x]);
    }
  }
  return sum.sign();
}

/// Returns the sign of the volume, computed in rounded numbers, or nothing if the sign is not certain. Coordinates are
/// scaled into [−1, 1]; scaling changes a coordinate that underflows by less than 2^−1074. Differences to the first
/// corner have a relative error of ε = 2^−53. The error of a determinant of three differences is below 8ε times the sum
/// of its absolute products. The error of the sum of n determinants is below (n + 8)ε times the sum of all absolute
/// products (Higham, Accuracy and Stability of Numerical Algorithms, section 4.2); if products underflow, below 100 ·
/// 2^−1074 more for each triangle.
std::optional<int> rounded_volume_sign(std::span<const Position> positions, std::span<const Triangle> triangles) {
  double greatest = 0;
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t corner : triangle)
      for (const double x : positions[corner]) greatest = std::max(greatest, std::abs(x));
  if (greatest == 0) return 0;
  const int exponent = std::ilogb(greatest) + 1;
  const auto from_first = [&](std::uint32_t corner) {
    Position difference;
    for (std::size_t k = 0; k < 3; ++k)
      difference[k] = std::scalbn(positions[corner][k], -exponent) -
                      std::scalbn(positions[triangles.front().front()][k], -exponent);
    return difference;
  };
  double sum = 0, products = 0;
  std::size_t done = 0;
  for (const Triangle& triangle : triangles) {
    if (++done % 16384 == 0) stop_if_interrupted();
    const Position a = from_first(triangle[0]), b = from_first(triangle[1]), c = from_first(triangle[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
      const double one = b[x] * c[y], other = b[y] * c[x];
      sum += a[k] * (one - other);
      products += std::abs(a[k]) * (std::abs(one) + std::abs(other));
    }
  }
  const auto n = 3 * static_cast<double>(triangles.size());
  const double error = 2 * (n + 16) * 0x1p-53 * products + n * 0x1p-1060;  // twice the bound
  if (std::abs(sum) > error) return sum > 0 ? 1 : -1;
  return std::nullopt;
}

}  // namespace

int volume_sign(std::span<const Position> positions, std::span<const Triangle> triangles) {
  if (triangles.empty()) return 0;
  if (const std::optional<int> sign = rounded_volume_sign(positions, triangles)) return *sign;
  return volume_sign_in_integers(positions, triangles);
}

bool are_within(const Position& a, const Position& b, double distance) {
  // Bound the error: the sum of the squares and the square of the distance have relative errors below 6 · 2^−53 unless
  // they underflow.
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  const double squares = x * x + y * y + z * z, limit = distance * distance;
  constexpr double error = 1e-14, least = 1e-280;
  if (limit > least && std::isfinite(limit)) {
    if (squares < limit * (1 - error)) return true;
    if (squares > limit * (1 + error)) return false;  // taken also for an infinite sum
  }
  int exponent = unit_exponent(distance);
  for (std::size_t k = 0; k < 3; ++k) exponent = std::min({exponent, unit_exponent(a[k]), unit_exponent(b[k])});
  Integer sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer difference = in_units(a[k], exponent) - in_units(b[k], exponent);
    sum += difference * difference;
  }
  const Integer reach = in_units(distance, exponent);
  return sum <= reach * reach;
}

}  // namespace rbpa::app
