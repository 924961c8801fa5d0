#include "io/polygon/read_polygons.h"

#include <algorithm>
#include <array>

#include "io/bytes/input_bytes.h"
#include "io/failure.h"
#include "io/number.h"
#include "io/polygon/read_geojson.h"
#include "io/polygon/wkt.h"
#include "io/text/fields.h"
#include "io/text/lines.h"
#include "io/text/plain_text.h"
#include "io/text/signature.h"

namespace rbpa::app {
namespace {

PolygonFile parse(std::string_view bytes, const std::string& name, Format format) {
  if (format == Format::geojson) return read_geojson_polygons(bytes, name);
  if (format == Format::wkt) return read_wkt_polygons(bytes, name);
  return read_poly_polygons(bytes, name);
}

}  // namespace

PolygonFile read_polygons(const std::string& path, Format format) {
  const InputBytes input(path, "a file of polygons");
  if (input.bytes().empty()) bad_input(input.name(), "an empty file", "polygons");
  if (format == Format::by_content)
    format = format_of_content(Use::polygons, input.bytes(), input.name(), std::nullopt);
  std::string room;
  return reading_as(Use::polygons, format, input.bytes(),
                    [&] { return parse(plain_text(input.bytes(), input.name(), format, room), input.name(), format); });
}

namespace {

/// Returns the words of a line, which blanks, commas or semicolons separate.
std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view separators = " \t,;";
  std::vector<std::string_view> words;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(separators), line.size()));
    if (line.empty()) return words;
    const std::size_t size = std::min(line.find_first_of(separators), line.size());
    words.push_back(line.substr(0, size));
    line.remove_prefix(size);
  }
}

}  // namespace

std::vector<SizeAt> read_sizes(const std::string& path) {
  const InputBytes input(path, "a file of sizes");
  std::vector<SizeAt> sizes;
  std::string room;
  Lines lines(plain_text(input.bytes(), input.name(), room));
  for (bool is_first = true; lines.next_with_content(); is_first = false) {
    const std::vector<std::string_view> words = words_of(lines.line());
    const std::string where = at_line(input.name(), lines.number());
    if (words.size() != 3) bad_input(where, counted(words.size(), "value"), "three: x, y and size");
    if (is_first && std::none_of(words.begin(), words.end(), is_nearly_number)) continue;  // skip a header
    std::array<double, 3> value{};
    for (std::size_t i = 0; i < 3; ++i) {
      const ParsedNumber number = parse_written_number(words[i]);
      if (number.fault != NumberFault::none) bad_input(where, in_quotes(words[i]), expected_instead(number.fault));
      value[i] = number.value;
    }
    if (!(value[2] > 0)) bad_input(where, "the size " + std::string(words[2]), "a size above 0");
    sizes.push_back({{value[0], value[1]}, value[2]});
  }
  if (sizes.empty()) bad_input(input.name(), "no size", "lines of x, y and size");
  return sizes;
}

}  // namespace rbpa::app
