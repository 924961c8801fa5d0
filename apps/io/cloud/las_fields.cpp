#include "io/cloud/las_fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>

#include "io/failure.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

/// The offsets of the optional fields in a record, which follow the fields that all formats of a family have.
struct FieldLayout {
  std::size_t size;
  std::size_t time = 0, color = 0, infrared = 0;  // 0: there is none
};
constexpr FieldLayout layouts[last_las_format + 1] = {
    {20},              // 0
    {28, 20},          // 1
    {26, 0, 20},       // 2
    {34, 20, 28},      // 3
    {57, 20},          // 4: 1 and wave packets
    {63, 20, 28},      // 5: 3 and wave packets
    {30, 22},          // 6
    {36, 22, 30},      // 7
    {38, 22, 30, 36},  // 8
    {59, 22},          // 9: 6 and wave packets
    {67, 22, 30, 36},  // 10: 8 and wave packets
};
constexpr unsigned first_of_new_family = 6;

enum class Since { any, version_1_1, new_family };

/// A field and its place in each family of formats; with `behind`, the place relative to the offset that `behind`
/// names.
struct Known {
  std::string_view name;
  LasField old_family, new_family;
  Since since = Since::any;
  std::size_t FieldLayout::*behind = nullptr;
};
constexpr Scalar u8 = Scalar::uint8, u16 = Scalar::uint16, f64 = Scalar::float64;
constexpr LasField none{};
constexpr Known known_fields[] = {{"intensity", {12, u16}, {12, u16}},
                                  {"return_number", {14, u8, 0, 3}, {14, u8, 0, 4}},
                                  {"number_of_returns", {14, u8, 3, 3}, {14, u8, 4, 4}},
                                  {"scan_direction_flag", {14, u8, 6, 1}, {15, u8, 6, 1}},
                                  {"edge_of_flight_line", {14, u8, 7, 1}, {15, u8, 7, 1}},
                                  {"classification", {15, u8, 0, 5}, {16, u8}},
                                  {"synthetic", {15, u8, 5, 1}, {15, u8, 0, 1}, Since::version_1_1},
                                  {"key_point", {15, u8, 6, 1}, {15, u8, 1, 1}, Since::version_1_1},
                                  {"withheld", {15, u8, 7, 1}, {15, u8, 2, 1}, Since::version_1_1},
                                  {"overlap", none, {15, u8, 3, 1}, Since::new_family},
                                  {"scanner_channel", none, {15, u8, 4, 2}, Since::new_family},
                                  {"scan_angle", {16, Scalar::int8}, {18, Scalar::int16, 0, 0, 0.006}},  // degrees
                                  {"user_data", {17, u8}, {17, u8}},
                                  {"point_source_id", {18, u16}, {20, u16}},
                                  {"gps_time", {0, f64}, {0, f64}, Since::any, &FieldLayout::time},
                                  {"red", {0, u16}, {0, u16}, Since::any, &FieldLayout::color},
                                  {"green", {2, u16}, {2, u16}, Since::any, &FieldLayout::color},
                                  {"blue", {4, u16}, {4, u16}, Since::any, &FieldLayout::color},
                                  {"infrared", {0, u16}, {0, u16}, Since::any, &FieldLayout::infrared}};
constexpr std::string_view axes[] = {"x", "y", "z"};

}  // namespace

std::size_t las_record_size(unsigned format) { return layouts[format].size; }

double LasField::value(const char* record) const {
  if (bits > 0) {
    const unsigned byte = load<std::uint8_t>(record + offset, std::endian::little);
    return static_cast<double>(byte >> first_bit & ((1U << bits) - 1));
  }
  return load_number(type, record + offset, std::endian::little) * unit + shift;
}

void LasField::append_to(PointColumn& column, const char* record) const {
  with_type(kept_type(), [&](auto number) {
    using Number = decltype(number);
    column.append(bits > 0 || unit != 1 || shift != 0 ? static_cast<Number>(value(record))
                                                      : load<Number>(record + offset, std::endian::little));
  });
}

std::optional<LasField> find_las_field(std::string_view name, unsigned format, unsigned minor) {
  const FieldLayout& layout = layouts[format];
  const bool is_new = format >= first_of_new_family;
  for (const Known& field : known_fields) {
    if (!is_same_field(name, field.name)) continue;
    if (field.since == Since::new_family && !is_new) return std::nullopt;
    // Refuse flags for version 1.0, in which the class is the whole byte.
    if (!is_new && minor == 0 && field.since == Since::version_1_1) return std::nullopt;
    if (!is_new && minor == 0 && field.name == "classification") return LasField{15, u8};
    LasField found = is_new ? field.new_family : field.old_family;
    if (field.behind == nullptr) return found;
    if (layout.*field.behind == 0) return std::nullopt;
    found.offset += layout.*field.behind;
    return found;
  }
  return std::nullopt;
}

