// What: the visitor of every run: calls the caller's progress function repeatedly, which may cancel the run. The debug
//       build also validates the mesh: after every triangle while the mesh is small, then each time the mesh has grown
//       by a sixteenth.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>

#include "meshops/core/contract.h"
#include "meshops/core/validate.h"
#include "meshops/front/visitor.h"
#include "rbpa/base/progress.h"

namespace rbpa {

#ifdef NDEBUG
inline constexpr bool debug = false;
#else
inline constexpr bool debug = true;
#endif

class Monitor : public meshops::FrontVisitor {
 public:
  /// Keeps a reference to `progress`.
  Monitor(const OnProgress& progress, std::size_t points) : progress_(progress), points_(points) {}

  void seeded(const meshops::Front& front, const meshops::InsertedTriangle&) { count(front); }
  void attached(const meshops::Front& front, meshops::Halfedge, const meshops::InsertedTriangle&) { count(front); }

  /// Reports progress after triangles were added together; `triangles` is their total number since the run began.
  /// Throws: Cancelled.
  void worked(std::size_t triangles) { stop_if_cancelled(progress_, {triangles, points_}); }

  /// Validates, in the debug build, a mesh that was not built triangle by triangle.
  void completed(const meshops::Connectivity& mesh) {
    if (debug) validate(mesh);
  }

  /// Counts a step of a search that finds no triangle. Throws: Cancelled.
  void searched(const meshops::Front& front) { step(front); }

 private:
  void count(const meshops::Front& front) {
    if (debug && front.faces() >= next_validation_) {
      validate(front.mesh());
      next_validation_ = front.faces() <= 256 ? 0 : front.faces() + front.faces() / 16;
    }
    step(front);
  }
  /// Reports progress about once in a millisecond. The number of steps between two reports adapts to their duration: a
  /// triangle takes a microsecond in one run and milliseconds in another.
  void step(const meshops::Front& front) {
    if (++steps_ < stride_ || !progress_) return;
    steps_ = 0;
    const auto now = std::chrono::steady_clock::now();
    const auto passed = now - last_;
    last_ = now;
    stride_ = passed < std::chrono::milliseconds(1) ? std::min(2 * stride_, longest_stride)
                                                    : std::max(stride_ / 4, std::size_t{1});
    stop_if_cancelled(progress_, {front.faces(), points_});
  }
  static void validate(const meshops::Connectivity& mesh) {
    const auto defects = meshops::validate(mesh);
    if (!defects.empty()) throw meshops::ContractViolation("rbpa: " + meshops::describe(defects.front()));
  }

  static constexpr std::size_t longest_stride = 1024;
  const OnProgress& progress_;
  std::size_t points_;
  std::size_t steps_ = 0;
  std::size_t stride_ = 1;
  std::size_t next_validation_ = 0;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace rbpa
