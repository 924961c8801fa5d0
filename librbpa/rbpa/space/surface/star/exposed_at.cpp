#include "rbpa/space/surface/star/exposed_at.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "rbpa/base/parallel/in_order.h"
#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/cells/cells.h"
#include "rbpa/space/cells/scaled_points.h"
#include "rbpa/space/surface/star/find_rings.h"

namespace rbpa::space {
namespace {

constexpr Site at_a_time = 64;

/// Returns the wanted sites as half-open ranges of at most at_a_time sites each.
std::vector<std::pair<Site, Site>> wanted_runs(const Cells& cells, const std::vector<std::uint8_t>& wanted) {
  std::vector<std::pair<Site, Site>> runs;
  for (Site v = 0; v < cells.sites().size(); ++v) {
    if (wanted[cells.input_index()[v]] == 0) continue;
    if (runs.empty() || runs.back().second != v || v - runs.back().first == at_a_time) runs.emplace_back(v, v);
    runs.back().second = v + 1;
  }
  return runs;
}

}  // namespace

std::vector<ExposedAt> exposed_at(std::span<const Point3> points, double radius,
                                  const std::vector<std::uint8_t>& wanted, const SurfaceOptions& options) {
  Threads threads(points.size() < 1000 ? 1 : options.threads);
  const ScaledPoints scaled(points, radius);
  const Cells cells(scaled.points(), scaled.radius(), threads);
  const std::span<const std::uint32_t> index = cells.input_index();
  const std::vector<std::pair<Site, Site>> runs = wanted_runs(cells, wanted);
  std::vector<ExposedAt> found;
  const GoOn go_on = go_on_of(options.progress, points.size());
  CheckpointOfThreads checkpoint(go_on);
  const GoOn go_on_here = [&] {
    checkpoint();
    return true;
  };
  in_order<Rings>(
      threads, runs.size(),
      [&](std::size_t run, Rings& rings) {
        Steps step(go_on_here);
        find_rings(cells, scaled.fits_double(), runs[run].first, runs[run].second, rings, step);
      },
      [&](std::size_t run, Rings& rings) {
        for (Site v = runs[run].first; v < runs[run].second; ++v) {
          const std::size_t place = v - runs[run].first;
          const auto end = rings.points.begin() + rings.first[place + 1];
          for (auto first = rings.points.begin() + rings.first[place]; first != end;) {
            const auto last = std::find(first, end, Rings::end_of_cycle);
            // … w, x, z …: the ball rolls about x from (v, x, w) to (v, z, x), and back.
            for (auto z = first, x = last - 1, w = last - 2; z != last; w = x, x = z++)
              found.push_back({index[v], index[*z], index[*x], index[*w]});
            first = last + 1;
          }
        }
      },
      [](std::size_t, Rings&) {});
  Steps step(go_on);
  sort(found, step, std::less<>());
  return found;
}

}  // namespace rbpa::space
