// What: generates point sets that reach every kind of decision: scattered, gridded, cocircular, collinear, sparse,
//       extreme.
// Law:  a set is a function of its arguments alone, down to the last bit: no transcendental function is called, because
//       last bits of these differ between libraries.
#pragma once

#include <cstddef>
#include <cstdint>

#include "support/triangle.h"

namespace rbpa_test {

// Scattered (generate_scattered.cpp) ---------------------------------------------------------------------------------

/// Uniform points in [0, side)², side = √count: mean spacing 1.
Points uniform(std::size_t count, std::uint64_t seed);

/// One point in every cell of a columns × columns grid of pitch 1, anywhere in the middle `jitter` of it.
Points jittered_grid(int columns, double jitter, std::uint64_t seed);

/// (i · pitch, j · pitch): exactly cocircular squares where pitch is a power of two, nearly where it is not.
Points perfect_grid(int columns, double pitch);

/// perfect_grid() of pitch 1, of which a share of about `kept` points is kept.
Points sparse_grid(int columns, double kept, std::uint64_t seed);

/// The integer lattice turned by the angle of the 3-4-5 triangle, still on integers: (3i − 4j, 4i + 3j).
Points rotated_integer_grid(int columns);

/// The grid turned by 0.3 rad and rounded: cocircular but for the last bit.
Points rotated_rounded_grid(int columns);

/// Rows shifted by half a pitch, √3/2 apart (rounded): equilateral triangles, nearly cocircular hexagons.
Points triangular_lattice(int columns);

/// `count` of the points of a columns × columns integer grid, with repetitions when `repeat`.
Points random_grid(int columns, std::size_t count, bool repeat, std::uint64_t seed);

/// Clusters of radius 1, 10⁻¹, … 10⁻⁹ of the distance between them, `each` points in each.
Points clusters(std::size_t each, std::uint64_t seed);

/// Every point up to `most` times, signs of zeros mixed.
Points duplicates(std::size_t distinct, int most, std::uint64_t seed);

/// Pairs whose coordinates differ in the last bit.
Points nearest_doubles(std::size_t pairs, std::uint64_t seed);

/// Scan lines as from a plane: dense along x, quantised to 0.01, at map coordinates of 6e5 and 5e6.
Points lidar_lines(int lines, int per_line, std::uint64_t seed);

/// Along a parabola, a cubic and a rational circle, dense: at a hundred spacings alpha still sees the curve only.
Points along_curves(int per_curve);

// Cocircular (generate_cocircular.cpp) --------------------------------------------------------------------------------

/// Every integer point at distance `radius` of the origin, counter-clockwise. 5·13·17 = 1105 has 108, 32045 has 324.
Points integer_circle(int radius);

/// Integer circles of radius and 2 · radius around one center, with the center on request.
Points integer_concentric(int radius, bool center);

/// Two circles of `each` points, rounded: cocircular but for the last bits.
Points rounded_concentric(int each);

/// Rectangles of 6 × 8 side by side: right triangles of circumradius exactly 5 and longest side exactly 10.
Points rectangles_of_circumradius_5(int columns);

/// Triangles with sides 15k, 20k, 25k, turned by Pythagorean angles, far apart, `each` of every scale k = 1, 2, 4 …
/// (`scales` scales): circumradius exactly 12.5 k.
Points triangles_3_4_5(int each, int scales);

// Collinear (generate_collinear.cpp) ----------------------------------------------------------------------------------

/// `count` points from (0, 0) in steps of (dx, dy) with gaps, shuffled.
Points collinear_run(int count, double dx, double dy, std::uint64_t seed);

/// The run together with `off` points that are not on its line.
Points collinear_run_with_points_off(int count, double dx, double dy, int off, std::uint64_t seed);

/// Several runs that cross.
Points crossing_runs(int each);

// Sparse (generate_sparse.cpp): sets that a front alone cannot reach --------------------------------------------------

/// `components` pairs, triples and quads of points less than 1 apart, 100 from each other.
Points tiny_components(int components, std::uint64_t seed);

/// `length` triangles in a row, each touching the next in a point; at alpha 3 no triangle lies between them.
Points chain_of_triangles(int length);

/// Chain of triangles closed to a ring around a hole; at alpha `ring_of_pinches_alpha` no triangle lies between them.
Points ring_of_pinches(int length);
inline constexpr double ring_of_pinches_alpha = 3;

/// Pairs at distance exactly 2, some with a point that sees them at a right angle, some with one a little nearer or
/// farther: alpha = 1 is the tie.
Points pairs_at_distance_2(int pairs, std::uint64_t seed);

/// The center and the integer points of a circle: every triangle at the center has circumradius a little above
/// radius / 2, so alpha = 0.5001 · radius keeps narrow triangles and leaves long edges dangling between them.
Points star(int radius);

// Traps (generate_traps.cpp): few neighbors, and large circles that are empty or full of points -----------------------

/// Points of the unit circle, rounded: cocircular but for the last bit.
Points rounded_circle(std::size_t count);

/// Circles of radius 1, 2, 3 … around one center, `each` points in each.
Points many_rounded_circles(std::size_t circles, std::size_t each);

/// A curve with a loop on either side, about 10 long.
Points along_a_curve(std::size_t count);

/// The unit circle, a line above it and a cluster of width 10⁻¹² within, `each` points of each.
Points circle_line_and_cluster(std::size_t each, std::uint64_t seed);

// Extreme (generate_extreme.cpp) --------------------------------------------------------------------------------------

/// `points` times a power of two: exact unless it leaves the range of double.
Points scaled(Points points, int exponent);

/// `points` moved by (dx, dy): rounded.
Points moved(Points points, double dx, double dy);

/// One set at 1e300, one at 1 and one at 1e-300 around the same origin.
Points mixed_exponents(std::size_t each, std::uint64_t seed);

/// Integers times the smallest positive double.
Points denormals(int columns, std::size_t count, std::uint64_t seed);

/// Corners of the range of double, with points between.
Points corners_of_range();

/// Clusters of width 1e-300 at points 1e300 apart.
Points far_and_tiny(std::size_t each, std::uint64_t seed);

/// Uniform points, and `strangers` that no power of two makes fit together with them: far away on all sides, or among
/// them but finer than anything there; some of them twice.
Points with_strangers(std::size_t count, std::size_t strangers, std::uint64_t seed);

}  // namespace rbpa_test
