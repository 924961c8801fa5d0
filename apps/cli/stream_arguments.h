// What: what the verbs about tiles have in common on the command line. Each throws WrongUsage naming the value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "stream/request.h"

namespace rbpa::app {

constexpr std::string_view stream_formats = "geojson, json, wkt, npy, or ply where the name has a '*'";

/// A number of bytes, with K, M, G or T behind it for powers of 1024.
std::uint64_t parse_memory(const std::string& text);

/// By the ending of the path, else by the name of a format.
StreamTarget parse_stream_target(const std::string& path, const std::optional<std::string>& otherwise);

}  // namespace rbpa::app
