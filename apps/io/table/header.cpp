#include "io/table/header.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>

namespace rbpa::app {
namespace {

/// Names that go together. Letters and digits count, small; what is in brackets, a unit, does not.
struct Names {
  std::vector<std::string_view> x, y;
  bool degrees = false;
};
const std::vector<Names>& known_names() {
  static const std::vector<Names> known = {
      {{"lon", "lng", "long", "longitude", "decimallongitude", "longitudedeg", "londeg"},
       {"lat", "latitude", "decimallatitude", "latitudedeg", "latdeg"},
       true},
      {{"x", "xcoord", "xcoordinate", "coordx", "coordinatex", "xcoor", "pointx", "posx", "positionx", "utmx"},
       {"y", "ycoord", "ycoordinate", "coordy", "coordinatey", "ycoor", "pointy", "posy", "positiony", "utmy"}},
      {{"easting", "eastings", "east", "e", "utmeasting", "rechtswert", "ostwert"},
       {"northing", "northings", "north", "n", "utmnorthing", "hochwert", "nordwert"}}};
  return known;
}
constexpr std::string_view height_names[] = {"z",      "zcoord", "zcoordinate", "coordz",    "coordinatez", "zcoor",
                                             "pointz", "posz",   "positionz",   "elevation", "altitude",    "height"};
constexpr std::string_view normal_names[3][4] = {
    {"nx", "normalx", "xnormal", "xn"}, {"ny", "normaly", "ynormal", "yn"}, {"nz", "normalz", "znormal", "zn"}};
constexpr std::string_view color_names[3][4] = {
    {"r", "red", "colorr", "colourr"}, {"g", "green", "colorg", "colourg"}, {"b", "blue", "colorb", "colourb"}};
constexpr std::string_view wkt_names[] = {"wkt",     "geom",    "geometry",    "thegeom",
                                          "wktgeom", "geomwkt", "geometrywkt", "wktgeometry"};

std::string folded(std::string_view name) {
  std::string result;
  for (const char c : name.substr(0, std::min(name.find_first_of("(["), name.size())))
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// The first column that has one of the names.
template <typename Known>
std::optional<std::size_t> find_first(const std::vector<std::string>& header, const Known& names) {
  const auto found = std::find_first_of(header.begin(), header.end(), std::begin(names), std::end(names));
  if (found == header.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header.begin());
}

std::vector<std::string> all_folded(const std::vector<std::string_view>& header) {
  std::vector<std::string> names;
  for (const std::string_view name : header) names.push_back(folded(name));
  return names;
}

bool is_one_of(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), folded(name)) != names.end();
}

}  // namespace

std::optional<NamedColumns> find_coordinates(const std::vector<std::string_view>& header) {
  const std::vector<std::string> names = all_folded(header);
  std::optional<NamedColumns> best;
  const auto first_of = [](const NamedColumns& found) { return std::min(found.x, found.y); };
  for (const Names& known : known_names()) {
    const std::optional<std::size_t> x = find_first(names, known.x), y = find_first(names, known.y);
    if (!x || !y) continue;
    const NamedColumns found{*x, *y, known.degrees};
    if (!best || first_of(found) < first_of(*best)) best = found;
  }
  return best;
}

std::vector<std::size_t> find_space_columns(const std::vector<std::string_view>& header) {
  const std::vector<std::string> names = all_folded(header);
  const std::optional<NamedColumns> plane = find_coordinates(header);
  const std::optional<std::size_t> z = find_first(names, height_names);
  if (!plane || !z) return {};
  std::vector<std::size_t> places = {plane->x, plane->y, *z};
  for (const auto& axis : normal_names)
    if (const std::optional<std::size_t> n = find_first(names, axis)) places.push_back(*n);
  if (places.size() < 6) places.resize(3);
  return places;
}

std::vector<std::size_t> find_color_columns(const std::vector<std::string_view>& header) {
  const std::vector<std::string> names = all_folded(header);
  std::vector<std::size_t> places;
  for (const auto& channel : color_names)
    if (const std::optional<std::size_t> place = find_first(names, channel)) places.push_back(*place);
  return places.size() == 3 ? places : std::vector<std::size_t>();
}

std::optional<std::size_t> find_height(const std::vector<std::string_view>& header) {
  return find_first(all_folded(header), height_names);
}

bool is_longitude(std::string_view name) { return is_one_of(known_names().front().x, name); }
bool is_latitude(std::string_view name) { return is_one_of(known_names().front().y, name); }

std::optional<std::size_t> find_wkt(const std::vector<std::string_view>& header) {
  return find_first(all_folded(header), wkt_names);
}

}  // namespace rbpa::app
