// What: defines the facts that a run reports about one mesh.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "meshops/topology/repair.h"
#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"
#include "meshtopo/decimate.h"
#include "meshtopo/edits.h"
#include "meshtopo/fill.h"
#include "meshtopo/geometry.h"
#include "meshtopo/measures.h"
#include "meshtopo/tunnels.h"

namespace rbpa::app {

/// A property that --check requires of a mesh, with or without a number.
struct Check {
  std::string name;
  std::optional<long> number;  ///< the required number; nullopt for a property without a number
};

struct CheckResult {
  Check check;
  bool holds;
  std::string found, expected;  ///< texts for the message
  std::optional<long> number;   ///< the found number; nullopt if there is none, such as an undefined genus
};

struct Examined {
  meshops::TopologyReport topology;
  std::vector<meshops::SoupDefect> defects;
  std::vector<GeometricDefect> geometric_defects;
  Measures measures = {};
  std::size_t crossings = 0;  ///< number of pairs of faces that cross; 0 if no check requires it
};

struct Findings {
  const MeshFile& mesh;
  Examined given;
  std::optional<std::vector<meshops::RepairStep>> repair = std::nullopt;  ///< nullopt if not requested
  EditReport edits = {};
  std::optional<Filled> fill = std::nullopt;            ///< nullopt if not requested
  std::optional<ClosedTunnels> tunnels = std::nullopt;  ///< nullopt if not requested
  std::optional<Decimation> decimated = std::nullopt;   ///< nullopt if not requested
  std::optional<Remeshing> remeshed = std::nullopt;     ///< nullopt if not requested

  std::optional<Subdivided> subdivided = std::nullopt;  ///< nullopt if not requested

  bool has_changes() const { return edits.any() || fill || tunnels || decimated || remeshed || subdivided; }

  std::optional<Examined> result = std::nullopt;  ///< facts about the resulting mesh; nullopt if nothing requires them
  std::vector<CheckResult> checks = {};
};

}  // namespace rbpa::app
