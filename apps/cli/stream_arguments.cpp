#include "cli/stream_arguments.h"

#include <cctype>
#include <cmath>

#include "io/bytes/number.h"
#include "io/failure.h"
#include "io/formats.h"
#include "stream/budget.h"

namespace rbpa::app {
namespace {

std::optional<StreamFormat> stream_format(std::string_view name) {
  if (const auto shape = find_format(Use::shape, name)) {
    if (*shape == Format::geojson) return StreamFormat::geojson;
    if (*shape == Format::wkt) return StreamFormat::wkt;
  }
  if (const auto mesh = find_format(Use::triangles, name)) {
    if (*mesh == Format::npy) return StreamFormat::npy;
    if (*mesh == Format::ply) return StreamFormat::ply;
  }
  return std::nullopt;
}

}  // namespace

std::uint64_t parse_memory(const std::string& text) {
  constexpr std::string_view units = "KMGT";
  std::string digits = text;
  unsigned shift = 0;
  if (!digits.empty() && units.find(static_cast<char>(std::toupper(digits.back()))) != std::string_view::npos) {
    shift = 10 * static_cast<unsigned>(units.find(static_cast<char>(std::toupper(digits.back()))) + 1);
    digits.pop_back();
  }
  const ParsedNumber number = parse_whole_number(digits);
  const double bytes = std::ldexp(number.value, static_cast<int>(shift));
  if (number.fault != NumberFault::none || !(bytes >= static_cast<double>(least_memory)) || bytes > 0x1p60)
    throw WrongUsage("--memory: found " + in_quotes(text) + ", expected a size from " +
                     std::to_string(least_memory >> 20U) + "M on, such as 500M or 1G");
  return static_cast<std::uint64_t>(bytes);
}

StreamTarget parse_stream_target(const std::string& path, const std::optional<std::string>& otherwise) {
  if (path.empty()) throw WrongUsage("-o: found an empty name, expected a path or -");
  std::optional<StreamFormat> format = path == "-" ? std::nullopt : stream_format(ending(path));
  if (!format && otherwise) format = stream_format(*otherwise);
  if (!format && otherwise) refuse_name("--output-format", *otherwise, stream_formats);
  if (!format && path == "-") throw WrongUsage("-o -: found no --output-format, expected geojson, wkt or npy");
  if (!format) refuse_ending(path, stream_formats, "--output-format");
  if (*format == StreamFormat::ply) {
    const std::size_t star = path.rfind('*');
    if (star == std::string::npos || path.find('/', star) != std::string::npos)
      throw WrongUsage(
          path + ": found a mesh of all tiles, expected a name with a '*' for the number of the tile: 'tiles/*.ply'");
  }
  return {path, *format};
}

}  // namespace rbpa::app
