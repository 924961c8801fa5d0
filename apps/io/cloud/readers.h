// What: a reader of points for each format, as cloud_format() lists them, and what packed files say of their size.
// Law:  each throws BadInput as Cloud has it; nothing is allocated for what a header only claims.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "io/cloud/cloud.h"

namespace rbpa::app {

/// Little-endian float64 pairs x, y and nothing else.
std::unique_ptr<Cloud> open_raw(Content content, const CloudRequest& request);

/// An array as read_npy_layout() has it: of shape (n, 2) or (n, 3), or in space (n, 3) or (n, 6), of which the last three
/// columns are normals. What follows the array is left alone, as NumPy does.
std::unique_ptr<Cloud> open_npy(Content content, const CloudRequest& request);

/// LAS 1.0 to 1.4, point formats 0 to 10. Red, green and blue unless all are black.
std::unique_ptr<Cloud> open_las(Content content, const CloudRequest& request);

/// The element "vertex": x, y, z; nx, ny, nz and red, green, blue (of type uchar) where all three are there. Everything else
/// is passed over; in a binary file it has to be there nevertheless, so that a cut file is noticed.
std::unique_ptr<Cloud> open_ply(Content content, const CloudRequest& request);

/// The vertices, with the normals of NOFF and the colors of COFF. Faces are not read.
std::unique_ptr<Cloud> open_off(Content content, const CloudRequest& request);

/// The lines "v", with colors where they have six numbers or more, and "vn". A vertex has the normal that the corners of
/// faces give it; where faces name none, there are normals when they are as many as vertices, in their order. Where neither
/// says one for each vertex there are none.
std::unique_ptr<Cloud> open_obj(Content content, const CloudRequest& request);

/// Versions 0.5 to 0.7 of the Point Cloud Library's format, ASCII or binary, compressed or not: x, y, z; normal_x, normal_y, normal_z when all
/// are there; rgb or rgba.
std::unique_ptr<Cloud> open_pcd(Content content, const CloudRequest& request);

/// A table in text, a point a line. Every line is a point, a comment ('#'), blank, or the one header; anything else is refused
/// by its line, or left out and counted. The separator is the first of comma, semicolon, tab and blanks that the first line
/// of data contains; but where every comma stands inside a number, as in "1,5;2,5", it is a decimal sign. Fields may stand in
/// double quotes (not with blanks). All lines have the same number of columns. Of a line that is not as the condition asks
/// only the columns that it names are read.
std::unique_ptr<Cloud> open_table(Content content, const CloudRequest& request);

/// The same, and where no header names the columns: x, y, z, and with them an intensity, a color or both; of such a table the first
/// line may be the number of points, of which no more and no fewer may follow, unless invalid ones are skipped.
std::unique_ptr<Cloud> open_pts(Content content, const CloudRequest& request);

/// The same, and where no header names them x, y, z, nx, ny, nz.
std::unique_ptr<Cloud> open_xyzn(Content content, const CloudRequest& request);

/// The same, and where no header names them x, y, z, red, green, blue: from 0 to 1, or to 255 where one of the file is greater.
std::unique_ptr<Cloud> open_xyzrgb(Content content, const CloudRequest& request);

/// The atoms of the first model, in the order of the file, alternate locations included: PDB's records ATOM and HETATM, and
/// PDBx/mmCIF's _atom_site, with atom_columns as their fields. Requires: content in memory.
std::unique_ptr<Cloud> open_pdb(Content content, const CloudRequest& request);
std::unique_ptr<Cloud> open_cif(Content content, const CloudRequest& request);

/// Claims: the bytes of all rows; of all points, or as many lines.
double claimed_npy_size(std::string_view first, const std::string& name);
double claimed_pcd_size(std::string_view first, const std::string& name);

/// atom_columns.
FieldNames names_of_atoms();

/// Number properties of PLY and fields of PCD: any name.
FieldNames names_of_properties();

}  // namespace rbpa::app
