#include "io/las/las_header.h"

#include <algorithm>
#include <cmath>

#include "io/claim.h"
#include "io/failure.h"
#include "io/las/las_fields.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

constexpr std::size_t first_header_size = 227, header_size_of_4 = 375;

void require_version(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with("LASF"))
    bad_input(name, in_quotes(bytes.substr(0, 4)), "a LAS file, which begins with 'LASF'");
  if (bytes.size() < first_header_size)
    bad_input(name, counted(bytes.size(), "byte"), "a LAS header, of at least " + std::to_string(first_header_size));
  const unsigned major = las_value<std::uint8_t>(bytes.data() + 24), minor = las_value<std::uint8_t>(bytes.data() + 25);
  if (major != 1 || minor > 4)
    bad_input(name, "LAS version " + std::to_string(major) + "." + std::to_string(minor), "1.0 to 1.4");
}

/// How many points there are. Version 1.4 counts beyond 32 bits, and leaves the older place zero where it cannot.
std::size_t point_count(std::string_view bytes, const LasHeader& header) {
  const std::size_t legacy = las_value<std::uint32_t>(bytes.data() + 107);
  if (header.minor < 4 || header.size < header_size_of_4) return legacy;
  const auto count = las_value<std::uint64_t>(bytes.data() + 247);
  return count == 0 ? legacy : count;
}

/// Version 1.0 has a signature before the points. Some writers count it among them.
bool begins_with_signature(std::string_view data) {
  return data.starts_with("\xDD\xCC") || data.starts_with("\xCC\xDD");
}

void find_points(LasHeader& header, std::string_view bytes, std::size_t size, const std::string& name) {
  const std::size_t claimed = point_count(bytes, header);
  const std::size_t begin = las_value<std::uint32_t>(bytes.data() + 96);
  if (begin < header.size || begin > size)
    bad_input(name, "an offset to point data of " + std::to_string(begin),
              "one behind the header, from " + std::to_string(header.size) + " to " + std::to_string(size));
  std::size_t left = size - begin;
  header.begin = begin;
  constexpr std::size_t signature = 2;
  const bool is_signed =
      header.minor == 0 && begin <= bytes.size() && begins_with_signature(bytes.substr(begin)) && left >= signature;
  // It is counted among them where only so they fit.
  const bool fits_only_with_it = claimed <= left / header.length && claimed > (left - signature) / header.length;
  if (is_signed && !fits_only_with_it) {
    header.begin += signature;
    left -= signature;
  }
  const std::size_t whole = left / header.length;
  const auto ends_at = [&](std::size_t at) {
    if (at >= header.begin && at <= size && (at - header.begin) / header.length >= claimed) left = at - header.begin;
  };
  if (header.extended_records > 0) ends_at(header.extended_begin);
  ends_at(header.waveforms);
  header.count = {claimed, std::min(whole, left / header.length), header.length};
}

/// Of so many extended variable length records, as far as they are there: each begins with its length.
double end_of_extended(std::string_view first, std::size_t begin, std::size_t records) {
  constexpr double header_size = 60;
  auto end = static_cast<double>(begin);
  for (; records > 0 && end + header_size <= static_cast<double>(first.size()); --records)
    end +=
        header_size + static_cast<double>(las_value<std::uint64_t>(first.data() + static_cast<std::size_t>(end) + 20));
  return end + header_size * static_cast<double>(records);
}

}  // namespace

LasHeader read_las_header(std::string_view bytes, const std::string& name) {
  return read_las_header(bytes, bytes.size(), name);
}

LasHeader read_las_header(std::string_view bytes, std::size_t size, const std::string& name) {
  require_version(bytes, name);
  const char* at = bytes.data();
  LasHeader header{};
  header.minor = las_value<std::uint8_t>(at + 25);
  header.size = las_value<std::uint16_t>(at + 94);
  if (header.size < first_header_size || header.size > size)
    bad_input(name, "a header size of " + std::to_string(header.size),
              "from " + std::to_string(first_header_size) + " to the size of the file, " + std::to_string(size));
  header.records = las_value<std::uint32_t>(at + 100);
  const unsigned format = las_value<std::uint8_t>(at + 104);
  constexpr unsigned compressed = 0xC0U;  // bits that LASzip sets
  if ((format & compressed) != 0)
    bad_input(name, "LAZ, which is compressed",
              "LAS (pdal translate FILE points.las, or las2las -i FILE -o points.las)");
  if (format > last_las_format)
    bad_input(name, "point format " + std::to_string(format), "0 to " + std::to_string(last_las_format));
  header.format = format;
  header.length = las_value<std::uint16_t>(at + 105);
  if (header.length < las_record_size(format))
    bad_input(name, "point records of " + counted(header.length, "byte"),
              "at least " + std::to_string(las_record_size(format)) + " of point format " + std::to_string(format));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.scale[axis] = las_value<double>(at + 131 + 8 * axis);
    header.offset[axis] = las_value<double>(at + 155 + 8 * axis);
  }
  for (const std::size_t axis : {0U, 1U}) require_las_axis(header, axis, name);
  if (header.minor >= 4 && header.size >= header_size_of_4) {
    header.extended_begin = las_value<std::uint64_t>(at + 235);
    header.extended_records = las_value<std::uint32_t>(at + 243);
  }
  constexpr std::size_t has_waveforms = 235;
  if (header.minor >= 3 && header.size >= has_waveforms) header.waveforms = las_value<std::uint64_t>(at + 227);
  find_points(header, bytes, size, name);
  return header;
}

double claimed_las_size(std::string_view first, const std::string& name) {
  const LasHeader header = read_las_header(first, unknown_size, name);
  const double points = static_cast<double>(header.begin) +
                        static_cast<double>(header.count.sought(false)) * static_cast<double>(header.length);
  const double waveforms = header.waveforms == 0 ? 0 : end_of_extended(first, header.waveforms, 1);
  return std::max({points, waveforms, end_of_extended(first, header.extended_begin, header.extended_records)});
}

void require_las_axis(const LasHeader& header, std::size_t axis, const std::string& name) {
  const double scale = header.scale[axis], offset = header.offset[axis];
  if (!std::isfinite(scale) || scale == 0)
    bad_input(name, "a scale of " + in_quotes(ShortestText(scale)), "a finite number other than 0");
  if (!std::isfinite(offset)) bad_input(name, "an offset of " + in_quotes(ShortestText(offset)), "a finite number");
}

}  // namespace rbpa::app
