#include "support/ball_sets.h"

#include <array>
#include <cmath>
#include <sstream>

#include "support/vectors.h"

namespace rbpa_test {

using rbpa::Point3;

std::string name(RadiusKind kind) {
  static constexpr std::array names = {"equal", "alternating", "integers", "along_x",
                                       "norm",  "near_tie",    "spacing",  "decades"};
  static_assert(names.size() == radius_kinds);
  return names[static_cast<std::size_t>(kind)];
}

Balls ball_set(SpaceKind centers, RadiusKind kind, std::size_t count, Random& random) {
  Balls balls;
  balls.centers = space_set(centers, count, random);
  if (balls.centers.empty()) return balls;
  const auto any = [&] { return balls.centers[random.below(balls.centers.size())]; };
  // The unit of radii: 1 on grids, else a distance.
  double unit = 1;
  if (const Point3 u = any() - any(); std::nearbyint(u.x) != u.x || std::abs(u.x) > 0x1p100) unit = std::abs(u.x);
  const auto radius = [&](const Point3& p) {
    const double norm = std::hypot(p.x, p.y, p.z);
    switch (kind) {
      case RadiusKind::equal:
        return unit;
      case RadiusKind::alternating: {
        const double sum = p.x + p.y + p.z;
        const bool is_odd =
            std::abs(sum) < 1e9 && std::nearbyint(sum) == sum ? std::fmod(sum, 2) != 0 : random.chance(0.5);
        return is_odd ? 2 * unit : unit;
      }
      case RadiusKind::integers:
        return random.integer(0, 4) * unit;
      case RadiusKind::along_x:
        return std::abs(p.x);
      case RadiusKind::norm:
        return norm;
      case RadiusKind::near_tie: {
        const double tie = random.chance(0.5) ? norm : std::abs(p.x);
        return random.chance(0.3) ? std::nextafter(tie, 2 * tie) : tie;
      }
      case RadiusKind::spacing:
        return random.unit() * unit / std::cbrt(static_cast<double>(count));
      case RadiusKind::decades:
        break;
    }
    return unit * std::pow(10.0, random.between(-6, 3));
  };
  if (random.chance(0.3))
    for (int i = 0; i < 4; ++i) balls.centers.push_back(any());
  for (const Point3& p : balls.centers) balls.radii.push_back(radius(p));
  if (random.chance(0.3)) {
    balls.radii[random.below(balls.radii.size())] *= random.chance(0.5) ? 2 : 0;
    balls.radii[random.below(balls.radii.size())] *= 0.5;
  }
  return balls;
}

std::string text(const Balls& balls) {
  std::ostringstream out;
  out << std::hexfloat << "balls";
  for (std::size_t i = 0; i < balls.radii.size(); ++i) {
    const Point3& p = balls.centers[i];
    out << " {{" << p.x << ", " << p.y << ", " << p.z << "}, " << balls.radii[i] << "}";
  }
  return out.str();
}

}  // namespace rbpa_test
