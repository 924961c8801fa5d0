// What: the report that --levels writes: what happened on each level of a hierarchy, and the topology after it.
#pragma once

#include <string>

#include "cli/method.h"
#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "rbpa/hrbpa.h"

namespace rbpa::app {

/// The format by the ending; "-" is CSV. Throws WrongUsage naming the ending, or a method without levels.
Format parse_levels(const std::string& path, const Method& method);

/// CSV: a line for each level under one with the names. JSON: an object with the least radius, the leaf capacity and the
/// levels.
void write_levels(OutputFile& file, Format format, const Hierarchy& hierarchy, const Method& method);

}  // namespace rbpa::app
