#include "rbpa/space/balls/periodic_balls.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/space/balls/periodic/periodic_images.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa {

double RepeatingCell::volume() const {
  using Vector = space::Vector3<double>;
  const auto& [a, b, c] = edges;
  return std::abs(space::dot(space::cross(Vector{a.x, a.y, a.z}, {b.x, b.y, b.z}), Vector{c.x, c.y, c.z}));
}

PeriodicBallMeasures measure_periodic_balls(std::span<const Point3> centers, std::span<const double> radii,
                                            const RepeatingCell& cell, const MeasureBallsOptions& options) {
  space::check_centers(centers, radii);
  using Offset = space::PeriodicImages::Offset;
  const space::PeriodicImages all(centers, radii, cell, options.probe);
  PeriodicBallMeasures result;
  static_cast<BallMeasures&>(result) = measure_balls(all.centers, all.radii, options);
  const auto own = static_cast<std::uint32_t>(centers.size());
  ExactSum volume, area;
  for (std::size_t i = 0; i < own; ++i) {
    volume.add(result.volumes[i]);
    area.add(result.areas[i]);
  }
  result.volume = volume.rounded();
  result.area = area.rounded();
  for (auto* values : {&result.volumes, &result.areas}) values->resize(own);
  result.arcs.resize(own);
  std::erase_if(result.hidden, [&](std::uint32_t i) { return i >= own; });
  if (options.derivatives)
    for (auto* values : {&result.volume_gradient, &result.area_gradient}) values->resize(own);
  std::vector<std::pair<BallContact, Offset>> contacts;
  for (BallContact contact : std::exchange(result.contacts, {})) {
    auto& [a, b] = contact.balls;
    if (a >= own) continue;  // between images
    Offset offset{};
    for (std::size_t k = 0; k < 3; ++k) offset[k] = all.offsets[b][k] - all.offsets[a][k];
    const bool is_own = b < own;
    b = all.of[b];
    if (is_own || a < b || (a == b && offset > Offset{})) contacts.emplace_back(contact, offset);
  }
  std::sort(contacts.begin(), contacts.end(), [](const auto& c, const auto& d) {
    return std::pair(c.first.balls, c.second) < std::pair(d.first.balls, d.second);
  });
  for (const auto& [contact, offset] : contacts) {
    result.contacts.push_back(contact);
    result.contact_offsets.push_back(offset);
  }
  return result;
}

}  // namespace rbpa
