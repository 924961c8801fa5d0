// What: triangles as three input indices, and the canonical order of a set of them.
// Law:  two lists of the same oriented triangles are equal in canonical order.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa_test {

using Triangle = std::array<std::uint32_t, 3>;
using Points = std::vector<rbpa::Point>;

/// Returns the triangles sorted, each with its smallest index first (its orientation stays).
std::vector<Triangle> canonical(std::vector<Triangle> triangles);

/// Returns the triangles with every index replaced by `to[index]`, in canonical order again.
std::vector<Triangle> renumbered(std::vector<Triangle> triangles, std::span<const std::uint32_t> to);

/// Returns for every point the lowest index of a point equal to it.
std::vector<std::uint32_t> lowest_equal(std::span<const rbpa::Point> points);

/// Looks every corner up among the points by its coordinates: of equal points, the lowest index. Triangles of a
/// permutation of the points become triangles of the points.
std::vector<Triangle> translated(const std::vector<Triangle>& triangles, std::span<const rbpa::Point> from,
                                 std::span<const rbpa::Point> to);

/// Returns a text for people on how two canonical lists differ, "" when they do not.
std::string difference(const std::vector<Triangle>& expected, const std::vector<Triangle>& actual);

}  // namespace rbpa_test
