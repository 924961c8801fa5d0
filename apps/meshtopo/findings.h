// What: everything a run has to report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "meshops/topology/repair.h"
#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"
#include "meshtopo/geometry.h"

namespace rbpa::app {

struct Findings {
  const MeshFile& mesh;
  meshops::TopologyReport topology;
  std::vector<meshops::SoupDefect> defects;
  std::vector<GeometricDefect> geometric_defects;
  std::optional<std::vector<meshops::RepairStep>> repair = std::nullopt;  ///< none: not requested
};

}  // namespace rbpa::app
