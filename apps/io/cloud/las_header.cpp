#include "io/cloud/las_header.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "io/cloud/las_fields.h"
#include "io/cloud/units.h"
#include "io/failure.h"
#include "io/number.h"
#include "io/words.h"

namespace rbpa::app {

std::size_t LasCount::settle(bool skip_invalid, const std::string& name, std::vector<std::string>& warnings) const {
  if (claimed_ == room_) return room_;
  const bool too_high = claimed_ > room_;
  if (!skip_invalid)
    bad_input(name, counted(room_, "whole record") + " of " + counted(length_, "byte"),
              std::to_string(claimed_) + " as the header says (--skip-invalid reads " +
                  (too_high        ? "those that are whole)"
                   : claimed_ == 0 ? "all of them)"
                                   : "as many as it counts)"));
  if (takes_all(skip_invalid)) {
    warnings.push_back(
        "the header counts no points, and " +
        (room_ == 1 ? "the whole record after it is" : "all " + std::to_string(room_) + " whole records after it are") +
        " read");
    return room_;
  }
  if (too_high) {
    warnings.push_back(std::to_string(claimed_ - room_) + " of the " + counted(claimed_, "point") +
                       " in the header are left out: the file ends before them");
    return room_;
  }
  const std::size_t more = room_ - claimed_;
  warnings.push_back(counted(more, "whole record") + " after the " + counted(claimed_, "point") + " in the header " +
                     (more == 1 ? "is" : "are") + " left out");
  return claimed_;
}

namespace {

constexpr std::size_t first_header_size = 227, header_size_of_4 = 375;

void require_version(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with("LASF"))
    bad_input(name, in_quotes(bytes.substr(0, 4)), "a LAS file, which begins with 'LASF'");
  if (bytes.size() < first_header_size)
    bad_input(name, counted(bytes.size(), "byte"), "a LAS header, of at least " + std::to_string(first_header_size));
  const unsigned major = load_little<std::uint8_t>(bytes.data() + 24),
                 minor = load_little<std::uint8_t>(bytes.data() + 25);
  if (major != 1 || minor > 4)
    bad_input(name, "LAS version " + std::to_string(major) + "." + std::to_string(minor), "1.0 to 1.4");
}

/// Returns the number of points. Version 1.4 counts in 64 bits; its older 32-bit field is 0 if 32 bits cannot hold the
/// number.
std::size_t point_count(std::string_view bytes, const LasHeader& header) {
  const std::size_t legacy = load_little<std::uint32_t>(bytes.data() + 107);
  if (header.minor < 4 || header.size < header_size_of_4) return legacy;
  const auto count = load_little<std::uint64_t>(bytes.data() + 247);
  return count == 0 ? legacy : count;
}

/// Returns whether the data begin with the signature that version 1.0 has before the points. Some writers count its
/// bytes as bytes of the points.
bool begins_with_signature(std::string_view data) {
  return data.starts_with("\xDD\xCC") || data.starts_with("\xCC\xDD");
}

void find_points(LasHeader& header, std::string_view bytes, std::size_t size, const std::string& name) {
  const std::size_t claimed = point_count(bytes, header);
  const std::size_t begin = load_little<std::uint32_t>(bytes.data() + 96);
  if (begin < header.size || begin > size)
    bad_input(name, "an offset to point data of " + std::to_string(begin),
              "one after the header, from " + std::to_string(header.size) + " to " + std::to_string(size));
  std::size_t left = size - begin;
  header.begin = begin;
  if (header.is_compressed) {
    header.count = {claimed, claimed, header.length};
    return;
  }
  constexpr std::size_t signature = 2;
  const bool is_signed =
      header.minor == 0 && begin <= bytes.size() && begins_with_signature(bytes.substr(begin)) && left >= signature;
  // Count the signature as bytes of the points if the points fit into the file only in this way.
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

}  // namespace

LasHeader read_las_header(std::string_view bytes, std::size_t size, const std::string& name) {
  require_version(bytes, name);
  const char* at = bytes.data();
  LasHeader header{};
  header.minor = load_little<std::uint8_t>(at + 25);
  header.size = load_little<std::uint16_t>(at + 94);
  if (header.size < first_header_size || header.size > size)
    bad_input(name, "a header size of " + std::to_string(header.size),
              "from " + std::to_string(first_header_size) + " to the size of the file, " + std::to_string(size));
  header.records = load_little<std::uint32_t>(at + 100);
  constexpr unsigned compressed = 0xC0U;  // bits that LASzip sets
  header.is_compressed = (load_little<std::uint8_t>(at + 104) & compressed) != 0;
  const unsigned format = load_little<std::uint8_t>(at + 104) & ~compressed;
  if (format > last_las_format)
    bad_input(name, "point format " + std::to_string(format), "a format from 0 to " + std::to_string(last_las_format));
  header.format = format;
  header.length = load_little<std::uint16_t>(at + 105);
  if (header.length < las_record_size(format))
    bad_input(name, "point records of " + counted(header.length, "byte"),
              "at least " + std::to_string(las_record_size(format)) + " of point format " + std::to_string(format));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.scale[axis] = load_little<double>(at + 131 + 8 * axis);
    header.offset[axis] = load_little<double>(at + 155 + 8 * axis);
  }
  for (const std::size_t axis : {0U, 1U}) require_las_axis(header, axis, name);
  if (header.minor >= 4 && header.size >= header_size_of_4) {
    header.extended_begin = load_little<std::uint64_t>(at + 235);
    header.extended_records = load_little<std::uint32_t>(at + 243);
  }
  constexpr std::size_t has_waveforms = 235;
  if (header.minor >= 3 && header.size >= has_waveforms) header.waveforms = load_little<std::uint64_t>(at + 227);
  find_points(header, bytes, size, name);
  return header;
}

