// What: the facts that a run reports about one mesh.
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

/// A required property, or a required number.
struct Check {
  std::string name;
  std::optional<long> number;  ///< the required number; absent for a property
};

struct CheckResult {
  Check check;
  bool holds;
  std::string found, expected;  ///< texts for the message
  std::optional<long> number;   ///< the found number; absent if there is none, such as an undefined genus
};

struct Examined {
  meshops::TopologyReport topology;
  std::vector<meshops::SoupDefect> defects;
  std::vector<GeometricDefect> geometric_defects;
  Measures measures = {};
};

struct Findings {
  const MeshFile& mesh;
  Examined given;
  std::optional<std::vector<meshops::RepairStep>> repair = std::nullopt;  ///< absent if not requested
  EditReport edits = {};
  std::optional<Filled> fill = std::nullopt;            ///< absent if not requested
  std::optional<ClosedTunnels> tunnels = std::nullopt;  ///< absent if not requested
  std::optional<Decimation> decimated = std::nullopt;   ///< absent if not requested
  std::optional<Remeshing> remeshed = std::nullopt;     ///< absent if not requested

  bool has_changes() const { return edits.any() || fill || tunnels || decimated || remeshed; }

  std::optional<Examined> result = std::nullopt;  ///< facts about the resulting mesh; absent if it is the given mesh
  std::vector<CheckResult> checks = {};
};

}  // namespace rbpa::app
