// What: the atoms of a file one after the other, whatever its format, as texts in columns.
// Law:  they are those of the first model, in the order of the file.
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

/// The columns of an atom. Those that name it come first.
inline constexpr std::array<std::string_view, 13> atom_columns = {"serial", "chain",     "resseq", "icode", "resname",
                                                                  "name",   "element",   "x",      "y",     "z",
                                                                  "altloc", "occupancy", "bfactor"};
inline constexpr std::size_t names_of_atom = 7, x_of_atom = 7, no_atom_column = atom_columns.size();

/// Returns the index in atom_columns of a name, in letters of either case; no_atom_column where there is none.
std::size_t atom_column(std::string_view name);

/// Whether it holds a text, whatever that looks like; else it holds a number.
bool is_text_of_atom(std::size_t column);

struct Atom {
  std::size_t line = 0;                                      ///< where it begins in the file
  std::array<std::string, atom_columns.size()> fields = {};  ///< empty where there is nothing
};

class AtomSource {
 public:
  AtomSource() = default;
  virtual ~AtomSource() = default;
  AtomSource(const AtomSource&) = delete;
  AtomSource& operator=(const AtomSource&) = delete;

  /// Goes to the next atom; false at the end. Throws BadInput, where the file has no atom at all too; Cancelled.
  virtual bool next(Atom& atom) = 0;
  /// Throws BadInput where a value before the current atom may be missing, so that others are not in their columns.
  virtual void require_columns() const {}

  std::size_t models() const { return models_; }  ///< of the file, with atoms; at the end
  std::size_t blocks() const { return blocks_; }  ///< of data, with atoms, of which the first is read; at the end
  UnitCell& cell() { return cell_; }              ///< at the end

 protected:
  std::size_t models_ = 0, blocks_ = 1;
  UnitCell cell_ = {};
};

/// PDB's records ATOM and HETATM, PDBx/mmCIF's category _atom_site. The text and its name have to stay there.
std::unique_ptr<AtomSource> pdb_atoms(std::string_view text, const std::string& name);
std::unique_ptr<AtomSource> cif_atoms(std::string_view text, const std::string& name);

/// The cell of three lengths and three angles, which `record` names; of empty texts none.
UnitCell unit_cell(const std::string& record, const std::array<std::string_view, 6>& values);

/// A number of CIF without its standard uncertainty: "5.28(3)" is 5.28.
std::string_view without_uncertainty(std::string_view number);

}  // namespace rbpa::app
