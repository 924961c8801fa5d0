// What:   RBPA and HRBPA as published: one point after the other, on the advancing-front engine, with grid cells of side 2α of
//         which nine are scanned at each pivot.
// Law:    the triangles of rbpa() and hrbpa(). Short and slow, to read and to compare with.
// Cost:   a pivot grows with α² over the square of the spacing; one thread.
// Source: Medeiros, Velho, Lopes, Restricted BPA, sections 3, 4 and 6; docs/paper.md.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/hrbpa.h"
#include "rbpa/rbpa.h"

namespace rbpa::paper {

/// The default of HierarchyOptions::leaf_capacity here. With larger leaves the first grid is coarser.
inline constexpr std::size_t usual_leaf_capacity = 32;

/// As rbpa::rbpa(): requires and throws what it does. One thread works, whatever `options` specify.
RBPA_API SolidAlphaComplex rbpa(std::span<const Point> points, double alpha, const Options& options = {});

/// As rbpa::hrbpa(), with the levels of the paper, on which every point carried on takes part. One thread works.
RBPA_API Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options = {});

}  // namespace rbpa::paper
