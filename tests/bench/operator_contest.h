// What: a contestant of bench_operators: it prepares a mesh once, and operates on a fresh copy of it in every pass.
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

/// What all contestants must agree on after a pass. Vertices are numbered alike, so that triangles can be compared.
struct Shape {
  std::size_t vertices = 0, edges = 0, faces = 0;
  std::uint64_t triangles = 0;  ///< the sum of a hash of each, of its direction but not of its beginning

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
  /// Operates at all sites of a fresh copy. Returns the seconds that it took the processor.
  virtual double pass() = 0;
  /// Of the mesh that the last pass left.
  virtual Shape shape() const = 0;
};

/// Processor time of this thread: other work on the machine that takes turns with it does not count.
inline double seconds_of_thread() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// step(mesh, site) at every site, one after the other. `copy(from, to)` makes room for what the steps add.
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

/// Those who can do the operation; none may be.
std::vector<Entry> meshops_entries(Operation operation);
std::vector<Entry> openmesh_entries(Operation operation);
std::vector<Entry> cgal_entries(Operation operation);

}  // namespace meshops_bench
