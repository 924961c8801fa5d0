#include "rbpa/space/balls/ball_interfaces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/measure_ball_frames.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/bounding_box.h"

namespace rbpa {
namespace {

/// The balls of one group or of two groups: indices, ascending, with their centers and radii.
struct GroupBalls {
  std::vector<std::uint32_t> balls;
  std::vector<Point3> centers;
  std::vector<double> radii;

  GroupBalls(std::vector<std::uint32_t> indices, std::span<const Point3> all, std::span<const double> all_radii)
      : balls(std::move(indices)) {
    for (const std::uint32_t i : balls) {
      centers.push_back(all[i]);
      radii.push_back(all_radii[i]);
    }
  }
  BallFrame frame() const { return {.centers = centers, .radii = radii}; }
};

/// Returns the box around balls whose radii include the probe, rounded outward.
space::Box box_around(const GroupBalls& part, double probe) {
  constexpr double infinity = space::Box::infinity;
  space::Box box;
  for (std::size_t i = 0; i < part.balls.size(); ++i) {
    const double radius = part.radii[i] + probe;
    const auto low = [&](double at) { return std::nextafter(at - radius, -infinity); };
    const auto high = [&](double at) { return std::nextafter(at + radius, infinity); };
    const Point3& p = part.centers[i];
    box.include(space::Box{{low(p.x), low(p.y), low(p.z)}, {high(p.x), high(p.y), high(p.z)}});
  }
  return box;
}

std::vector<PeriodicBallMeasures> measured(const std::vector<GroupBalls>& parts, MeasureBallsOptions options,
                                           bool contacts) {
  std::vector<BallFrame> frames;
  for (const GroupBalls& part : parts) frames.push_back(part.frame());
  options.contacts = contacts;
  options.derivatives = false;
  return measure_ball_frames(frames, options);
}

}  // namespace

BallInterfaces ball_interfaces(std::span<const Point3> centers, std::span<const double> radii,
                               std::span<const std::uint32_t> groups, const MeasureBallsOptions& options) {
  space::check_centers(centers, radii);
  if (groups.size() != centers.size())
    throw InvalidInput(std::to_string(groups.size()) + " groups, expected one for each of " +
                       std::to_string(centers.size()) + " centers");
  std::vector<std::uint32_t> numbers(groups.begin(), groups.end());
  sort_unique(numbers);
  if (!numbers.empty() && numbers.back() == no_group) numbers.pop_back();
  std::vector<std::vector<std::uint32_t>> members(numbers.size());
  for (std::uint32_t i = 0; i < groups.size(); ++i)
    if (groups[i] != no_group)
      members[static_cast<std::size_t>(std::lower_bound(numbers.begin(), numbers.end(), groups[i]) - numbers.begin())]
          .push_back(i);
  std::vector<GroupBalls> parts;
  std::vector<space::Box> boxes;
  for (std::vector<std::uint32_t>& of_group : members) {
    parts.emplace_back(std::move(of_group), centers, radii);
    boxes.push_back(box_around(parts.back(), options.probe));
  }
  const std::vector<PeriodicBallMeasures> alone = measured(parts, options, false);
  BallInterfaces result;
  result.areas_alone.resize(centers.size());
  for (std::size_t g = 0; g < parts.size(); ++g)
    for (std::size_t i = 0; i < parts[g].balls.size(); ++i) result.areas_alone[parts[g].balls[i]] = alone[g].areas[i];

  std::vector<std::array<std::size_t, 2>> pairs;
  std::vector<GroupBalls> unions;
  for (std::size_t a = 0; a < parts.size(); ++a)
    for (std::size_t b = a + 1; b < parts.size(); ++b) {
      if (!boxes[a].meets(boxes[b])) continue;
      pairs.push_back({a, b});
      std::vector<std::uint32_t> both;
      std::merge(parts[a].balls.begin(), parts[a].balls.end(), parts[b].balls.begin(), parts[b].balls.end(),
                 std::back_inserter(both));
      unions.emplace_back(std::move(both), centers, radii);
    }
  const std::vector<PeriodicBallMeasures> together = measured(unions, options, true);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [a, b] = pairs[i];
    const std::vector<std::uint32_t>& balls = unions[i].balls;
    BallInterface found{{numbers[a], numbers[b]}};
    bool do_meet = together[i].hidden.size() != alone[a].hidden.size() + alone[b].hidden.size();
    for (const BallContact& contact : together[i].contacts) {
      if (groups[balls[contact.balls[0]]] == groups[balls[contact.balls[1]]]) continue;
      do_meet = true;
      found.contact_area += contact.area;
    }
    if (!do_meet) continue;
    for (std::size_t k = 0; k < balls.size(); ++k)
      found.areas[groups[balls[k]] == numbers[b]] += result.areas_alone[balls[k]] - together[i].areas[k];
    for (double& area : found.areas) area = std::max(area, 0.0);  // rounding may leave an area just below 0
    result.all.push_back(found);
  }
  return result;
}

}  // namespace rbpa
