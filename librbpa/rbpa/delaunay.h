// What: a Delaunay triangulation and its points, known to belong together: it is computed from them here, or checked once.
// Why:  whatever follows from it (filtration.h, persistence.h, plateaus.h, covering.h, filtration_arrays.h) takes it as it is,
//       so that a run pays for one check at most, and for none of what it triangulated itself.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/triangulate.h"

namespace rbpa {

/// Keeps the span of points. Copies share the triangulation.
class RBPA_API Delaunay {
 public:
  /// Triangulates the points. Of the options, `complex`, `neighbors` and `boundary` are not used.
  /// Throws: as triangulate(points, infinity, options). Cost: that of triangulate().
  explicit Delaunay(std::span<const Point> points, const TriangulationOptions& options = {});

  /// Takes triangulate(points, infinity, {.neighbors = true}), which is checked. What is no temporary is not copied: it must
  /// stay as it is.
  /// Throws: ContractViolation, which begins with `function`, when it is visibly of other points, leaves some out, or has
  ///         triangles that turn right; as require_linked(); Cancelled when `go_on`, which is called every few milliseconds,
  ///         returns false. Empty: never called.
  /// Cost:   linear: about a tenth of what the triangulation cost.
  Delaunay(const Triangulation& triangulation, std::span<const Point> points, const std::function<bool()>& go_on = {},
           const char* function = "Delaunay");
  Delaunay(Triangulation&& triangulation, std::span<const Point> points, const std::function<bool()>& go_on = {},
           const char* function = "Delaunay");

  const Triangulation& triangulation() const { return *triangulation_; }
  std::span<const Point> points() const { return points_; }

 private:
  std::shared_ptr<const Triangulation> triangulation_;
  std::span<const Point> points_;
};

}  // namespace rbpa
