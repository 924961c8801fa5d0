// What: writes the results of `rbpa balls`: rows of atoms, of groups of atoms and of contacts, and reports.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/cloud/atom_frames.h"
#include "io/cloud/ball_radii.h"
#include "rbpa/space/balls/ball_interfaces.h"
#include "rbpa/space/balls/ball_voids.h"
#include "rbpa/space/balls/periodic_balls.h"
#include "rbpa/space/balls/pore_sizes.h"
#include "rbpa/space/balls/regular_triangulation.h"

namespace rbpa::app {

/// The groups of atoms that are summed up, each in one row. With `none`, each atom has its own row.
enum class AtomGroups { none, residue, chain, column };

/// The counts and sizes of one frame in the reports.
struct BallTotals {
  std::size_t number = 0;  ///< number of the frame, from 1
  AtomCounts counts = {};
  std::size_t kept = 0, buried = 0;  ///< numbers of atoms, and of atoms without an area
  double volume = 0, area = 0, volume_without_probe = 0, area_without_probe = 0;
  std::optional<double> cell_volume = std::nullopt;  ///< of the box that repeats
  std::optional<PoreSizes> pores = std::nullopt;     ///< between the balls without the probe
};

struct MeasuredAtoms : BallTotals {
  std::vector<AtomRow> rows = {};
  std::vector<double> radii = {};                    ///< radii without the probe
  std::optional<RepeatingCell> cell = std::nullopt;  ///< the cell, if it repeats
  PeriodicBallMeasures balls = {};                   ///< measures with the probe; with contacts if contacts are written
  BallInterfaces interfaces = {};   ///< interfaces of the groups with the probe, if interfaces are written
  BallVoids voids = {};             ///< voids with the probe, if voids or pockets are written
  RegularTriangulation cells = {};  ///< triangulation that has the tetrahedra of the voids
};

/// A column of the names of atoms, with a text or a number for each atom.
struct NameColumn {
  std::string name;
  std::uint32_t AtomRow::*text = nullptr;
  double AtomRow::*number = nullptr;
};

/// Writes a table as CSV, frame by frame.
class BallRows {
 public:
  enum class Of { atoms, contacts, interfaces };

  /// Begins the table. `texts` is the object into which all frames are read, `column` the name of the column of groups.
  /// `are_atoms` tells whether rows have the names of atoms, `has_cells` whether frames have cells: contacts of atoms
  /// then have offsets. Keeps references to `file` and `texts`.
  BallRows(OutputFile& file, Of of, AtomGroups groups, const std::string& column, bool has_frames,
           const AtomFrame& texts, bool are_atoms, bool has_cells);

  void write(const MeasuredAtoms& frame) {
    of_ == Of::atoms ? write_atoms(frame) : of_ == Of::contacts ? write_contacts(frame) : write_interfaces(frame);
  }
  /// Returns the number of the group of each atom.
  std::vector<std::uint32_t> groups_of(const std::vector<AtomRow>& rows) const { return grouped(rows).of; }
  void finish() { file_.finish(); }

 private:
  /// The groups of the atoms of a frame, in the order of their first atoms. Without groups, each atom is a group.
  struct Grouped {
    std::vector<std::uint32_t> of;     // group of each atom
    std::vector<std::uint32_t> first;  // first atom of each group
  };
  Grouped grouped(const std::vector<AtomRow>& rows) const;
  void write_atoms(const MeasuredAtoms& frame);
  void write_contacts(const MeasuredAtoms& frame);
  void write_interfaces(const MeasuredAtoms& frame);
  void begin_row(const MeasuredAtoms& frame, std::span<const std::uint32_t> atoms);
  template <typename... Values>
  void end_row(Values... values);
  template <typename Value>
  void put(const Value& value);

  OutputFile& file_;
  Of of_;
  AtomGroups groups_;
  bool has_frames_;
  const AtomFrame& texts_;
  std::vector<NameColumn> names_ = {};
  const char* before_ = "";  // text before the next value of the row
};

/// Returns an object with the radii that were used, and the counts and sizes of each frame.
nlohmann::ordered_json json_of(double probe, const BallRadii& radii, const std::vector<BallTotals>& frames);

/// Returns the lines of the summary: counts, radii, sizes. `noun` names a row, such as "atom" or "point".
std::vector<std::string> text_of(double probe, const BallRadii& radii, const std::vector<BallTotals>& frames,
                                 const std::string& noun);

}  // namespace rbpa::app