void require_las_axis(const LasHeader& header, std::size_t axis, const std::string& name) {
  const double scale = header.scale[axis], offset = header.offset[axis];
  const std::string of_axis = std::string(" for ") + "xyz"[axis];
  if (!std::isfinite(scale) || scale == 0)
    bad_input(name, "a scale of " + in_quotes(text_of(scale)) + of_axis, "a finite number other than 0");
  if (!std::isfinite(offset))
    bad_input(name, "an offset of " + in_quotes(text_of(offset)) + of_axis, "a finite number");
}

namespace {

/// The coordinate systems that the records name. Well-known text is newer and more precise than GeoTIFF keys.
struct Found {
  std::optional<LasCrs> text = std::nullopt, keys = std::nullopt;
};

LasCrs named(const std::optional<Crs>& crs) {
  return {crs,
          crs ? "" : "the system of coordinates has no EPSG code and is not carried over (--crs EPSG:CODE names it)"};
}

constexpr unsigned metre = 9001, foot = 9002, us_survey_foot = 9003;

std::string text_of_unit(unsigned unit) {
  if (unit == metre) return "meters";
  if (unit == foot) return "feet";
  return unit == us_survey_foot ? "US survey feet" : "another unit, number " + std::to_string(unit) + " of EPSG";
}

/// Returns the system if `unit`, EPSG's number of a unit, is the unit of the system, and a warning otherwise: some
/// writers name a system in meters together with feet as the unit. Returns the system also if its unit cannot be
/// compared: `unit` is 0, or the system has no EPSG code.
LasCrs in_unit(const std::optional<Crs>& crs, unsigned unit) {
  const bool is_of_epsg = crs && crs->authority == "EPSG";
  const auto code = static_cast<unsigned>(is_of_epsg ? parse_count(crs->code).value_or(0) : 0);
  const unsigned own = feet_of_epsg(code).value_or(metre);
  if (code == 0 || unit == 0 || unit == own) return named(crs);
  return {std::nullopt, "the system of coordinates is " + crs->text() + ", which is in " + text_of_unit(own) +
                            ", but the file names " + text_of_unit(unit) +
                            ", and it is not carried over (--crs EPSG:CODE " + "names the right one, --crs " +
                            crs->text() + " takes this one nevertheless)"};
}

/// Returns EPSG's code of the unit that is `factor` meters; 0 if it is neither a meter nor a foot.
unsigned unit_of_factor(double factor) {
  constexpr double places = 1e8;  // these digits distinguish both kinds of feet; few texts have more
  const auto is = [&](double known) { return std::round(factor * places) == std::round(known * places); };
  if (is(1)) return metre;
  if (is(0.3048)) return foot;
  return is(1200. / 3937) ? us_survey_foot : 0;
}

LasCrs crs_of_text(std::string_view text) {
  const std::optional<double> factor = unit_of_wkt(text);
  return in_unit(crs_of_wkt(text), factor ? unit_of_factor(*factor) : 0);
}

/// Returns the coordinate system that GeoTIFF keys name. `data` has four numbers, the last of them the number of keys,
/// and then four numbers for each key.
LasCrs crs_of_keys(std::string_view data) {
  constexpr std::size_t entry = 8;
  const auto number = [&](std::size_t i, std::size_t k) {
    return load_little<std::uint16_t>(data.data() + i * entry + 2 * k);
  };
  if (data.size() < entry) return {};
  const std::size_t keys = std::min<std::size_t>(number(0, 3), data.size() / entry - 1);
  unsigned model = 0, geographic = 0, projected = 0, unit = 0;
  for (std::size_t i = 1; i <= keys; ++i) {
    if (number(i, 1) != 0) continue;  // skip texts and doubles, whose values are elsewhere
    if (number(i, 0) == 1024) model = number(i, 3);
    if (number(i, 0) == 2048) geographic = number(i, 3);
    if (number(i, 0) == 3072) projected = number(i, 3);
    if (number(i, 0) == 3076) unit = number(i, 3);
  }
  constexpr unsigned of_the_user = 32767, model_projected = 1, model_geographic = 2;
  const auto is_code = [](unsigned code) { return code > 0 && code < of_the_user; };
  const bool is_projected = is_code(projected) && model != model_geographic;
  if (!is_projected && (!is_code(geographic) || model == model_projected || projected != 0)) return named(std::nullopt);
  const std::string name = "EPSG:" + std::to_string(is_projected ? projected : geographic);
  std::optional<Crs> crs = crs_of_name(name);
  if (!crs) return {std::nullopt, warning_on_crs(name)};
  if (is_projected) return in_unit(crs, unit);
  crs->degrees = true;
  return named(crs);
}

std::string_view without_zeros(std::string_view text) { return text.substr(0, std::min(text.find('\0'), text.size())); }

void take_note(Found& found, std::string_view user, unsigned number, std::string_view data) {
  if (user != "LASF_Projection") return;
  if (number == 2112) found.text = crs_of_text(without_zeros(data));
  if (number == 34735) found.keys = crs_of_keys(data);
}

/// Calls take(user, number, data) for `count` records from `at` to `end`. The header of a record has reserved bytes
/// (2), user (16), number (2), length (2; 8 in an extended record) and description (32).
template <typename Take>
void visit(std::string_view bytes, std::size_t at, std::size_t end, std::size_t count, bool extended, Take take) {
  const std::size_t frame = extended ? 60 : 54;
  for (std::size_t i = 0; i < count && at <= end && end - at >= frame; ++i) {
    const char* record = bytes.data() + at;
    const std::size_t length =
        extended ? load_little<std::uint64_t>(record + 20) : load_little<std::uint16_t>(record + 20);
    if (length > end - at - frame) return;
    take(without_zeros({record + 2, 16}), load_little<std::uint16_t>(record + 18), bytes.substr(at + frame, length));
    at += frame + length;
  }
}

}  // namespace

std::string_view las_record(std::string_view before, const LasHeader& header, std::string_view user, unsigned number) {
  std::string_view found;
  visit(before, header.size, std::min(header.begin, before.size()), header.records, false,
        [&](std::string_view its_user, unsigned its_number, std::string_view data) {
          if (its_user == user && its_number == number && found.empty()) found = data;
        });
  return found;
}

LasCrs las_crs(std::string_view before, std::string_view behind, const LasHeader& header) {
  Found found;
  const auto take = [&](std::string_view user, unsigned number, std::string_view data) {
    take_note(found, user, number, data);
  };
  visit(before, header.size, std::min(header.begin, before.size()), header.records, false, take);
  visit(behind, 0, behind.size(), header.extended_records, true, take);
  if (found.text && (found.text->crs || !found.keys)) return *found.text;
  return found.keys.value_or(LasCrs{});
}

}  // namespace rbpa::app
