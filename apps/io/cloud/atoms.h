// What: reads the atoms of a molecule's file of any format, frame by frame, each atom as texts in columns.
// Law:  the atoms of a frame are in the order of the file. Frames after the last frame that is read are only counted.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/text/condition.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// The columns of an atom. The first names_of_atom columns name the atom; the first columns_of_pdb are those of PDB.
inline constexpr std::array<std::string_view, 16> atom_columns = {
    "serial", "chain", "resseq", "icode",     "resname", "name",   "element", "x",
    "y",      "z",     "altloc", "occupancy", "bfactor", "charge", "record",  "radius"};
inline constexpr std::size_t names_of_atom = 7, x_of_atom = 7, columns_of_pdb = 15, no_atom_column = 16;

/// The indices of the columns in atom_columns.
struct AtomColumn {
  static constexpr std::size_t serial = 0, chain = 1, resseq = 2, icode = 3, resname = 4, name = 5, element = 6,
                               altloc = 10, occupancy = 11, bfactor = 12, charge = 13, record = 14, radius = 15;
};

/// Returns the index in atom_columns of a name, in letters of either case; no_atom_column if there is none.
std::size_t atom_column(std::string_view name);

/// Returns whether the column holds texts, even if they look like numbers; otherwise it holds numbers.
bool is_text_of_atom(std::size_t column);

/// Returns whether the name of a residue is one of those of water.
bool is_water(std::string_view residue);

struct Atom {
  std::size_t line = 0;                                      ///< number of the line where the atom begins
  std::array<std::string, atom_columns.size()> fields = {};  ///< an empty text where the file has no value
  std::vector<std::string> others = {};                      ///< values of all columns, if the file names its columns
  std::size_t name_begins = 0;  ///< column of the line where the name begins, which shows the element in PDB; else 0

  bool is_hetero() const { return fields[AtomColumn::record] == "HETATM"; }
};

class AtomSource {
 public:
  virtual ~AtomSource() = default;
  AtomSource(const AtomSource&) = delete;
  AtomSource& operator=(const AtomSource&) = delete;

  /// Goes to the next frame, and skips the rest of the current frame; returns false at the end of the file. Throws
  /// BadInput, also if the file has no atom at all; Cancelled.
  virtual bool next_frame() = 0;
  /// Reads the next atom of the frame; returns false at the end of the frame. Throws BadInput, Cancelled.
  virtual bool next(Atom& atom) = 0;
  /// Returns the number in a column of the atom, NaN if the column is empty. Throws BadInput with the line; `where` is
  /// the end of the message.
  double number(const Atom& atom, std::size_t column, std::string_view where = "") const;
  /// Returns the position of the atom's center. Throws BadInput with the line.
  Point3 center(const Atom& atom) const;
  /// Returns the index of the column called `name`: its index in atom_columns, or no_atom_column plus its index in
  /// Atom::others. Requires: next_frame() has returned true. Throws BadInput if the file has no such column.
  virtual std::size_t column(std::string_view name) const;
  /// Returns the columns that may be kept: names and indices, as column() returns them, without those of coordinates.
  /// Requires: as column().
  virtual std::vector<std::pair<std::string, std::size_t>> other_columns() const;
  /// Returns whether the file has radii. Requires: next_frame() has returned true.
  virtual bool has_radii() const { return false; }
  /// Returns the text of the atom in the column with the index `column`, as the member function column() returns it.
  static const std::string& text(const Atom& atom, std::size_t column) {
    return column < no_atom_column ? atom.fields[column] : atom.others[column - no_atom_column];
  }

  std::size_t frames() const { return frames_; }  ///< frames with atoms, as far as the file has been read
  std::size_t blocks() const { return blocks_; }  ///< data blocks with atoms; known at the end; only the first is read
  UnitCell& cell() { return cell_; }              ///< box of the frame; known at the end of the frame
  std::string_view remark() const { return remark_; }  ///< a warning about all coordinates; empty if there is none

 protected:
  explicit AtomSource(const std::string& name) : name_(name) {}
  /// Returns the number in a column of the atom, in the units of the result. Throws BadInput, also for an empty text.
  virtual double parsed(const Atom& atom, std::size_t column, std::string_view where) const;

