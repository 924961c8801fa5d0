// What: parses the arguments of `rbpa stream`. Each function throws WrongUsage that names the value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shared/point_arguments.h"
#include "stream/request.h"

namespace rbpa::app {

/// Returns the endings of output files for help and messages. `with_meshes` adds the ending of meshes of single tiles.
std::string stream_formats(bool with_meshes = true);

/// Parses a number of bytes, at least least_memory. A suffix K, M, G or T multiplies the number by a power of 1024.
std::uint64_t parse_memory(const std::string& text);

/// Returns the files of points in a folder, sorted by name. If there are LAS files and no --format, text files and
/// pictures are left out, as they may describe the LAS files. Prints, unless quiet, the number and first names of the
/// files that are read, and names of other entries. Throws BadInput if there are no files of points, if formats differ
/// without --format, or if point clouds have a format that is not read; Failure if the folder cannot be read.
std::vector<std::string> files_in(const std::string& folder, const PointArguments& arguments, bool quiet);

/// Parses an output file. The ending of `path` gives its format; if it is unknown, `otherwise` does.
StreamTarget parse_stream_target(const std::string& path, const std::optional<std::string>& otherwise);

}  // namespace rbpa::app
