// What:   RBPA and HRBPA as published: point by point, on the advancing-front engine; each pivot scans nine grid cells
//         of side 2α.
// Law:    the triangles equal those of rbpa::rbpa() and rbpa::hrbpa(). The code is short and slow, made for comparison.
// Cost:   a pivot takes time linear in the number of points in nine cells, which grows with the square of α over the
//         spacing of the points. One thread.
// Source: Medeiros, Velho, Lopes, Restricted BPA, sections 3, 4 and 6; docs/explanation/paper.md.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/levels.h"
#include "rbpa/rbpa.h"

namespace rbpa::paper {

/// The default of HierarchyOptions::leaf_capacity in this namespace: the maximum number of points in a leaf. Larger
/// leaves give a larger α₀, and so a coarser first grid.
inline constexpr std::size_t usual_leaf_capacity = 32;

/// Computes the complex that rbpa::rbpa() computes, with its requirements and exceptions. `options.threads` is ignored.
RBPA_API SolidAlphaComplex rbpa(std::span<const Point> points, double alpha, const Options& options = {});

/// Computes the complex of rbpa::hrbpa() and, if both get the same leaf capacity, its radii, with its requirements and
/// exceptions. Every transferred point takes part in a level, as in the paper. `options.threads` is ignored.
RBPA_API Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options = {});

}  // namespace rbpa::paper
