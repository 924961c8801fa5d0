// What: the .xyz format of chemistry as a table: the number of atoms, a comment line, and a line for each atom with its
//       element and x, y, z.
// Source: extended XYZ, https://github.com/libAtoms/extxyz: "Properties=species:S:1:pos:R:3:..." in the comment names
//         the columns.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rbpa::app {

struct XyzAtoms {
  std::size_t count = 0;                 ///< of atoms
  std::vector<std::string> names = {};   ///< of columns, "element", "x", "y" and "z" among them
  const char* behind_comment = nullptr;  ///< the end of the comment in the text
};

/// Returns the beginning of a list of atoms, whose first line is the number of atoms; nothing if the third line of
/// `text` is not an atom. `by_number`: elements may be numbers.
std::optional<XyzAtoms> find_xyz_atoms(std::string_view text, bool by_number);

}  // namespace rbpa::app
