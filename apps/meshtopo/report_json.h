// What: writes the report of meshtopo as JSON, for programs.
#pragma once

#include <string>

#include "io/bytes/output_file.h"
#include "meshtopo/findings.h"

namespace rbpa::app {

/// Writes one JSON object with the members vertices, edges, faces, euler, components, boundary_curves, genus (null if
/// undefined), betti, pinches, isolated, defects, geometric_defects, area, volume (null if undefined), box (null if
/// there is none), per_component. A repair adds repair, its steps; other changes add changes and result; a repair with
/// checks also adds result; checks add checks. Lists are complete. If `name`, the name of the mesh, is not empty,
/// "file" is the first member. Throws as OutputFile::write() does; Cancelled.
void write_report_json(OutputFile& file, const Findings& findings, const std::string& name = "");

/// Writes the JSON object for a mesh that cannot be read, with the members "file" (`name`) and "error" (`error`).
/// Throws as OutputFile::write() does.
void write_error_json(OutputFile& file, const std::string& name, const std::string& error);

}  // namespace rbpa::app
