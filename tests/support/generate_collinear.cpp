#include "support/generate.h"
#include "support/random.h"

namespace rbpa_test {

Points collinear_run(int count, double dx, double dy, std::uint64_t seed) {
  Random random(seed);
  Points points;
  int step = 0;
  for (int i = 0; i < count; ++i) {
    points.push_back({step * dx, step * dy});
    step += random.integer(1, 4);
  }
  random.shuffle(points);
  return points;
}

Points collinear_run_with_points_off(int count, double dx, double dy, int off, std::uint64_t seed) {
  Random random(seed);
  Points points = collinear_run(count, dx, dy, seed);
  for (int i = 0; i < off; ++i) {
    const rbpa::Point& p = points[random.below(static_cast<std::uint64_t>(count))];
    const int away = random.integer(1, 5) * (random.chance(0.5) ? 1 : -1);
    points.push_back({p.x - away * dy, p.y + away * dx});
  }
  return points;
}

Points crossing_runs(int each) {
  Points points;
  for (int i = -each; i <= each; ++i) {
    const double t = i;
    points.push_back({2 * t, 0});
    points.push_back({0, 3 * t});
    points.push_back({t, t});
    points.push_back({2 * t, -t});
  }
  return points;  // the origin four times
}

}  // namespace rbpa_test
