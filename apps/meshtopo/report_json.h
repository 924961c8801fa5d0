// What: the report of meshtopo for programs.
#pragma once

#include "io/bytes/output_file.h"
#include "meshtopo/findings.h"

namespace rbpa::app {

/// One JSON object: vertices, edges, faces, euler, components, boundary_curves, genus (null where there is none),
/// betti, pinches, isolated, defects, geometric_defects, per_component; with a repair also repair, its steps. Nothing is
/// left out, however many. Throws as OutputFile does.
void write_report_json(OutputFile& file, const Findings& findings);

}  // namespace rbpa::app
