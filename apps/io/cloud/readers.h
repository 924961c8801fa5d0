// What: the readers of points, one for each format of cloud_format(), and the claims of compressed files.
// Law:  each throws BadInput as Cloud::next(); nothing is allocated for points that only a header claims.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "io/cloud/cloud.h"

namespace rbpa::app {

/// Reads raw numbers: pairs x, y of little-endian float64 and nothing else.
std::unique_ptr<Cloud> open_raw(Content content, const CloudRequest& request);

/// Reads an array of NumPy: of shape (n, 2) or (n, 3); in space of shape (n, 3) or (n, 6), whose last three columns are
/// normals. Ignores bytes behind the array, as NumPy does.
std::unique_ptr<Cloud> open_npy(Content content, const CloudRequest& request);

/// Reads LAS 1.0 to 1.4, point formats 0 to 10, with red, green and blue unless all points are black.
std::unique_ptr<Cloud> open_las(Content content, const CloudRequest& request);

/// Reads the element "vertex" of PLY: x, y, z; nx, ny, nz if all three are there; and red, green, blue (of type uchar)
/// if all three are there. Ignores everything else, but a binary file must hold it, so that a truncated file is
/// noticed.
std::unique_ptr<Cloud> open_ply(Content content, const CloudRequest& request);

/// Reads the vertices of OFF, with the normals of NOFF and the colors of COFF. Does not read the faces.
std::unique_ptr<Cloud> open_off(Content content, const CloudRequest& request);

/// Reads the lines "v" of OBJ, with colors if they have six numbers or more, and "vn". A vertex has the normal that the
/// corners of faces give it. If faces name no normals, and there are equally many vertices and normals, they belong
/// together in their order. If neither gives every vertex a normal, there are none.
std::unique_ptr<Cloud> open_obj(Content content, const CloudRequest& request);

/// Reads PCD, the Point Cloud Library's format, versions 0.5 to 0.7, ASCII or binary, compressed or not: x, y, z;
/// normal_x, normal_y, normal_z if all three are there; rgb or rgba.
std::unique_ptr<Cloud> open_pcd(Content content, const CloudRequest& request);

/// Reads a table in text, one point per line. Every line is a point, a comment ('#'), blank, or the one header; other
/// lines are refused by their number, or left out and counted. The separator is the first of comma, semicolon, tab and
/// blanks that the first line of data contains; but if every comma stands inside a number, as in "1,5;2,5", it is a
/// decimal sign. Fields may be in double quotes (not with blanks as separator). All lines have the same number of
/// columns. In a line that the condition excludes, only the condition's columns are read.
std::unique_ptr<Cloud> open_table(Content content, const CloudRequest& request);

/// Reads a table whose columns, if no header names them, are x, y, z and then an intensity, a color or both. The first
/// line of such a table may be the number of points; exactly as many must follow, unless invalid ones are skipped.
std::unique_ptr<Cloud> open_pts(Content content, const CloudRequest& request);

/// Reads a table whose columns, if no header names them, are x, y, z, nx, ny, nz.
std::unique_ptr<Cloud> open_xyzn(Content content, const CloudRequest& request);

/// Reads a table whose columns, if no header names them, are x, y, z, red, green, blue: from 0 to 1, or from 0 to 255
/// if one of the file is greater than 1.
std::unique_ptr<Cloud> open_xyzrgb(Content content, const CloudRequest& request);

/// Read the atoms of the first model, in the order of the file, alternate locations included: PDB's records ATOM and
/// HETATM, and PDBx/mmCIF's _atom_site, with atom_columns as their fields. Requires: content in memory.
std::unique_ptr<Cloud> open_pdb(Content content, const CloudRequest& request);
std::unique_ptr<Cloud> open_cif(Content content, const CloudRequest& request);

/// Return the size that a header claims, for Claim::size: up to the end of all rows; of all points, or of as many
/// lines.
double claimed_npy_size(std::string_view first, const std::string& name);
double claimed_pcd_size(std::string_view first, const std::string& name);

/// Returns atom_columns.
FieldNames names_of_atoms();

/// Returns the rule for number properties of PLY and fields of PCD: any name.
FieldNames names_of_properties();

}  // namespace rbpa::app
