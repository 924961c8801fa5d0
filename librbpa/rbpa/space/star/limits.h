// What: how near to a tie a sign may be and still be told without exact arithmetic. docs/surface.md, section 5.
#pragma once

namespace rbpa::space::limits {

inline constexpr double flatness = 1e-10;  // of a triangle and its ball: their squares, below which it is not certain
inline constexpr double error = 1e-7;      // of centres, as a share of the radius
inline constexpr double slack = 1e-6;      // of directions, as a share of lengths
inline constexpr double rounding = 1e-5;   // of what is in single precision, in radii

}  // namespace rbpa::space::limits
