// What: the report of meshtopo for programs.
#pragma once

#include <string>

#include "meshtopo/findings.h"

namespace rbpa::app {

/// One JSON object: vertices, edges, faces, euler, components, boundary_curves, genus (null where there is none),
/// betti, pinches, isolated, defects, per_component; with a repair also repair, its steps. Nothing is left out, however
/// many.
std::string report_json(const Findings& findings);

}  // namespace rbpa::app
