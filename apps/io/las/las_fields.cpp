#include "io/las/las_fields.h"

#include <bit>
#include <cctype>
#include <cmath>

namespace rbpa::app {
namespace {

/// What stands behind the fields that all formats of a family have.
struct FieldLayout {
  std::size_t size;
  std::size_t time = 0, colour = 0, infrared = 0;  // 0: there is none
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

/// A field and where each family of formats has it.
struct Known {
  std::string_view name;
  LasField old_family, new_family;
  Since since = Since::any;
};
constexpr Scalar u8 = Scalar::uint8, u16 = Scalar::uint16;
constexpr LasField none{};
constexpr Known fields[] = {{"intensity", {12, u16}, {12, u16}},
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
                            {"point_source_id", {18, u16}, {20, u16}}};
constexpr std::string_view further[] = {"gps_time", "red", "green", "blue", "infrared"};
constexpr std::string_view axes[] = {"x", "y", "z"};

std::string folded(std::string_view name) {
  std::string result;
  for (const char c : name)
    if (c != '_') result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  // As PDAL and LAStools call them.
  if (result == "nir") return "infrared";
  if (result == "scananglerank") return "scanangle";
  if (result == "keypoint" || result == "modelkeypoint") return "keypoint";
  return result;
}

bool is(std::string_view name, std::string_view known) { return folded(name) == folded(known); }

}  // namespace

std::size_t las_record_size(unsigned format) { return layouts[format].size; }

double LasField::value(const char* record) const {
  if (bits > 0) {
    const unsigned byte = load<std::uint8_t>(record + offset, std::endian::little);
    return static_cast<double>(byte >> first_bit & ((1U << bits) - 1));
  }
  return load_number(type, record + offset, std::endian::little) * unit;
}

std::optional<LasField> find_las_field(std::string_view name, unsigned format, unsigned minor) {
  const FieldLayout& layout = layouts[format];
  const bool is_new = format >= first_of_new_family;
  for (const Known& field : fields) {
    if (!is(name, field.name)) continue;
    if (field.since == Since::new_family && !is_new) return std::nullopt;
    // Version 1.0 knows no flags there: the class is the whole byte.
    if (!is_new && minor == 0 && field.since == Since::version_1_1) return std::nullopt;
    if (!is_new && minor == 0 && field.name == "classification") return LasField{15, u8};
    return is_new ? field.new_family : field.old_family;
  }
  if (is(name, "gps_time") && layout.time > 0) return LasField{layout.time, Scalar::float64};
  for (std::size_t i = 0; i < 3; ++i)
    if (is(name, further[1 + i]) && layout.colour > 0) return LasField{layout.colour + 2 * i, u16};
  if (is(name, "infrared") && layout.infrared > 0) return LasField{layout.infrared, u16};
  return std::nullopt;
}

bool is_las_field(std::string_view name) {
  for (const Known& field : fields)
    if (is(name, field.name)) return true;
  for (const std::string_view field : further)
    if (is(name, field)) return true;
  return las_axis(name).has_value();
}

std::optional<std::size_t> las_axis(std::string_view name) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (is(name, axes[axis])) return axis;
  return std::nullopt;
}

std::string las_field_names() {
  std::string names = "x, y, z";
  for (const Known& field : fields) names += ", " + std::string(field.name);
  for (const std::string_view field : further) names += ", " + std::string(field);
  return names;
}

}  // namespace rbpa::app
