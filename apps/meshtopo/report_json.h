// What: writes the report of meshtopo as JSON, for programs.
#pragma once

#include <string>

#include "io/bytes/output_file.h"
#include "meshtopo/findings.h"

namespace rbpa::app {

/// Writes one JSON object: vertices, edges, faces, euler, components, boundary_curves, genus (null if there is none),
/// betti, pinches, isolated, defects, geometric_defects, area, volume and box (null if there is none), per_component;
/// after a repair also repair, with its steps; after edits also changes and result; with checks also checks. Lists are
/// complete. If `name`, the name of the mesh, is not empty, "file" is the first member. Throws as OutputFile::write().
void write_report_json(OutputFile& file, const Findings& findings, const std::string& name = "");

/// Writes the JSON object for a mesh that could not be read, with the members "file", `name`, and "error", `error`.
/// Throws as OutputFile::write().
void write_error_json(OutputFile& file, const std::string& name, const std::string& error);

}  // namespace rbpa::app
