// What: the frames of a file of atoms, each as rows, with its box: models of PDB and CIF, frames of .xyz, .gro, .pqr
//       and dumps. Other points in space are one frame without names.
// Law:  atoms that are left out are counted; the others are in the order of the file.
// Cost: the file and the rows of one frame are in memory.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "io/bytes/input_bytes.h"
#include "io/cloud/atoms.h"
#include "io/cloud/cloud.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// An atom. Numbers that the file does not have are NaN. Texts are indices in AtomFrame::texts, 0 for the empty text.
struct AtomRow {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Point3 center = {};
  double radius = none, serial = none, resseq = none, occupancy = none, bfactor = none, charge = none;
  std::uint32_t name = 0, resname = 0, chain = 0, icode = 0, altloc = 0, record = 0;
  std::uint32_t group = 0;    ///< value in the column AtomChoice::group
  std::uint32_t element = 0;  ///< symbol, such as "Ca"; the text in the file if it is no symbol
  bool is_water = false;
  std::size_t line = 0;   ///< number of the line in the file; 0 for points that are no atoms
  std::size_t index = 0;  ///< number among all atoms of the frame, from 0
};

/// The chain, the number and the insertion code of a residue, to compare residues of one frame.
using Residue = std::tuple<std::uint32_t, std::uint64_t, std::uint32_t>;

inline Residue residue_of(const AtomRow& row) {
  return {row.chain, std::bit_cast<std::uint64_t>(row.resseq), row.icode};
}

/// Numbers of atoms of a frame: all in the file, and those left out, each for the first reason that applies.
struct AtomCounts {
  std::size_t in_file = 0;
  std::size_t deselected = 0;  ///< atoms that the condition excludes
  std::size_t waters = 0, ligands = 0, hydrogens = 0;
  std::size_t alternates = 0;  ///< alternate locations that are left out
};

struct AtomFrame {
  std::size_t number = 0;  ///< number of the frame in the file, from 1
  std::vector<AtomRow> rows = {};
  bool has_radii = false;  ///< rows have the radii of the file, or of the column that was chosen
  UnitCell cell = {};
  AtomCounts counts = {};
  std::vector<std::string> texts = {};  ///< distinct texts of all frames that were read into this object
  std::unordered_map<std::string, std::uint32_t> numbers = {};  ///< index of each text in `texts`

  const std::string& text(std::uint32_t of) const { return texts[of]; }
  /// Returns the index of a text in `texts`, to which a new text is appended. Tries the index `likely` first.
  std::uint32_t number_of(std::string_view text, std::uint32_t likely = 0);
  /// Returns a column of the rows: column(&AtomRow::center).
  template <typename Value>
  std::vector<Value> column(Value AtomRow::*member) const {
    std::vector<Value> values;
    for (const AtomRow& row : rows) values.push_back(row.*member);
    return values;
  }
  /// Returns "atom CA of residue ALA A 12B", for messages.
  std::string title(const AtomRow& row) const;
};

/// The frames that are read.
struct FrameChoice {
  bool all = false;
  std::size_t first = 1, step = 1;         ///< if `all`: the first frame, and the step to the next one
  std::vector<std::size_t> numbers = {1};  ///< from 1, ascending; ignored if `all`

  bool has(std::size_t number) const;
  bool may_have_several() const { return all || numbers.size() > 1; }
  /// Returns the number of a frame that must be in the file: the last one, or that of `first` if `all`.
  std::size_t required() const { return all ? first : numbers.back(); }
};

/// Parses "all", numbers and ranges from 1, "1,3,10-20", or "FIRST:LAST:STEP", of which LAST, or LAST and STEP, may be
/// missing: "1::10" are all frames from the first in steps of ten. Throws WrongUsage.
FrameChoice parse_frames(const std::string& option, const std::string& text);

/// The atoms that are read.
struct AtomChoice {
  FrameChoice frames = {};
  bool waters = false;      ///< keep the atoms of water; `where` decides about residues of water that it names
  bool ligands = true;      ///< keep other atoms of records HETATM
  bool hydrogens = true;    ///< keep hydrogen and its isotopes
  bool alternates = false;  ///< keep all alternate locations
  std::optional<std::string> where = std::nullopt;   ///< a condition
  std::optional<std::string> radius = std::nullopt;  ///< the column of radii; absent: that of the format, if it has one
  std::optional<std::string> group = std::nullopt;   ///< the column of AtomRow::group
  unsigned threads = 0;                              ///< as CloudRequest::threads
};

class AtomFrames {
 public:
  /// Reads a file, "-" for standard input. Throws BadInput, WrongUsage, Failure, Cancelled.
  AtomFrames(const std::string& path, Format format, AtomChoice choice);
  /// Reads bytes, which must outlive this object. Messages call the bytes `name`.
  AtomFrames(std::string_view bytes, std::string name, Format format, AtomChoice choice);

  /// Reads the next frame of the choice; returns false at the end. Throws BadInput, also if a frame of the choice is
  /// not there, or no atom of a frame is kept; Cancelled.
  bool next(AtomFrame& frame);

  const std::string& name() const { return name_; }
  std::size_t frames() const { return frames_; }  ///< number in the file; known when next() has returned false
  /// Returns warnings, one sentence each; complete when next() has returned false.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void open(std::string_view bytes);
  void read_atoms(AtomFrame& frame);
  void read_points(AtomFrame& frame);

  std::optional<InputBytes> input_ = std::nullopt;
  std::string name_;
  Format format_;
  AtomChoice choice_;
  std::string room_ = {};  // holds the bytes if ends of lines were changed
  std::string_view bytes_ = {};
  std::unique_ptr<AtomSource> source_ = nullptr;  // null for points that are no atoms
  std::optional<AtomSelection> selection_ = std::nullopt;
  std::optional<std::size_t> radius_ = std::nullopt, group_ = std::nullopt;  // the columns that were chosen
  struct Frame {
    std::size_t number = 0, atoms = 0;
  };
  Frame first_ = {}, other_ = {};  // the first frame of the choice; the first of them with another number of atoms
  std::size_t frames_ = 0;         // number of frames begun
  bool is_begun_ = false;          // the current frame is not read yet
  std::vector<std::string> warnings_ = {};
};

}  // namespace rbpa::app
