#include "bench/contest.h"

#include "bench/stopwatch.h"
#include "rbpa/hrbpa.h"
#include "rbpa/paper.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/rbpa.h"

namespace rbpa_bench {
namespace {

Run told_by(const Stopwatch& watch) {
  return {.seconds = watch.seconds(), .triangles = 0, .processor_seconds = watch.processor_seconds()};
}

template <typename Compute>
Run timed(Compute compute, std::span<const rbpa::Point> points, double alpha, unsigned threads, Triangles* list) {
  const Stopwatch watch;
  const rbpa::SolidAlphaComplex complex = compute(points, alpha, rbpa::Options{.threads = threads, .progress = {}});
  Run run = told_by(watch);
  if (list) *list = rbpa::triangles(complex);
  run.triangles = complex.mesh.n_faces();
  return run;
}

template <typename Compute>
Run timed_levels(Compute compute, std::span<const rbpa::Point> points, double alpha,
                 const rbpa::HierarchyOptions& options) {
  const Stopwatch watch;
  const rbpa::Hierarchy hierarchy = compute(points, alpha, options);
  Run run = told_by(watch);
  run.triangles = hierarchy.complex.mesh.n_faces();
  return run;
}

/// Returns the name, followed by the number of threads if there are several.
std::string named(const std::string& name, unsigned threads) {
  if (threads == 1) return name;
  return name + " " + (threads == 0 ? "all" : std::to_string(threads)) + " threads";
}

}  // namespace

Run run_rbpa(std::span<const rbpa::Point> points, double alpha, unsigned threads, Triangles* list) {
  return timed(rbpa::rbpa, points, alpha, threads, list);
}

Run run_arrays(std::span<const rbpa::Point> points, double alpha, unsigned threads, bool neighbors, Triangles* list) {
  rbpa::AlphaComplexOptions options;
  options.threads = threads;
  options.neighbors = neighbors;
  const Stopwatch watch;
  const rbpa::AlphaComplex found = rbpa::alpha_complex(points, alpha, options);
  Run run = told_by(watch);
  if (list) list->assign(found.triangles.begin(), found.triangles.end());
  run.triangles = found.triangles.size();
  return run;
}

Run run_paper_rbpa(std::span<const rbpa::Point> points, double alpha) {
  return timed(rbpa::paper::rbpa, points, alpha, 1, nullptr);
}

Run run_paper_hrbpa(std::span<const rbpa::Point> points, double alpha) {
  return timed_levels(rbpa::paper::hrbpa, points, alpha, {.threads = 1, .progress = {}});
}

Run run_hrbpa_with(std::span<const rbpa::Point> points, double alpha, std::size_t leaf_capacity) {
  return timed_levels(rbpa::hrbpa, points, alpha, {.leaf_capacity = leaf_capacity, .threads = 1, .progress = {}});
}

Run run_hrbpa(std::span<const rbpa::Point> points, double alpha) { return run_hrbpa_with(points, alpha, usual_leaves); }

Contestant rbpa_with(unsigned threads) {
  return {named("rbpa", threads), [threads](std::span<const rbpa::Point> points, double alpha, Triangles* list) {
            return run_rbpa(points, alpha, threads, list);
          }};
}

Contestant arrays_with(unsigned threads) {
  return {named("arrays", threads), [threads](std::span<const rbpa::Point> points, double alpha, Triangles* list) {
            return run_arrays(points, alpha, threads, false, list);
          }};
}
Contestant neighbors_with(unsigned threads) {
  return {named("arrays, neighbors", threads),
          [threads](std::span<const rbpa::Point> points, double alpha, Triangles* list) {
            return run_arrays(points, alpha, threads, true, list);
          }};
}

const Contestant paper_rbpa{"the paper's RBPA", [](std::span<const rbpa::Point> points, double alpha, Triangles*) {
                              return run_paper_rbpa(points, alpha);
                            }};
const Contestant paper_hrbpa{"the paper's HRBPA", [](std::span<const rbpa::Point> points, double alpha, Triangles*) {
                               return run_paper_hrbpa(points, alpha);
                             }};
const Contestant hrbpa{
    "hrbpa", [](std::span<const rbpa::Point> points, double alpha, Triangles*) { return run_hrbpa(points, alpha); }};
const Contestant cgal_indices{"CGAL indices",
                              [](std::span<const rbpa::Point> points, double alpha, Triangles* list) {
                                return run_cgal_indices(points, alpha, Filter::none, list);
                              },
                              /*takes_alpha=*/false};
const Contestant cgal_indices_filtered{"CGAL indices + filter",
                                       [](std::span<const rbpa::Point> points, double alpha, Triangles* list) {
                                         return run_cgal_indices(points, alpha, Filter::circumradius, list);
                                       }};
const Contestant cgal_points{"CGAL points",
                             [](std::span<const rbpa::Point> points, double alpha, Triangles*) {
                               return run_cgal_points(points, alpha, Filter::none);
                             },
                             /*takes_alpha=*/false};
const Contestant cgal_points_filtered{"CGAL points + filter",
                                      [](std::span<const rbpa::Point> points, double alpha, Triangles*) {
                                        return run_cgal_points(points, alpha, Filter::circumradius);
                                      }};
const Contestant cgal_alpha_shape{"CGAL Alpha_shape_2", [](std::span<const rbpa::Point> points, double alpha,
                                                           Triangles*) { return run_cgal_alpha_shape(points, alpha); }};

}  // namespace rbpa_bench