std::vector<NamedLasField> all_las_fields(unsigned format, unsigned minor, std::size_t length, std::string_view extra) {
  std::vector<NamedLasField> fields;
  for (const Known& known : known_fields)
    if (const std::optional<LasField> field = find_las_field(known.name, format, minor))
      fields.push_back({std::string(known.name), *field});
  constexpr std::size_t entry = 192;
  constexpr Scalar types[] = {Scalar::uint8, Scalar::int8,   Scalar::uint16, Scalar::int16,   Scalar::uint32,
                              Scalar::int32, Scalar::uint64, Scalar::int64,  Scalar::float32, Scalar::float64};
  std::size_t offset = las_record_size(format);
  for (; extra.size() >= entry; extra.remove_prefix(entry)) {
    const unsigned type = static_cast<unsigned char>(extra[2]), options = static_cast<unsigned char>(extra[3]);
    constexpr unsigned most = 30, has_scale = 8, has_offset = 16;
    if (type > most) break;  // the places of further fields are not known
    const Scalar scalar = types[type == 0 ? 0 : (type - 1) % std::size(types)];
    const std::size_t count = type == 0 ? options : 1 + (type - 1) / std::size(types);  // 11 to 30: lists of 2 and 3
    const std::size_t size = count * size_of(scalar);
    if (size > length - offset) break;
    const std::string name(extra.substr(4, std::min<std::size_t>(32, extra.find('\0', 4) - 4)));
    for (std::size_t k = 0; type > 0 && k < count; ++k) {
      LasField field{.offset = offset + k * size_of(scalar), .type = scalar};
      if ((options & has_scale) != 0) field.unit = load<double>(&extra[112 + 8 * k], std::endian::little);
      if ((options & has_offset) != 0) field.shift = load<double>(&extra[136 + 8 * k], std::endian::little);
      fields.push_back({count == 1 ? name : name + "[" + std::to_string(k) + "]", field});
    }
    offset += size;
  }
  return fields;
}

namespace {

constexpr std::int64_t greatest_exact = std::int64_t{1} << 53;  // doubles represent every integer up to 2^53
constexpr int max_places = 15;                                  // 10^15 is exact, and below 2^53

/// The number `digits` · 10^−`places`.
struct Decimal {
  std::int64_t digits;
  int places;
};

/// Returns the digits of `decimal` with `places` ≥ decimal.places places; nothing if they exceed greatest_exact.
std::optional<std::int64_t> with_places(Decimal decimal, int places) {
  for (; decimal.places < places; ++decimal.places) {
    if (std::abs(decimal.digits) > greatest_exact / 10) return std::nullopt;
    decimal.digits *= 10;
  }
  return decimal.digits;
}

/// Returns the shortest decimal that reads back to `value`; nothing beyond greatest_exact or max_places.
std::optional<Decimal> decimal_of(double value) {
  char text[32];
  char* const end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific).ptr;
  char* const e = std::find(text, end, 'e');
  if (e == end) return std::nullopt;
  char* const point = std::find(text, e, '.');
  int exponent = 0;
  std::from_chars(e[1] == '+' ? e + 2 : e + 1, end, exponent);
  Decimal decimal{0, static_cast<int>(point == e ? 0 : e - point - 1) - exponent};
  std::from_chars(text, std::remove(text, e, '.'), decimal.digits);  // at most 17 digits
  if (decimal.digits == 0) return Decimal{0, 0};
  if (decimal.places > max_places) return std::nullopt;
  if (decimal.places >= 0) return decimal;
  const std::optional<std::int64_t> whole = with_places(decimal, 0);
  return whole ? std::optional(Decimal{*whole, 0}) : std::nullopt;
}

}  // namespace

ScaledInteger::ScaledInteger(double scale, double offset) : scale_(scale), offset_(offset) {
  const std::optional<Decimal> a = decimal_of(scale), b = decimal_of(offset);
  if (!a || !b) return;
  const int places = std::max(a->places, b->places);
  const std::optional<std::int64_t> factor = with_places(*a, places), summand = with_places(*b, places);
  constexpr std::int64_t largest_value = std::int64_t{1} << 31;
  if (!factor || !summand || std::abs(*factor) > (greatest_exact - std::abs(*summand)) / largest_value) return;
  exact_ = true;
  factor_ = *factor;
  summand_ = *summand;
  for (int i = 0; i < places; ++i) divisor_ *= 10;
}

namespace {

/// Returns 0, 1 or 2 for x, y or z, which are not fields, as they need scale and offset; nothing for other names.
std::optional<std::size_t> las_axis(std::string_view name) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (is_same_field(name, axes[axis])) return axis;
  return std::nullopt;
}

}  // namespace

FieldNames names_of_las_fields() {
  std::string names = "x, y, z";
  for (const Known& field : known_fields) names += ", " + std::string(field.name);
  return {names_of_columns().are, "a field of LAS: " + names + ", or the name of extra bytes", false};
}

std::vector<LasPlace> find_las_places(const Condition& condition, unsigned format, unsigned minor,
                                      const std::vector<NamedLasField>& all, const std::string& name) {
  std::vector<LasPlace> places;
  for (const std::string& wanted : condition.fields()) {
    if (const std::optional<std::size_t> axis = las_axis(wanted)) {
      places.push_back({.field = {.offset = 4 * *axis, .type = Scalar::int32}, .axis = axis});
      continue;
    }
    const NamedLasField* const field = find_named(std::span(all), wanted);
    if (field == nullptr) {
      std::string there = "x, y, z";
      for (const NamedLasField& known : all) there += ", " + printable(known.name);
      bad_input(name,
                "point format " + std::to_string(format) + " of LAS 1." + std::to_string(minor) + " with " + there,
                "one with " + wanted + ", as " + std::string(condition.option_of(wanted)) + " requires");
    }
    places.push_back({.field = field->field});
  }
  return places;
}

}  // namespace rbpa::app
