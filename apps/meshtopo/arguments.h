// What: parses the command line of `meshtopo`.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "meshtopo/edits.h"
#include "meshtopo/findings.h"
#include "triangulation/choices.h"

namespace rbpa::app {

/// The arguments of the command line as texts.
struct TopologyArguments {
  std::vector<std::string> meshes;
  std::optional<std::string> format;
  bool json = false;
  std::optional<std::string> output;
  std::optional<std::string> output_format;
  std::optional<std::string> shift;
  std::optional<std::string> weld;
  std::optional<std::string> keep_largest;
  std::optional<std::string> drop_small;
  bool orient = false;
  std::optional<std::string> fill_holes;
  std::optional<std::string> close_tunnels_below;
  std::optional<std::string> decimate;
  std::optional<std::string> remesh;
  std::optional<std::string> subdivide;
  bool no_crossings = false;
  std::optional<std::string> progressive;
  std::optional<std::string> at_faces;
  bool repair = false;
  std::string repaired;  ///< path OUT of --repair; empty if -o names the mesh
  std::optional<std::string> generators;
  bool shortest = false;
  std::vector<std::string> checks;  ///< comma-separated lists of properties
  std::string max_defects = "20";
  bool quiet = false;
};

/// A file to write. The format of a report is text or json.
struct TopologyTarget {
  std::string path;  ///< "-" means standard output
  Format format;
};

/// The inputs, actions and outputs of a run.
struct TopologyPlan {
  std::vector<MeshSource> sources;  ///< if there are several, only a report is written
  std::size_t max_defects;
  bool quiet;  ///< print neither progress nor the text report
  std::vector<Check> checks = {};
  Edits edits = {};
  bool repair = false;
  std::optional<HoleChoice> fill = std::nullopt;
  std::optional<double> tunnels_below = std::nullopt;
  std::optional<DecimationOptions> decimate = std::nullopt;
  std::optional<std::size_t> at_faces = std::nullopt;     ///< the meshes are progressive, and are read at this number
  std::optional<std::string> progressive = std::nullopt;  ///< file for the progressive mesh of a decimation
  std::optional<RemeshOptions> remesh = std::nullopt;     ///< length and error
  std::optional<SubdivisionOptions> subdivide = std::nullopt;
  std::optional<TopologyTarget> report = std::nullopt;
  std::optional<TopologyTarget> written = std::nullopt;  ///< file for the mesh after all edits and repairs
  std::optional<Shift> shift = std::nullopt;             ///< vector to subtract from the positions in STL
  std::optional<TopologyTarget> generators = std::nullopt;
  bool shortest = false;  ///< write a basis of the least total length

  /// Returns whether an option other than --repair changes the mesh.
  bool changes() const { return edits.any() || fill || tunnels_below || decimate || remesh || subdivide; }
  /// Returns the paths of the outputs that are written, in this order: progressive mesh, mesh, generators, report.
  std::vector<std::string> outputs() const;
};

/// Parses and checks the arguments. Throws WrongUsage that names the option or the value.
TopologyPlan plan(TopologyArguments arguments);

}  // namespace rbpa::app
