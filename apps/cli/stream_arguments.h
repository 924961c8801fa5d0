// What: what the verbs about tiles have in common on the command line. Each throws WrongUsage naming the value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/point_arguments.h"
#include "stream/request.h"

namespace rbpa::app {

constexpr std::string_view stream_formats = "geojson, json, wkt, npy, or ply where the name has a '*'";

/// A number of bytes, with K, M, G or T behind it for powers of 1024.
std::uint64_t parse_memory(const std::string& text);

/// The files of points in a folder, sorted by name: those of one format, and of LAS where there are some, as what lies beside tiles is
/// about them. Says, unless quiet, which these are, and what else is in the folder.
/// Throws BadInput where there are none, or others that are points, too: of several formats, or of one that is not read.
std::vector<std::string> files_in(const std::string& folder, const PointArguments& arguments, bool quiet);

/// By the ending of the path, else by the name of a format.
StreamTarget parse_stream_target(const std::string& path, const std::optional<std::string>& otherwise);

}  // namespace rbpa::app
