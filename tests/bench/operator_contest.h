// What: the contestants of bench_operators: each prepares a mesh once, and operates on a fresh copy of it in every
//       pass.
#pragma once

#include <time.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
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

class Contestant {
 public:
  Contestant() = default;
  Contestant(const Contestant&) = delete;
  Contestant& operator=(const Contestant&) = delete;
  virtual ~Contestant() = default;
  /// Operates at all sites of a fresh copy. Returns: the seconds of processor time.
  virtual double pass() = 0;
  /// Returns the shape of the mesh after the last pass.
  virtual Shape shape() const = 0;
};

/// Returns the processor time of this thread; other work on the machine that takes turns with it does not count.
inline double seconds_of_thread() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Contestant that calls step(mesh, site) at every site, one after the other. `copy(from, to)` reserves room for the
/// elements that the steps add.
template <typename Mesh, typename Handles, typename Copy, typename Step, typename ShapeOf>
class AtSites : public Contestant {
 public:
  AtSites(Mesh mesh, std::vector<Handles> sites, Copy copy, Step step, ShapeOf shape_of)
      : start_(std::move(mesh)), sites_(std::move(sites)), copy_(copy), step_(step), shape_of_(shape_of) {}

  double pass() override {
    copy_(start_, mesh_);
    const double begin = seconds_of_thread();
    for (const Handles& site : sites_) step_(mesh_, site);
    return seconds_of_thread() - begin;
  }
  Shape shape() const override { return shape_of_(mesh_); }

 private:
  Mesh start_, mesh_;
  std::vector<Handles> sites_;
  Copy copy_;
  Step step_;
  ShapeOf shape_of_;
};

struct Entry {
  std::string_view name;
  std::unique_ptr<Contestant> (*make)(const Task& task);
};

/// Return the contestants that can do the operation, which may be none.
std::vector<Entry> meshops_entries(Operation operation);
std::vector<Entry> openmesh_entries(Operation operation);
std::vector<Entry> cgal_entries(Operation operation);

}  // namespace meshops_bench
