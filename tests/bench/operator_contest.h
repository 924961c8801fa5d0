// What: the contestants of bench_operators: each prepares a mesh once, and operates on a fresh copy of it in every
//       pass.
#pragma once

#include <time.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "bench/operator_task.h"

namespace meshops_bench {

/// Result that must be equal for all contestants after a pass. Vertices are numbered alike, so that triangles can be
/// compared.
struct Shape {
  std::size_t vertices = 0, edges = 0, faces = 0;
  std::uint64_t triangles = 0;  ///< sum of hashes, which depend on direction but not on the first corner

  void add_triangle(Corners corners) {
    ++faces;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::uint64_t hash = 0;
    for (const std::uint32_t corner : corners) {
      hash = (hash ^ corner) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 29U;
    }
    triangles += hash;
  }
  friend bool operator==(const Shape&, const Shape&) = default;
};

struct Contestant {
  std::function<double()> pass;  ///< operates on a fresh copy; returns seconds of this thread's processor time
  std::function<Shape()> shape;  ///< returns the shape of the mesh after the last pass
};

/// Return the contestant for a task, which must outlive it. OpenMesh does not sew curves.
Contestant meshops_at(const Task& task);
Contestant openmesh_at(const Task& task);
Contestant cgal_at(const Task& task);

/// Returns the processor time of this thread; other work on the machine that takes turns with it does not count.
inline double seconds_of_thread() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Each type of mesh specializes these. copy_with_room() reserves room for the elements that steps add.
template <typename Mesh>
void copy_with_room(const Mesh& from, Mesh& to);
template <typename Mesh>
Shape shape_of(const Mesh& mesh);

/// Returns a contestant that calls step(mesh, handles) for each site, with the result of locate(mesh, site).
template <typename Mesh, typename Locate, typename Step>
Contestant at_sites(const Mesh& start, const Task& task, Locate locate, Step step) {
  using Handles = decltype(locate(start, task.sites.front()));
  std::vector<Handles> sites;
  for (const Site& site : task.sites) sites.push_back(locate(start, site));
  const auto mesh = std::make_shared<Mesh>();
  return {[=] {
            copy_with_room(start, *mesh);
            const double begin = seconds_of_thread();
            for (const Handles& site : sites) step(*mesh, site);
            return seconds_of_thread() - begin;
          },
          [=] { return shape_of(*mesh); }};
}

/// Returns a contestant that operates on the whole mesh at once: prepare(mesh) is not timed, run(mesh, its result) is.
template <typename Mesh, typename Prepare, typename Run>
Contestant at_once(Prepare prepare, Run run) {
  const auto mesh = std::make_shared<Mesh>();
  return {[=] {
            *mesh = Mesh();
            auto prepared = prepare(*mesh);
            const double begin = seconds_of_thread();
            run(*mesh, prepared);
            return seconds_of_thread() - begin;
          },
          [=] { return shape_of(*mesh); }};
}

}  // namespace meshops_bench
