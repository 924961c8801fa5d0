// What:   RBPA and HRBPA as published: point by point, on the advancing-front engine, with grid cells of side 2α, of
//         which nine are scanned at each pivot.
// Law:    the triangles are those of rbpa() and hrbpa(). The code is short and slow, made to be read and compared with.
// Cost:   a pivot grows with α² over the square of the spacing; one thread.
// Source: Medeiros, Velho, Lopes, Restricted BPA, sections 3, 4 and 6; docs/explanation/paper.md.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/levels.h"
#include "rbpa/rbpa.h"

namespace rbpa::paper {

/// The default of HierarchyOptions::leaf_capacity in this namespace. Larger leaves make the first grid coarser.
inline constexpr std::size_t usual_leaf_capacity = 32;

/// Computes the result of rbpa::rbpa(), with the same requirements and exceptions. One thread works, whatever `options`
/// specify.
RBPA_API SolidAlphaComplex rbpa(std::span<const Point> points, double alpha, const Options& options = {});

/// Computes the result of rbpa::hrbpa(), with the levels of the paper, on which every transferred point takes part. One
/// thread works.
RBPA_API Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options = {});

}  // namespace rbpa::paper
