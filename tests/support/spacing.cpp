#include "support/spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/order.h"

namespace rbpa_test {

double mean_spacing(std::span<const rbpa::Point> points) {
  std::vector<rbpa::Point> distinct(points.begin(), points.end());
  sort_distinct(distinct);
  if (distinct.size() < 2) return 1;

  double low = distinct.front().y, high = distinct.front().y;
  for (const rbpa::Point& p : distinct) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  constexpr double largest = std::numeric_limits<double>::max();
  const double width = std::min(distinct.back().x - distinct.front().x, largest);
  const double height = std::min(high - low, largest);
  const double count = static_cast<double>(distinct.size());
  // Roots are taken before the product: the area may be out of range where the spacing is not.
  const double spacing = std::sqrt(width / count) * std::sqrt(height);
  if (spacing > 0) return spacing;
  return std::max(std::max(width, height) / count, std::numeric_limits<double>::denorm_min());
}

std::vector<double> usual_alphas(std::span<const rbpa::Point> points) {
  const double spacing = mean_spacing(points);
  std::vector<double> alphas;
  for (const double factor : {1e-3, 0.5, 1.0, 2.0, 10.0}) {
    const double alpha = factor * spacing;
    if (alpha > 0 && std::isfinite(alpha)) alphas.push_back(alpha);
  }
  alphas.push_back(std::numeric_limits<double>::infinity());
  return alphas;
}

}  // namespace rbpa_test
