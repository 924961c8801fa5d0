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

/// Returns the endings of files to write, for help and messages; `with_meshes` adds that of meshes of single tiles.
std::string stream_formats(bool with_meshes = true);

/// Parses a number of bytes; a suffix K, M, G or T multiplies it by a power of 1024.
std::uint64_t parse_memory(const std::string& text);

/// Returns the files of points in a folder, sorted by name, all of one format. If there are LAS files and no --format,
/// text files and pictures are left out, as they may describe the LAS files. Prints, unless quiet, how many files are
/// read and which are not. Throws BadInput if there are no files of points, if their formats differ, or if there are
/// point clouds in a format that is not read; Failure if the folder cannot be read.
std::vector<std::string> files_in(const std::string& folder, const PointArguments& arguments, bool quiet);

/// Parses a file to write: its format is that of the ending of `path`, else `otherwise`.
StreamTarget parse_stream_target(const std::string& path, const std::optional<std::string>& otherwise);

}  // namespace rbpa::app
