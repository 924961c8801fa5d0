// What: derives the distances from a tie beyond which the sign of a rounded number is certain
//       (docs/explanation/surfaces.md, section 15). A sign nearer to a tie is decided by exact arithmetic. If that is
//       not possible, the free region of the site is given up, and the ball rolls about every edge at the site.
#pragma once

namespace rbpa::space::limits {

inline constexpr double unit_roundoff = 0x1p-53, float_roundoff = 0x1p-24;

/// Greatest error of a corner's center, in radii. The bound is (192κ² + 32/η² + 32)ε for a triangle with sides |u|, |v|
/// and normal n, where κ = |u||v|/|n| and η is the height of the center above the triangle, in radii. A smaller limit
/// would lose regions at triangles that are only thin; a greater one would be too near to `slack`.
inline constexpr double error = 1e-7;

/// Least η² of a triangle whose ball is used, and the least fraction by which a triangle without a ball must be too
/// large. It must exceed the relative error of D = 4r²n² − u²v²w² at triangles as thin as `error` allows, which is 16κε
/// + 32ε with 192κ²ε < error, hence κ < 2200. For triangles of any shape it must exceed the error of D relative to
/// r²u²v², which is below 480ε.
inline constexpr double flatness = 1e-10;
static_assert(192 * 2200.0 * 2200.0 * unit_roundoff > error);
static_assert(flatness > 4 * (16 * 2200 + 32) * unit_roundoff && flatness > 4 * 480 * unit_roundoff);

/// Least sine of an angle between the directions to two corners that counts as above 0. If a corner is off by `error`
/// radii, such a direction turns by about as much, and by three times as much if two corners and a middle are compared.
inline constexpr double slack = 1e-6;
static_assert(slack >= 10 * error);

/// Error, in radii, of a corner that is not a triangle. The corner is chosen, so it is only rounded. The error matters
/// only for the decision whether a cap covers the corner; a larger value makes this decision uncertain more often.
inline constexpr double placed = 1e-10;
static_assert(placed > 1000 * unit_roundoff && placed < error);

/// Bound of the error of the greatest and the least c · p − p²/2 for centers c on the circle of q, as a fraction of
/// the radius times Σ|pᵢ|. Half of their difference is √(p² − (p · q)²/q²) √(r² − q²/4). The differences under the
/// roots are off by at most 15ε p² and 5ε r², and near 0 a root is off by the root of that.
inline constexpr double extreme = 1e-7;
static_assert(extreme * extreme > 2 * (15 + 5) * unit_roundoff);  // (√15 + √5)² < 2 (15 + 5)

/// Allowance for offsets and sums in single precision, in radii, for each radius of length. An offset from another site
/// is below 3.1 in each coordinate, and differences of two offsets are off by less than 10⁻⁶ in total; so are sums of
/// products.
inline constexpr double rounding = 1e-5;
static_assert(rounding > 4 * 1e-6 && 1e-6 > 4 * 4 * float_roundoff);

}  // namespace rbpa::space::limits