  const std::string& name_;
  std::size_t frames_ = 0, blocks_ = 1;
  UnitCell cell_ = {};
  std::string_view remark_ = {};
};

/// A function that opens the atoms in a text of one format. The text and `name` must outlive the result. `all_frames`:
/// the caller will also read frames after the first.
using OpenAtoms = std::unique_ptr<AtomSource> (*)(std::string_view text, const std::string& name, bool all_frames);

/// Open the atoms in a text of a format: PDB (records ATOM and HETATM), PQR, PDBx/mmCIF (category _atom_site), GROMACS'
/// .gro, LAMMPS' dump, or the .xyz of chemistry.
std::unique_ptr<AtomSource> pdb_atoms(std::string_view text, const std::string& name, bool all_frames);
std::unique_ptr<AtomSource> pqr_atoms(std::string_view text, const std::string& name, bool all_frames);
std::unique_ptr<AtomSource> cif_atoms(std::string_view text, const std::string& name, bool all_frames);
std::unique_ptr<AtomSource> gro_atoms(std::string_view text, const std::string& name, bool all_frames);
std::unique_ptr<AtomSource> dump_atoms(std::string_view text, const std::string& name, bool all_frames);
std::unique_ptr<AtomSource> xyz_atoms(std::string_view text, const std::string& name, bool all_frames);

/// Returns the function that opens the atoms of a format of molecules; null for other formats.
OpenAtoms atoms_of(Format format);

/// Evaluates a condition for one atom after the other, and returns the values that the condition requests of each atom.
class AtomSelection {
 public:
  /// Requires: source.next_frame() has returned true. Throws BadInput for a column that the file does not have.
  AtomSelection(const Condition& where, const AtomSource& source);

  bool holds(const Atom& atom);
  /// Returns whether the condition compares residues with this name: it then decides about this residue of water.
  bool names_residue(std::string_view name) const;
  /// Returns whether the condition's column k holds texts.
  bool is_text(std::size_t k) const { return is_text_[k]; }
  const std::string& text(const Atom& atom, std::size_t k) const { return AtomSource::text(atom, places_[k]); }
  double number(const Atom& atom, std::size_t k) const;
  void warning(std::string_view noun, std::vector<std::string>& warnings) const { selection_.warning(noun, warnings); }

 private:
  const AtomSource& source_;
  std::vector<std::size_t> places_ = {};                         // columns of the condition's fields
  std::vector<std::pair<std::size_t, std::string>> texts_ = {};  // columns compared with texts, and the texts
  std::vector<bool> is_text_ = {};
  Selection selection_;
};

/// Returns the edges of a cell of three lengths and three angles, in degrees, as UnitCell::edges; nothing unless the
/// lengths are above 0 and there is a cell with these angles.
std::optional<CellEdges> edges_of_cell(const std::array<double, 6>& lengths_and_angles);

/// Returns the unit cell of three lengths and three angles, in degrees; no cell if all texts are empty. UnitCell::fault
/// names `record`, the record of the file with the values.
UnitCell unit_cell(const std::string& record, const std::array<std::string_view, 6>& values);
UnitCell unit_cell(const std::string& record, const std::array<double, 6>& lengths_and_angles);

/// Returns the unit cell of three edges, one after another. UnitCell::fault names `record`, the record of the file with
/// the edges.
UnitCell unit_cell(const std::string& record, const std::array<double, 9>& edges,
                   const std::array<bool, 3>& repeats = {true, true, true});

/// Returns a warning if a cell has more copies of the atoms than the one that the file has; empty if it does not.
std::string warning_of_symmetry(const UnitCell& cell);

/// Returns a warning if the points reach over more than twice the box along an axis of space: the box may be another
/// one, or in another unit. Whole molecules and trajectories that are not wrapped reach over little more than their
/// box. `noun` names the points.
std::vector<std::string> warnings_of_range(std::span<const Point3> points, const CellEdges& box,
                                           const std::string& noun);

/// Returns a number of CIF without its standard uncertainty: "5.28(3)" is 5.28.
std::string_view without_uncertainty(std::string_view number);

}  // namespace rbpa::app
