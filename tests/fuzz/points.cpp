// Readers of points: any bytes are either points, all finite, or refused in a sentence of one line.
// format_of_input.h says how an input names its format.
#include <zlib.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "fuzz/format_of_input.h"
#include "fuzz/sentence.h"
#include "fuzz/target.h"
#include "io/bytes/gunzip.h"
#include "io/cloud/las_fields.h"
#include "io/cloud/read_points.h"
#include "io/failure.h"

namespace {

using namespace rbpa::app;

PointSource source_of(Format format, unsigned options) {
  PointSource source{.path = "", .format = format};
  switch (options % 4) {
    case 1:
      source.columns = std::vector<Column>{{.number = 2}, {.number = 1}};
      source.pixels = {.foreground = Foreground::dark};
      break;
    case 2:
      source.columns = std::vector<Column>{{.name = "x"}, {.name = "y"}};
      source.pixels = {.foreground = Foreground::light, .threshold = 0.25};
      break;
    case 3:
      source.columns = std::vector<Column>{{.number = 3}, {.name = "lat"}};
      source.pixels = {.threshold = 1};
      break;
    default:
      break;
  }
  source.vertices = (options & 4U) != 0;
  source.skip_invalid = (options & 8U) != 0;
  if ((options & 16U) != 0)
    source.where = is_las(format) ? fuzz::condition_of(format, {"classification == 2 or x < 0 and not withheld"})
                                  : fuzz::condition_of(format, {"class > 1 or not x == 2", "x > 1 or not y == 2"});
  if ((options & 32U) != 0) source.where = fuzz::condition_of(format, {"gps_time > 1 or red > 1"});
  source.shift_longitude = (options & 64U) != 0;
  if ((options & 128U) != 0) source.window = fuzz::window();
  if ((options & 2U) != 0) source.keeps.emplace();
  return source;
}

std::size_t number_at(const std::string& bytes, std::size_t at) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8U | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

/// Returns the bytes with the check sum of every chunk corrected; otherwise nearly all inputs would be refused there.
std::string with_check_sums(std::string_view bytes) {
  std::string png(bytes);
  constexpr std::size_t signature = 8, frame = 12;  // length, type, check sum
  for (std::size_t at = signature; at + frame <= png.size();) {
    const std::size_t length = number_at(png, at);
    if (length > png.size() - at - frame) break;
    const auto* type = reinterpret_cast<const Bytef*>(png.data() + at + 4);
    const uLong sum = crc32(0, type, static_cast<uInt>(length + 4));
    for (std::size_t i = 0; i < 4; ++i) png[at + 8 + length + i] = static_cast<char>(sum >> (24 - 8 * i) & 0xFFU);
    at += frame + length;
  }
  return png;
}

/// Runs the readers that come before points: decompression, and the condition of a command line.
void read_before(bool compressed, const std::string& bytes) {
  if (!compressed) {
    for (const FieldNames& names : {names_of_columns(), names_of_las_fields()}) {
      try {
        const Condition condition(bytes, names);
      } catch (const WrongUsage& refusal) {
        fuzz::is_a_sentence(refusal.what());
      }
    }
    return;
  }
  const std::string name = "FILE";
  std::string text(1U << 20U, '\0');
  std::string_view rest = bytes;
  for (Gunzip gunzip(name); !rest.empty();) gunzip.inflate(rest, text.data(), text.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto file = fuzz::divided({reinterpret_cast<const char*>(data), size});
  if (!file) return 0;
  try {
    if (file->ending == "gzip" || file->ending == "condition") {
      read_before(file->ending == "gzip", file->bytes);
      return 0;
    }
    const std::optional<Format> format = find_format(Use::points, file->ending);
    if (!format || *format == Format::ogr) return 0;  // GDAL reads files only
    if (format == Format::png) file->bytes = with_check_sums(file->bytes);
    const PointSource source = source_of(*format, file->options);
    const PointFile found = points_in(file->bytes, "FILE", source);
    fuzz::require(
        std::all_of(found.points.begin(), found.points.end(), [](const rbpa::Point& p) { return is_finite(p); }),
        "points are finite");
    fuzz::has_all_values(found.kept, found.points.size());
  } catch (const BadInput& refusal) {
    fuzz::is_a_sentence(refusal.what());
  } catch (const WrongUsage& refusal) {
    fuzz::is_a_sentence(refusal.what());
  }
  return 0;
}
