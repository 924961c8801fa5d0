// What: a Delaunay triangulation together with its points, which is computed here, or given and checked once.
// Why:  functions of a triangulation (filtration.h, persistence.h, plateaus.h, smallest_covering_alpha.h) do not check
//       a Delaunay object again. A run checks a given triangulation at most once, and one that it computes itself
//       never.
#pragma once

#include <memory>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/alpha_complex.h"

namespace rbpa {

/// A Delaunay triangulation and a span of its points, which must outlive the object and stay unchanged. Copies share
/// the triangulation.
class RBPA_API Delaunay {
 public:
  /// Triangulates the points. The options `complex`, `neighbors` and `boundary` are ignored.
  /// Throws: as alpha_complex(points, infinity, options).
  /// Cost:   that of alpha_complex().
  explicit Delaunay(std::span<const Point> points, const AlphaComplexOptions& options = {});

  /// Takes and checks the result of alpha_complex(points, infinity, {.neighbors = true}). A triangulation that is given
  /// as an lvalue is not copied: it must outlive this object and stay unchanged.
  /// Throws: ContractViolation, whose message begins with `function`, when the triangulation is visibly of other
  ///         points, omits some, or has clockwise triangles, and as require_linked(); Cancelled.
  /// Cost:   linear: about a tenth of the cost of the triangulation.
  Delaunay(const AlphaComplex& triangulation, std::span<const Point> points, const GoOn& go_on = {},
           const char* function = "Delaunay");
  Delaunay(AlphaComplex&& triangulation, std::span<const Point> points, const GoOn& go_on = {},
           const char* function = "Delaunay");

  const AlphaComplex& triangulation() const { return *triangulation_; }
  std::span<const Point> points() const { return points_; }

 private:
  std::shared_ptr<const AlphaComplex> triangulation_;
  std::span<const Point> points_;
};

}  // namespace rbpa
