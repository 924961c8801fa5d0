// What: everything a run has to report of one mesh.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "meshops/topology/repair.h"
#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"
#include "meshtopo/edits.h"
#include "meshtopo/fill.h"
#include "meshtopo/geometry.h"
#include "meshtopo/measures.h"
#include "meshtopo/tunnels.h"

namespace rbpa::app {

/// A property that holds or not, or one that is a number.
struct Check {
  std::string name;
  std::optional<long> number;  ///< absent: holds or not
};

struct CheckResult {
  Check check;
  bool holds;
  std::string found, expected;  ///< in words
  std::optional<long> number;   ///< found; absent where there is none, such as the genus of what is not orientable
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
  std::optional<std::vector<meshops::RepairStep>> repair = std::nullopt;  ///< none: not requested
  EditReport edits = {};
  std::optional<Filled> fill = std::nullopt;            ///< none: not requested
  std::optional<ClosedTunnels> tunnels = std::nullopt;  ///< the same

  bool has_changes() const { return edits.any() || fill || tunnels; }

  std::optional<Examined> result = std::nullopt;  ///< of the mesh that comes out, where it is not the one given
  std::vector<CheckResult> checks = {};
};

}  // namespace rbpa::app
