// What: points of space from the content of a file of each format. What is common to all, such as normals of length 0, is
//       looked at behind them (read_space_points.cpp).
// Law:  points are finite; of normals and colours there are none, or one a point. Each throws BadInput as
//       read_space_points() has it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/condition.h"
#include "io/space/read_space_points.h"
#include "io/space/space_points.h"

namespace rbpa::app {

/// A table: separators, comments, quotes, decimal commas and headers as TextTable has them. Without a header 3 columns,
/// or 6, of which the last three are colours where all are whole numbers up to 65535 and one is greater than 1, else
/// normals.
SpacePoints read_space_table(std::string_view text, const std::string& name, const SpaceChoice& choice);

/// The vertices: x, y, z; nx, ny, nz and red, green, blue (of type uchar) when all three are there.
SpacePoints read_ply_space(std::string_view bytes, const std::string& name);

/// The vertices, with the normals of NOFF and the colours of COFF. Faces are not read.
SpacePoints read_off_space(std::string_view text, const std::string& name);

/// The lines "v", with colours where they have six numbers or more, and "vn". A vertex has the normal that the corners of faces give it; where faces name none, there are
/// normals when they are as many as vertices, in their order. Where neither says one for each vertex there are none.
SpacePoints read_obj_space(std::string_view text, const std::string& name);

/// Versions 0.5 to 0.7 of the Point Cloud Library's format, ASCII or binary: x, y, z; normal_x, normal_y, normal_z when
/// all are there; rgb or rgba.
SpacePoints read_pcd_space(std::string_view bytes, const std::string& name);

/// An array of shape (n, 3) or (n, 6) as read_npy_layout() has it.
SpacePoints read_npy_space(std::string_view bytes, const std::string& name);

/// A Claim: the bytes of all its rows.
double claimed_npy_space_size(std::string_view first, const std::string& name);

/// x, y and z of every record, or of those that a condition selects; red, green and blue unless all are black.
SpacePoints read_las_space(std::string_view bytes, const std::string& name, const SpaceChoice& choice);

/// For readers of binary files: appends the point of 3 values, or with its normal of 6, which have to be finite.
void append_numbers(std::span<const double> values, SpacePoints& file, const std::string& name);

/// The same of room for so many points, which the file has.
void reserve_points(SpacePoints& file, std::size_t count, bool normals, bool colors);

}  // namespace rbpa::app
