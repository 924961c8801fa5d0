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

/// Returns the endings of files to write for help and messages: of those of one file, and of meshes of tiles.
std::string stream_formats(bool with_meshes = true);

/// Parses a number of bytes; a suffix K, M, G or T multiplies it by a power of 1024.
std::uint64_t parse_memory(const std::string& text);

/// Returns the files of points in a folder, sorted by name, all of one format. If there are LAS files, these are taken:
/// text files and pictures in the same folder describe tiles. Prints, unless quiet, how many there are and
/// what else is in the folder. Throws BadInput if there are none, or also files of points in another format, read or
/// not.
std::vector<std::string> files_in(const std::string& folder, const PointArguments& arguments, bool quiet);

/// Parses a file to write: its format is that of the ending, else the named one.
StreamTarget parse_stream_target(const std::string& path, const std::optional<std::string>& otherwise);

}  // namespace rbpa::app
