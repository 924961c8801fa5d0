#include "io/text/columns.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>

#include "io/bytes/number.h"
#include "io/failure.h"
#include "io/text/lines.h"

namespace rbpa::app {
namespace {

Column parse_column(std::string_view text) {
  // Refuse numbers as names: -1 and 1.5 are mistakes.
  const NumberFault fault = parse_whole_number(text).fault;
  if (fault == NumberFault::not_a_number || fault == NumberFault::not_finite)
    return {.number = 0, .name = std::string(text)};
  const std::size_t number = parse_count(text).value_or(0);
  if (number == 0) bad_usage("--columns", in_quotes(text), "a column number from 1 or a column name");
  return {.number = number};
}

}  // namespace

void refuse_repeated_column(std::string_view columns, const std::string& expected) {
  bad_usage("--columns", in_quotes(columns) + ", the same column twice", expected);
}

std::vector<Column> parse_columns(const std::string& text) {
  const std::vector<std::string_view> words = split_at_commas(text);
  if (words.size() > 2 || words.front().empty() || words.back().empty())
    bad_usage("--columns", in_quotes(text), "X,Y (two column numbers or names), or one column of geometries");
  std::vector<Column> columns;
  for (const std::string_view word : words) columns.push_back(parse_column(word));
  if (columns.size() == 2 && columns[0] == columns[1]) refuse_repeated_column(text, "two columns");
  return columns;
}

std::vector<Column> parse_space_columns(const std::string& text) {
  const auto refuse = [&] {
    bad_usage("--columns", in_quotes(text), "X,Y,Z or X,Y,Z,NX,NY,NZ (column numbers or names)");
  };
  std::vector<Column> columns;
  for (const std::string_view word : split_at_commas(text)) {
    if (word.empty()) refuse();
    columns.push_back(parse_column(word));
  }
  if (columns.size() != 3 && columns.size() != 6) refuse();
  for (auto column = columns.begin(); column != columns.end(); ++column)
    if (std::find(columns.begin(), column, *column) != column) refuse_repeated_column(text);
  return columns;
}

namespace {

/// Names of columns that belong together, in a normal form: lower-case letters and digits without accents, and without
/// a unit in brackets or after the last space or underscore.
struct Names {
  std::vector<std::string_view> x, y;
  bool degrees = false;
};
const std::vector<Names>& known_names() {
  static const std::vector<Names> known = {
      {{"lon", "lng", "long", "longitude", "decimallongitude", "longitudedeg", "londeg",
        // German, Spanish, Italian, Dutch, Danish and Norwegian, Polish, Czech, Finnish, Turkish
        "lange", "laenge", "langengrad", "laengengrad", "geolange", "geolaenge", "geographischelange",
        "geographischelaenge", "longitud", "longitudine", "lengtegraad", "langdegrad", "laengdegrad", "lengdegrad",
        "dlugosc", "dlugoscgeograficzna", "zemepisnadelka", "pituusaste", "boylam"},
       {"lat", "latitude", "decimallatitude", "latitudedeg", "latdeg", "breite", "breitengrad", "geobreite",
        "geographischebreite", "latitud", "latitudine", "breedtegraad", "breddegrad", "szerokosc",
        "szerokoscgeograficzna", "zemepisnasirka", "leveysaste", "enlem"},
       true},
      {{"x",           "xcoord",      "xcoordinate", "coordx",      "coordinatex", "xcoor",
        "pointx",      "posx",        "positionx",   "utmx",        "xkoordinate", "koordinatex",
        "coordonneex", "xcoordonnee", "coordenadax", "coordinatax", "xcoordinaat", "abscissa",
        "abscisse",    "abszisse",    "abscisa",     "ascissa"},
       {"y",           "ycoord",      "ycoordinate", "coordy",      "coordinatey", "ycoor",       "pointy",
        "posy",        "positiony",   "utmy",        "ykoordinate", "koordinatey", "coordonneey", "ycoordonnee",
        "coordenaday", "coordinatay", "ycoordinaat", "ordinate",    "ordonnee",    "ordenada",    "ordinata"}},
      {{"easting", "eastings", "east", "e", "utmeasting", "utme", "rechtswert", "ostwert", "ost", "est", "este",
        "oost"},
       {"northing", "northings", "north", "n", "utmnorthing", "utmn", "hochwert", "nordwert", "nord", "norte",
        "noord"}}};
  return known;
}
constexpr std::string_view height_names[] = {"z",        "zcoord", "zcoordinate", "coordz",    "coordinatez",
                                             "zcoor",    "pointz", "posz",        "positionz", "elevation",
                                             "altitude", "height", "hohe",        "hoehe"};
constexpr std::string_view normal_names[3][4] = {
    {"nx", "normalx", "xnormal", "xn"}, {"ny", "normaly", "ynormal", "yn"}, {"nz", "normalz", "znormal", "zn"}};
constexpr std::string_view color_names[3][5] = {{"r", "red", "colorr", "rf", "diffusered"},
                                                {"g", "green", "colorg", "gf", "diffusegreen"},
                                                {"b", "blue", "colorb", "bf", "diffuseblue"}};
constexpr std::string_view wkt_names[] = {"wkt",     "geom",    "geometry",    "thegeom",
                                          "wktgeom", "geomwkt", "geometrywkt", "wktgeometry"};

constexpr std::string_view units[] = {"m", "ft", "deg"};

/// The base letters of U+00C0 to U+017F; a blank stands for a sign that is not a letter.
constexpr std::string_view base_letters =
    "aaaaaaaceeeeiiiidnooooo ouuuuytsaaaaaaaceeeeiiiidnooooo ouuuuyty"
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll"
    "lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
static_assert(base_letters.size() == 0x180 - 0xC0);

/// Removes the first character, in UTF-8 or Latin-1, from `text`. Returns a letter in lower case and without its
/// accent, a digit as it is, and a blank for any other character.
char take_folded(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const bool has_more = text.size() > 1 && (byte(1) & 0xC0U) == 0x80U,
             is_pair = has_more && lead >= 0xC2 && lead < 0xE0;
  const std::size_t code = is_pair ? (lead & 0x1FU) << 6U | (byte(1) & 0x3FU) : lead;
  text.remove_prefix(is_pair ? 2 : 1);
  if (code < 0x80)
    return std::isalnum(static_cast<int>(code)) != 0 ? static_cast<char>(std::tolower(static_cast<int>(code))) : ' ';
  const bool is_known = code >= 0xC0 && code < 0x180 && (is_pair || !has_more);
  return is_known ? base_letters[code - 0xC0] : ' ';
}

std::string folded(std::string_view name) {
  name = name.substr(0, name.find_first_of("(["));
  if (const auto last = name.find_last_of(" _");
      last != name.npos && std::find(std::begin(units), std::end(units), name.substr(last + 1)) != std::end(units))
    name = name.substr(0, last);
  std::string result;
  while (!name.empty())
    if (const char c = take_folded(name); c != ' ') result += c;
  return result;
}

/// Returns the index of the first column that has one of the names.
template <typename Known>
std::optional<std::size_t> find_first(const std::vector<std::string>& header, const Known& names) {
  const auto found = std::find_first_of(header.begin(), header.end(), std::begin(names), std::end(names));
  if (found == header.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header.begin());
}

/// Returns the indices of three columns, the k-th with a name of known[k]; empty unless all are there.
template <std::size_t names>
std::vector<std::size_t> find_three(const std::vector<std::string>& header, const std::string_view (&known)[3][names]) {
  std::vector<std::size_t> places;
  for (const auto& of_one : known)
    if (const std::optional<std::size_t> place = find_first(header, of_one)) places.push_back(*place);
  return places.size() == 3 ? places : std::vector<std::size_t>();
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
  const std::vector<std::size_t> normal = find_three(names, normal_names);
  places.insert(places.end(), normal.begin(), normal.end());
  return places;
}

std::vector<std::size_t> find_color_columns(const std::vector<std::string_view>& header) {
  return find_three(all_folded(header), color_names);
}

bool is_coordinate(std::string_view name, std::size_t axis) {
  if (axis == 2) return find_height({name}).has_value();
  return std::any_of(known_names().begin(), known_names().end(),
                     [&](const Names& known) { return is_one_of(axis == 0 ? known.x : known.y, name); });
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
