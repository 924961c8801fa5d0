// What: the atoms of a molecule's file, of any format, one after the other as texts in columns.
// Law:  the atoms are those of the first model, in the order of the file.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/cloud/cloud.h"
#include "io/text/condition.h"

namespace rbpa::app {

/// The columns of an atom; the first names_of_atom of them name it.
inline constexpr std::array<std::string_view, 13> atom_columns = {"serial", "chain",     "resseq", "icode", "resname",
                                                                  "name",   "element",   "x",      "y",     "z",
                                                                  "altloc", "occupancy", "bfactor"};
inline constexpr std::size_t names_of_atom = 7, x_of_atom = 7, no_atom_column = atom_columns.size();

/// Returns the index in atom_columns of a name, in letters of either case; no_atom_column if there is none.
std::size_t atom_column(std::string_view name);

/// Returns whether the column holds texts, even if they look like numbers; otherwise it holds numbers.
bool is_text_of_atom(std::size_t column);

struct Atom {
  std::size_t line = 0;                                      ///< of the file, where the atom begins
  std::array<std::string, atom_columns.size()> fields = {};  ///< an empty text where the file has no value
};

class AtomSource {
 public:
  AtomSource() = default;
  virtual ~AtomSource() = default;
  AtomSource(const AtomSource&) = delete;
  AtomSource& operator=(const AtomSource&) = delete;

  /// Reads the next atom; returns false at the end. Throws BadInput, also if the file has no atom at all; Cancelled.
  virtual bool next(Atom& atom) = 0;
  /// Throws BadInput if a value before the current atom may be missing, so that later values are in wrong columns.
  virtual void require_columns() const {}

  std::size_t models() const { return models_; }  ///< models with atoms; known at the end
  std::size_t blocks() const { return blocks_; }  ///< data blocks with atoms; known at the end; only the first is read
  UnitCell& cell() { return cell_; }              ///< known at the end

 protected:
  std::size_t models_ = 0, blocks_ = 1;
  UnitCell cell_ = {};
};

/// Return the atoms of PDB's records ATOM and HETATM, and of PDBx/mmCIF's category _atom_site. The text and `name` must
/// outlive the result.
std::unique_ptr<AtomSource> pdb_atoms(std::string_view text, const std::string& name);
std::unique_ptr<AtomSource> cif_atoms(std::string_view text, const std::string& name);

/// Returns the unit cell of three lengths and three angles, in degrees, from a record of the file; none of empty texts.
UnitCell unit_cell(const std::string& record, const std::array<std::string_view, 6>& values);

/// Returns a number of CIF without its standard uncertainty: "5.28(3)" is 5.28.
std::string_view without_uncertainty(std::string_view number);

}  // namespace rbpa::app
