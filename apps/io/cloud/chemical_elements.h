// What: elements: their symbols and radii, and the element of an atom, from the column that names it or from its name.
// Source: A. Bondi, J. Phys. Chem. 68, 441 (1964); M. Mantina et al., J. Phys. Chem. A 113, 5806 (2009), for 16
//         elements that Bondi has not; S. Alvarez, Dalton Trans. 42, 8617 (2013), for 44
//         metals that both have not; names in PDB have the symbol in columns 13 and 14, right-justified:
//         https://www.wwpdb.org/documentation/file-format-content/format33/sect9.html#ATOM
#pragma once

#include <string_view>

#include "io/cloud/atoms.h"

namespace rbpa::app {

struct Element {
  std::string_view symbol;
  double radius;  ///< van der Waals radius, in angstroms; 0 if none is known
};

/// Returns the element of a symbol in letters of either case, perhaps with a charge or number ("FE3+", "C12"); also "D"
/// and "T". Null if there is none.
const Element* find_element(std::string_view symbol);

/// Returns the source of the radius of an element that has one: "Bondi", "Mantina" or "Alvarez".
std::string_view source_of_radius(std::string_view symbol);

/// Returns the symbol of the atom's element; empty if neither the column nor the name shows an element.
std::string_view element_of(const Atom& atom);

inline bool is_hydrogen(std::string_view symbol) { return symbol == "H" || symbol == "D" || symbol == "T"; }

/// Returns whether a residue is one of the 20 amino acids, under all names of force fields.
bool is_amino_acid(std::string_view residue);

}  // namespace rbpa::app
