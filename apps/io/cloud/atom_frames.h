// What: the frames of a file of atoms, each as rows, with its box: models of PDB and CIF, frames of .xyz, .gro, .pqr
//       and dumps. Other points in space are one frame without names.
// Law:  atoms that are left out are counted; the others are in the order of the file.
// Cost: the file is in memory, and one frame of rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/bytes/input_bytes.h"
#include "io/cloud/atoms.h"
#include "io/cloud/cloud.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// An atom. Numbers that the file does not have are NaN. Texts are numbers in AtomFrame::texts, 0 for an empty text.
struct AtomRow {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Point3 center = {};
  double radius = none, serial = none, resseq = none, occupancy = none, charge = none;
  std::uint32_t name = 0, resname = 0, chain = 0, icode = 0, altloc = 0;
  std::uint32_t group = 0;    ///< the value in the column that was chosen
  std::uint32_t element = 0;  ///< a symbol, "Ca"; the text of the file if it is none
  bool is_water = false, is_hetero = false;
  std::size_t line = 0;   ///< of the file; 0 for points that are no atoms
  std::size_t index = 0;  ///< among all atoms of the frame
};

/// The atoms of a frame in the file and, each for the first reason that applies, those that were left out.
struct AtomCounts {
  std::size_t in_file = 0;
  std::size_t deselected = 0;  ///< by the condition
  std::size_t waters = 0, ligands = 0, hydrogens = 0;
  std::size_t alternates = 0;  ///< other locations of atoms that are kept
};

struct AtomFrame {
  std::size_t number = 0;  ///< in the file, from 1
  std::vector<AtomRow> rows = {};
  bool has_radii = false;  ///< rows have the radii of the file, or of the column that was chosen
  UnitCell cell = {};
  AtomCounts counts = {};
  std::vector<std::string> texts = {};  ///< of all frames that were read into this object, each once
  std::unordered_map<std::string, std::uint32_t> numbers = {};  ///< of the texts

  const std::string& text(std::uint32_t of) const { return texts[of]; }
  /// Returns the number of a text, which is added if it is new; `likely` is tried first.
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
  std::vector<std::size_t> numbers = {1};  ///< from 1, ascending; unless all
};

/// Parses "all", or numbers and ranges from 1: "1,3,10-20". Throws WrongUsage.
FrameChoice parse_frames(const std::string& option, const std::string& text);

/// The atoms that are read.
struct AtomChoice {
  FrameChoice frames = {};
  bool waters = false;      ///< keep the atoms of water; so does a condition that names residues
  bool ligands = true;      ///< keep other atoms of records HETATM
  bool hydrogens = true;    ///< keep hydrogen and its isotopes
  bool alternates = false;  ///< keep all alternate locations
  std::optional<std::string> where = std::nullopt;   ///< a condition
  std::optional<std::string> radius = std::nullopt;  ///< the column of radii; absent: that of the file, if there is one
  std::optional<std::string> group = std::nullopt;   ///< the column of AtomRow::group
  unsigned threads = 0;                              ///< as CloudRequest::threads
};

class AtomFrames {
 public:
  /// Reads a file, "-" for standard input. Throws BadInput, WrongUsage, Failure, Cancelled.
  AtomFrames(const std::string& path, Format format, AtomChoice choice);
  /// Reads bytes, which must outlive this object; `name` stands for them in messages.
  AtomFrames(std::string_view bytes, std::string name, Format format, AtomChoice choice);

  /// Reads the next frame of the choice; returns false at the end. Throws BadInput, also if a frame of the choice is
  /// not there, or no atom of a frame is kept; Cancelled.
  bool next(AtomFrame& frame);

  const std::string& name() const { return name_; }
  std::size_t frames() const { return frames_; }  ///< of the file; known when next() has returned false
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
  std::size_t frames_ = 0;                                                   // that were begun
  bool is_begun_ = false;                                                    // the frame is begun, and not read
  std::vector<std::string> warnings_ = {};
};

}  // namespace rbpa::app
