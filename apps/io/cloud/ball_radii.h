// What: radii of atoms: those of their file, of a table of elements or of atoms of proteins, or of a file of radii.
// Source: Bondi, Mantina and Alvarez as in chemical_elements.h. ProtOr: J. Tsai et al., J. Mol. Biol. 290, 253 (1999).
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/cloud/atom_frames.h"

namespace rbpa::app {

/// Returns ProtOr's radius of an atom of an amino acid, which includes the atom's hydrogens; nothing for other atoms.
std::optional<double> protor_radius(std::string_view residue, std::string_view name);

/// The least and greatest radius that were used for an element, and the number of its atoms.
struct UsedRadii {
  double least, greatest;
  std::size_t atoms;
};

class BallRadii {
 public:
  /// Takes a choice: "bondi"; "protor"; "column:NAME"; or the path of a file of radii, with Bondi's radii for atoms
  /// that the file does not name. An absent choice stands for the radii in the file of atoms, or Bondi's if there are
  /// none. `otherwise` is the radius of atoms without one. Throws BadInput for an invalid file; WrongUsage.
  explicit BallRadii(const std::optional<std::string>& choice, std::optional<double> otherwise = std::nullopt);

  /// Sets the radius of an element. Radii in the file of atoms have precedence. Throws WrongUsage.
  void override_element(const std::string& symbol, double radius);

  /// The column of radii, for AtomChoice::radius.
  const std::optional<std::string>& column() const { return column_; }
  /// Returns a radius for each atom; `name` is the file of the atoms. Throws BadInput for the first atom that has none.
  std::vector<double> of(const AtomFrame& frame, const std::string& name);
  /// Returns the radii that of() has used, by element (an empty text for points without an element) and by source:
  /// "Bondi", "Mantina", "Alvarez", "ProtOr", "file", "override" or "default".
  const std::map<std::pair<std::string, std::string_view>, UsedRadii>& used() const { return used_; }

 private:
  void read(const std::string& path);
  std::pair<double, std::string_view> find(const AtomFrame& frame, const AtomRow& atom, const std::string& name) const;

  bool is_protor_ = false;
  bool has_table_ = false;  // radii in the file of atoms do not count
  std::optional<std::string> column_ = std::nullopt;
  std::optional<double> otherwise_;
  /// Radii by residue ("*" for any) and name of an atom, or by "" and element.
  std::map<std::pair<std::string, std::string>, double> overrides_ = {};
  std::map<std::pair<std::string, std::string_view>, UsedRadii> used_ = {};
};

}  // namespace rbpa::app
