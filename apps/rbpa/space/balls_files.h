// What: the results of `rbpa balls`: rows of atoms, of groups of atoms and of contacts, and reports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/bytes/row_writer.h"
#include "io/cloud/atom_frames.h"
#include "rbpa/space/balls/measure_balls.h"
#include "space/balls_request.h"

namespace rbpa::app {

/// The atoms of a frame, and their measures.
struct MeasuredAtoms {
  std::size_t number;  ///< of the frame, from 1
  std::vector<AtomRow> rows;
  AtomCounts counts;
  std::vector<double> radii;     ///< without the probe
  BallMeasures with_probe = {};  ///< with contacts if they are written
  double volume = 0, area = 0;   ///< without the probe
  std::size_t buried() const;    ///< number of atoms without an area
};

/// Writes rows frame by frame: of atoms or groups, or of contacts between them.
class BallRows {
 public:
  /// Keeps references to `file` and `texts`, the object that all frames were read into. `are_atoms`: points have names
  /// of atoms.
  BallRows(OutputFile& file, Format format, const BallsRequest& request, const AtomFrame& texts, bool are_atoms,
           bool of_contacts);

  void write(const MeasuredAtoms& frame);
  /// Ends the table and the file.
  void finish();

 private:
  std::vector<std::string> columns(const BallsRequest& request) const;
  std::vector<std::string> names(const BallsRequest& request, const std::string& suffix) const;
  void write_names(const AtomRow& atom);
  void write_atoms(const MeasuredAtoms& frame);
  void write_contacts(const MeasuredAtoms& frame);

  OutputFile& file_;
  const AtomFrame& texts_;
  AtomGroups groups_;
  bool has_frames_, are_atoms_, of_contacts_;
  RowWriter row_;
};

/// What the reports have of a frame.
struct BallTotals {
  std::size_t number, kept, buried;
  AtomCounts counts;
  double volume, area, volume_without_probe, area_without_probe;
};

/// What the reports have of a run.
struct BallFacts {
  double probe = 0;
  bool are_atoms = true;
  std::vector<BallTotals> frames = {};
  const BallRadii& radii;
};

/// Returns an object: the radii that were used, and each frame's counts and sizes.
nlohmann::ordered_json json_of(const BallFacts& facts);

/// Returns the lines of the summary: counts, radii, sizes.
std::vector<std::string> text_of(const BallFacts& facts);

}  // namespace rbpa::app
