#include "bench/targets.h"

#include <algorithm>
#include <cmath>

namespace rbpa_bench {
namespace {

/// Returns whether the number is about the requested one: grids have a whole number of rows.
bool is_about(std::size_t found, std::size_t asked) {
  const auto f = static_cast<double>(found), a = static_cast<double>(asked);
  return std::abs(f - a) < 0.05 * a;
}

const Contest* find(const std::vector<Contest>& contests, const Workload& workload, std::size_t points) {
  const auto found = std::find_if(contests.begin(), contests.end(), [&](const Contest& contest) {
    return contest.set == workload.name && is_about(contest.points, points);
  });
  return found == contests.end() ? nullptr : &*found;
}

std::optional<double> speedup_of(const Contest* contest, const std::string& ours, const Contestant& peer) {
  return contest ? speedup(*contest, ours, peer.name) : std::nullopt;
}

std::optional<double> time_of(const Contest* contest, const std::string& ours) {
  const Outcome* outcome = contest ? contest->of(ours) : nullptr;
  if (!outcome || !outcome->is_good()) return std::nullopt;
  return contest->nanoseconds_a_point(*outcome);
}

std::optional<double> ratio(std::optional<double> a, std::optional<double> b) {
  return a && b ? std::optional(*a / *b) : std::nullopt;
}

/// Returns the worst time per triangle divided by the best.
std::optional<double> worst_to_best(const std::vector<Contest>& sweep, const std::string& ours) {
  std::vector<double> each;
  for (const Contest& contest : sweep) {
    const std::optional<double> time = time_of(&contest, ours);
    if (!time || contest.outcomes[0].triangles == 0) return std::nullopt;
    each.push_back(*time * static_cast<double>(contest.points) / static_cast<double>(contest.outcomes[0].triangles));
  }
  if (each.size() < 2) return std::nullopt;
  const auto [least, most] = std::minmax_element(each.begin(), each.end());
  return *most / *least;
}

}  // namespace

std::vector<Target> targets(const Measured& measured, std::size_t points) {
  std::vector<Target> all;
  const std::string one = rbpa_with(1).name, two = rbpa_with(2).name;
  const auto faster = [&](const std::string& what, const Contest* contest, const Contestant& peer, double with_one,
                          double with_two) {
    const std::string times = what + ": " + peer.name + " / ";
    all.push_back({times + one, Sense::at_least, with_one, speedup_of(contest, one, peer)});
    all.push_back({times + two, Sense::at_least, with_two, speedup_of(contest, two, peer)});
  };
  const auto of_points = [](const std::string& name, std::size_t number) {
    return name + " " + std::to_string(number);
  };
  const auto delaunay = [&](const Workload& workload, std::size_t number) {
    return of_points(workload.name, number) + ", α = ∞";
  };
  for (const Workload& workload : {uniform, jittered, clusters, kuzmin})
    faster(delaunay(workload, points), find(measured.delaunay, workload, points), cgal_points, 2, 3.5);
  for (const Workload& workload : {lidar, grid})
    faster(delaunay(workload, points), find(measured.delaunay, workload, points), cgal_points, 2.2, 3.8);
  faster(of_points(uniform.name, points) + ", α = 3 spacings", find(measured.alpha, uniform, points),
         cgal_points_filtered, 2.2, 4);
  faster(delaunay(uniform, points / 10), find(measured.delaunay, uniform, points / 10), cgal_points, 2, 3.4);
  for (const Contest& contest : measured.traps)
    all.push_back({of_points(contest.set, contest.points) + ", α = " + contest.alpha_text + ": " +
                       cgal_points_filtered.name + " / " + one,
                   Sense::at_least, 1, speedup(contest, one, cgal_points_filtered.name)});

  all.push_back({of_points("uniform, α = ∞, a point: at", 16 * points) + " / at " + std::to_string(points / 10),
                 Sense::at_most, 1.35,
                 ratio(time_of(find(measured.delaunay, uniform, 16 * points), one),
                       time_of(find(measured.delaunay, uniform, points / 10), one))});
  all.push_back({of_points(uniform.name, points) + ", α from 0.5 to 1000 spacings, a triangle: worst / best",
                 Sense::at_most, 1.5, worst_to_best(measured.sweep, one)});
  all.push_back({of_points("even sets", points) + ", α = ∞, a point: grid / jittered", Sense::at_most, 1.3,
                 ratio(time_of(find(measured.delaunay, grid, points), one),
                       time_of(find(measured.delaunay, jittered, points), one))});
  return all;
}

}  // namespace rbpa_bench
