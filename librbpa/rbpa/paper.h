// What:   RBPA and HRBPA as published: point by point, on the advancing-front engine, with grid cells of side 2α, of
//         which nine are scanned at each pivot.
// Law:    the triangles equal those of rbpa::rbpa() and rbpa::hrbpa(). The code is short and slow, made for comparison.
// Cost:   a pivot takes time linear in the points in nine cells: α² over the square of their spacing. One thread.
// Source: Medeiros, Velho, Lopes, Restricted BPA, sections 3, 4 and 6; docs/explanation/paper.md.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/levels.h"
#include "rbpa/rbpa.h"

namespace rbpa::paper {

/// The default of HierarchyOptions::leaf_capacity in this namespace: points in a leaf. Larger leaves give a larger α₀,
/// and so a coarser first grid.
inline constexpr std::size_t usual_leaf_capacity = 32;

/// Computes the complex of rbpa::rbpa(), with the same requirements and exceptions. Runs in one thread:
/// `options.threads` is ignored.
RBPA_API SolidAlphaComplex rbpa(std::span<const Point> points, double alpha, const Options& options = {});

/// Computes the complex and, with the same leaf capacity, the radii of rbpa::hrbpa(), with the same requirements and
/// exceptions. Every transferred point takes part in a level, as in the paper. `options.threads` is ignored.
RBPA_API Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options = {});

}  // namespace rbpa::paper
