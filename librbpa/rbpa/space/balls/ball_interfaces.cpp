#include "rbpa/space/balls/ball_interfaces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/periodic/periodic_images.h"
#include "rbpa/space/cells/box_tree.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/bounding_box.h"

namespace rbpa {
namespace {

/// The balls of one group or of two groups: indices, ascending, with their centers and radii.
struct GroupBalls {
  std::vector<std::uint32_t> balls;
  std::vector<Point3> centers;
  std::vector<double> radii;
  std::optional<RepeatingCell> cell;

  GroupBalls(std::vector<std::uint32_t> indices, const BallFrame& all) : balls(std::move(indices)), cell(all.cell) {
    for (const std::uint32_t i : balls) {
      centers.push_back(all.centers[i]);
      radii.push_back(all.radii[i]);
    }
  }
  BallFrame frame() const { return {.centers = centers, .radii = radii, .cell = cell}; }
};

/// Returns the box around a ball, rounded outward.
space::Box box_around(const Point3& p, double radius) {
  const auto low = [&](double at) { return std::nextafter(at - radius, -space::Box::infinity); };
  const auto high = [&](double at) { return std::nextafter(at + radius, space::Box::infinity); };
  return {{low(p.x), low(p.y), low(p.z)}, {high(p.x), high(p.y), high(p.z)}};
}

/// Returns the pairs of parts, ascending, in which a box around a ball of one meets a box around a ball of the other,
/// or of an image of it. `part_of` has the part of each ball, or no_group.
std::vector<std::array<std::uint32_t, 2>> near_pairs(const BallFrame& balls, const std::vector<GroupBalls>& parts,
                                                     const std::vector<std::uint32_t>& part_of,
                                                     const MeasureBallsOptions& options) {
  const RepeatingCell alone = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {false, false, false}};
  const space::PeriodicImages images(balls.centers, balls.radii, balls.cell.value_or(alone), options.probe);
  std::vector<space::Box> boxes;
  for (std::size_t i = 0; i < images.of.size(); ++i)
    boxes.push_back(box_around(images.centers[i], images.radii[i] + options.probe));
  const GoOn go_on = go_on_of(options.progress, parts.size());
  meshops::Steps step(go_on);
  const space::BoxTree tree(boxes, step);
  std::vector<std::array<std::uint32_t, 2>> pairs;
  std::vector<std::uint32_t> last(parts.size(), no_group);  // the last part that is near
  for (std::uint32_t a = 0; a < parts.size(); ++a)
    for (const std::uint32_t i : parts[a].balls)
      tree.for_each_meeting(boxes[i], [&](std::uint32_t image) {
        step();
        const std::uint32_t b = part_of[images.of[image]];
        if (b != no_group && a < b && std::exchange(last[b], a) != a) pairs.push_back({a, b});
      });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
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

BallInterfaces ball_interfaces(const BallFrame& balls, std::span<const std::uint32_t> groups,
                               const MeasureBallsOptions& options) {
  space::check_centers(balls.centers, balls.radii);
  if (groups.size() != balls.centers.size())
    throw InvalidInput(std::to_string(groups.size()) + " groups, expected one for each of " +
                       std::to_string(balls.centers.size()) + " centers");
  std::vector<std::uint32_t> numbers(groups.begin(), groups.end());
  sort_unique(numbers);
  if (!numbers.empty() && numbers.back() == no_group) numbers.pop_back();
  std::vector<std::vector<std::uint32_t>> members(numbers.size());
  std::vector<std::uint32_t> part_of(groups.size(), no_group);
  for (std::uint32_t i = 0; i < groups.size(); ++i) {
    if (groups[i] == no_group) continue;
    const auto at = std::lower_bound(numbers.begin(), numbers.end(), groups[i]);
    part_of[i] = static_cast<std::uint32_t>(at - numbers.begin());
    members[part_of[i]].push_back(i);
  }
  std::vector<GroupBalls> parts;
  for (std::vector<std::uint32_t>& of_group : members) parts.emplace_back(std::move(of_group), balls);
  const std::vector<PeriodicBallMeasures> alone = measured(parts, options, false);
  BallInterfaces result;
  result.areas_alone.resize(groups.size());
  for (std::size_t g = 0; g < parts.size(); ++g)
    for (std::size_t i = 0; i < parts[g].balls.size(); ++i) result.areas_alone[parts[g].balls[i]] = alone[g].areas[i];

  const std::vector<std::array<std::uint32_t, 2>> pairs = near_pairs(balls, parts, part_of, options);
  std::vector<GroupBalls> unions;
  for (const auto& [a, b] : pairs) {
    std::vector<std::uint32_t> both;
    std::merge(parts[a].balls.begin(), parts[a].balls.end(), parts[b].balls.begin(), parts[b].balls.end(),
               std::back_inserter(both));
    unions.emplace_back(std::move(both), balls);
  }
  const std::vector<PeriodicBallMeasures> together = measured(unions, options, true);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [a, b] = pairs[i];
    const std::vector<std::uint32_t>& both = unions[i].balls;
    BallInterface found{{numbers[a], numbers[b]}};
    bool do_meet = together[i].hidden.size() != alone[a].hidden.size() + alone[b].hidden.size();
    for (const BallContact& contact : together[i].contacts) {
      if (groups[both[contact.balls[0]]] == groups[both[contact.balls[1]]]) continue;
      do_meet = true;
      found.contact_area += contact.area;
    }
    if (!do_meet) continue;
    for (std::size_t k = 0; k < both.size(); ++k)
      found.areas[groups[both[k]] == numbers[b]] += result.areas_alone[both[k]] - together[i].areas[k];
    for (double& area : found.areas) area = std::max(area, 0.0);  // rounding may leave an area just below 0
    result.all.push_back(found);
  }
  return result;
}

}  // namespace rbpa
