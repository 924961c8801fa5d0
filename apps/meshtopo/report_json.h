// What: writes the report of meshtopo as JSON, for programs.
#pragma once

#include <string>

#include "io/bytes/output_file.h"
#include "meshtopo/findings.h"

namespace rbpa::app {

/// Writes one JSON object: vertices, edges, faces, euler, components, boundary_curves, genus (null if there is none),
/// betti, pinches, isolated, defects, geometric_defects, area, volume and box (null if there is none),
/// per_component; after a repair also repair, its steps; after edits also changes and result; with checks also checks.
/// Lists are complete. If `name`, that of the mesh, is not empty, "file" comes first. Throws as OutputFile.
void write_report_json(OutputFile& file, const Findings& findings, const std::string& name = "");

/// Writes the JSON object for a mesh that could not be read: "file" and "error".
void write_error_json(OutputFile& file, const std::string& name, const std::string& error);

}  // namespace rbpa::app
