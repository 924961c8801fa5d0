// What:   the solid alpha complex from the bottom up: restricted ball pivoting with radii α₀, 2α₀, 4α₀ … up to alpha.
// Law:    the triangles equal those of rbpa(); after each level the mesh is exactly the complex of the level's radius.
// Cost:   about that of rbpa(), more with a callback after each level: docs/explanation/plane.md, sections 16 and 17.
// Source: Medeiros, Velho, Lopes, Restricted BPA, section 6.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/levels.h"

namespace rbpa {

/// Computes the solid alpha complex of `points` by hierarchical restricted ball pivoting.
/// Requires: 0 < alpha ≤ infinity; the points are finite, at most 357,913,941 (OpenMesh numbers halfedges in int).
/// Throws:   before anything is computed, InvalidInput that names a wrong alpha, a too large number of points or the
///           first point that is not finite, and ContractViolation when the leaf capacity is 0. Cancelled; any
///           exception of the callbacks in `options`.
RBPA_API Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options = {});

/// Returns the level that added face number `face` of the mesh, as a position in `hierarchy.levels`.
/// Requires: `face` is below the number of faces; not checked.
/// Cost:     logarithmic in the number of levels.
RBPA_API std::size_t level_of(const Hierarchy& hierarchy, std::size_t face);

}  // namespace rbpa
