// Readers of points: any bytes are either points, all finite, or refused in a sentence of one line.
// The first byte is the format and how it is read; the rest is the file.
#include <zlib.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "fuzz/sentence.h"
#include "fuzz/target.h"
#include "io/bytes/gunzip.h"
#include "io/cloud/las_fields.h"
#include "io/cloud/read_points.h"
#include "io/failure.h"

namespace {

using namespace rbpa::app;

constexpr Format formats[] = {Format::text, Format::npy, Format::off, Format::ply,
                              Format::raw,  Format::png, Format::pgm};

constexpr std::size_t ways = 4;  // ways in which each format is read

/// Returns the source for formats that were added later, each with its options; the selectors below keep their meaning.
PointSource later_source_of(std::size_t selector) {
  PointSource source{.path = ""};
  source.vertices = selector % 2 == 1;
  source.skip_invalid = selector % 4 > 1;
  switch (selector / 4 % 4) {
    case 0:
      source.format = Format::las;
      source.skip_invalid = source.vertices = false;
      if (selector % 4 == 1)
        source.where = Condition("classification == 2 or x < 0 and not withheld", names_of_las_fields());
      if (selector % 4 == 2) source.where = Condition("gps_time > 1 or red > 1", names_of_las_fields());
      break;
    case 1:
      source.format = Format::geojson;
      break;
    case 2:
      source.format = Format::wkt;
      break;
    default:
      source.shift_longitude = selector % 8 > 5;
      if (selector % 8 == 5) source.where = Condition("class > 1 or not x == 2", names_of_columns());
      break;
  }
  return source;
}

PointSource source_of(std::uint8_t selector) {
  if (selector >= ways * std::size(formats)) return later_source_of(selector - ways * std::size(formats));
  PointSource source{.path = "", .format = formats[selector % std::size(formats)]};
  switch (selector / std::size(formats) % ways) {
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
  std::string_view compressed = bytes;
  for (Gunzip gunzip(name); !compressed.empty();) gunzip.inflate(compressed, text.data(), text.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const PointSource source = source_of(data[0]);
  std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  if (source.format == Format::png) bytes = with_check_sums(bytes);
  try {
    constexpr std::uint8_t gzip_selector = 255, condition_selector = 254;
    if (data[0] >= condition_selector) {
      read_before(data[0] == gzip_selector, bytes);
      return 0;
    }
    const std::vector<rbpa::Point> points = points_in(bytes, "FILE", source).points;
    fuzz::require(std::all_of(points.begin(), points.end(), rbpa::is_finite), "points are finite");
  } catch (const BadInput& refusal) {
    fuzz::is_a_sentence(refusal.what());
  } catch (const WrongUsage& refusal) {
    fuzz::is_a_sentence(refusal.what());
  }
  return 0;
}
