#include "io/las/las_projection.h"

#include <algorithm>
#include <string>

#include "io/las/epsg_feet.h"

namespace rbpa::app {
namespace {

/// What the records say. Text is newer, and says more.
struct Found {
  std::optional<LasCrs> text = std::nullopt, keys = std::nullopt;
};

LasCrs named(const std::optional<Crs>& crs) {
  return {crs, crs ? "" : "the system of coordinates has no EPSG code and is not carried over (--crs says one)"};
}

/// GeoTIFF: four numbers, of which the last counts the keys; then four for each key.
LasCrs crs_of_keys(std::string_view data) {
  constexpr std::size_t entry = 8;
  const auto number = [&](std::size_t i, std::size_t k) {
    return las_value<std::uint16_t>(data.data() + i * entry + 2 * k);
  };
  if (data.size() < entry) return {};
  const std::size_t keys = std::min<std::size_t>(number(0, 3), data.size() / entry - 1);
  unsigned model = 0, geographic = 0, projected = 0, unit = 0;
  for (std::size_t i = 1; i <= keys; ++i) {
    if (number(i, 1) != 0) continue;  // its value is elsewhere: a text or doubles
    if (number(i, 0) == 1024) model = number(i, 3);
    if (number(i, 0) == 2048) geographic = number(i, 3);
    if (number(i, 0) == 3072) projected = number(i, 3);
    if (number(i, 0) == 3076) unit = number(i, 3);
  }
  constexpr unsigned of_the_user = 32767, model_projected = 1, model_geographic = 2, metre = 9001;
  const auto is_code = [](unsigned code) { return code > 0 && code < of_the_user; };
  if (is_code(projected) && model != model_geographic) {
    const std::optional<Crs> crs = crs_of_name("EPSG:" + std::to_string(projected));
    const unsigned own = feet_of_epsg(projected).value_or(metre);
    if (unit == 0 || unit == own) return named(crs);
    // Some write the code of the system in metres beside a unit of their own, feet.
    return {std::nullopt, "the system of coordinates is " + crs->text() + " in the unit " + std::to_string(unit) +
                              " of EPSG, and not its own, "
                              "and is not carried over (--crs says which it is)"};
  }
  if (!is_code(geographic) || model == model_projected || projected != 0) return named(std::nullopt);
  std::optional<Crs> crs = crs_of_name("EPSG:" + std::to_string(geographic));
  crs->degrees = true;
  return named(crs);
}

std::string_view without_zeros(std::string_view text) { return text.substr(0, std::min(text.find('\0'), text.size())); }

void take_note(Found& found, std::string_view user, unsigned number, std::string_view data) {
  if (without_zeros(user) != "LASF_Projection") return;
  if (number == 2112) found.text = named(crs_of_wkt(without_zeros(data)));
  if (number == 34735) found.keys = crs_of_keys(data);
}

/// Records from `at` on, which end before `end`. A header has reserved (2), user (16), number (2), length (2, or 8 of
/// extended records) and description (32).
void visit(Found& found, std::string_view bytes, std::size_t at, std::size_t end, std::size_t count, bool extended) {
  const std::size_t frame = extended ? 60 : 54;
  for (std::size_t i = 0; i < count && at <= end && end - at >= frame; ++i) {
    const char* record = bytes.data() + at;
    const std::size_t length = extended ? las_value<std::uint64_t>(record + 20) : las_value<std::uint16_t>(record + 20);
    if (length > end - at - frame) return;
    take_note(found, {record + 2, 16}, las_value<std::uint16_t>(record + 18), bytes.substr(at + frame, length));
    at += frame + length;
  }
}

}  // namespace

LasCrs las_crs(std::string_view bytes, const LasHeader& header) {
  Found found;
  visit(found, bytes, header.size, std::min(header.begin, bytes.size()), header.records, false);
  if (header.extended_records > 0 && header.extended_begin > header.begin)
    visit(found, bytes, header.extended_begin, bytes.size(), header.extended_records, true);
  if (found.text && (found.text->crs || !found.keys)) return *found.text;
  return found.keys.value_or(LasCrs{});
}

}  // namespace rbpa::app
