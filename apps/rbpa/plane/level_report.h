// What: writes the report of --levels: triangles made on each level of a hierarchy, and the topology after the level.
#pragma once

#include <string>

#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "rbpa/hrbpa.h"
#include "shared/method.h"

namespace rbpa::app {

/// Returns the format of --levels, given by the ending of `path`; "-" is CSV. Throws WrongUsage if the ending is
/// unknown or `method` has no levels.
Format parse_levels(const std::string& path, const Method& method);

/// Writes CSV, with a header and a line for each level, or JSON, an object with the least radius, the leaf capacity and
/// a list of the levels.
void write_levels(OutputFile& file, Format format, const Hierarchy& hierarchy, const Method& method);

}  // namespace rbpa::app
