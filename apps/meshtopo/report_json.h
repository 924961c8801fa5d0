// What: the report of meshtopo for programs.
#pragma once

#include <string>

#include "io/bytes/output_file.h"
#include "meshtopo/findings.h"

namespace rbpa::app {

/// One JSON object: vertices, edges, faces, euler, components, boundary_curves, genus (null where there is none),
/// betti, pinches, isolated, defects, geometric_defects, area, volume and box (null where there is none),
/// per_component; with a repair also repair, its steps; with edits also changes and result; with checks also checks.
/// Nothing is left out, however many. With a `name` of the mesh, which is not empty, "file" comes first. Throws as
/// OutputFile does.
void write_report_json(OutputFile& file, const Findings& findings, const std::string& name = "");

/// The same of a mesh that could not be read: "file" and "error".
void write_error_json(OutputFile& file, const std::string& name, const std::string& error);

}  // namespace rbpa::app
