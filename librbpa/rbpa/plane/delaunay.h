// What: holds a Delaunay triangulation with its points; the constructor computes or checks the triangulation.
// Why:  functions of a triangulation (filtration.h, persistence.h, plateaus.h, smallest_covering_alpha.h) do not check
//       a Delaunay object again.
#pragma once

#include <memory>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/temporary.h"
#include "rbpa/plane/alpha_complex.h"

namespace rbpa {

/// A Delaunay triangulation and a span of its points, which must outlive the object and stay unchanged. Copies share
/// the triangulation.
class RBPA_API Delaunay {
 public:
  /// Triangulates the points. Of the options, only `threads` and `progress` are used.
  /// Throws: InvalidInput as alpha_complex(); Cancelled.
  /// Cost:   that of alpha_complex().
  explicit Delaunay(std::span<const Point> points, const AlphaComplexOptions& options = {});

  /// Checks and keeps a reference to the result of alpha_complex(points, infinity, {.neighbors = true}), which must
  /// outlive this object and its copies, and stay unchanged. Whether the triangles are Delaunay is not checked.
  /// Throws: ContractViolation, whose message begins with `function`, when the number of points differs, duplicates do
  ///         not ascend or do not follow the points they repeat, a triangle is not counter-clockwise, or there are
  ///         triangles and isolated points; ContractViolation as require_linked(),
  ///         also if neighbors were not computed; Cancelled.
  /// Cost:   linear: about a tenth of the cost of the triangulation.
  Delaunay(const AlphaComplex& triangulation, std::span<const Point> points, const GoOn& go_on = {},
           const char* function = "Delaunay");
  /// Checks the triangulation as the constructor above does, and moves it into this object.
  Delaunay(AlphaComplex&& triangulation, std::span<const Point> points, const GoOn& go_on = {},
           const char* function = "Delaunay");

  // The span would outlive the points.
  template <TemporaryOwner<std::span<const Point>> Points>  // NOLINTNEXTLINE(*-forwarding-reference-overload): no copy
  explicit Delaunay(Points&&, const AlphaComplexOptions& = {}) = delete;
  template <typename Triangulation, TemporaryOwner<std::span<const Point>> Points>
  Delaunay(Triangulation&&, Points&&, const GoOn& = {}, const char* = "") = delete;

  const AlphaComplex& triangulation() const { return *triangulation_; }
  std::span<const Point> points() const { return points_; }

 private:
  std::shared_ptr<const AlphaComplex> triangulation_;
  std::span<const Point> points_;
};

}  // namespace rbpa
