#include "io/text/columns.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>

#include "io/failure.h"
#include "io/number.h"
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
        // German, Spanish, Italian, Dutch, Danish and Norwegian, Polish, Czech, Finnish, Turkish, Hungarian
        "lange", "laenge", "langengrad", "laengengrad", "geolange", "geolaenge", "longitud", "longitudine",
        "lengtegraad", "langdegrad", "laengdegrad", "lengdegrad", "dlugosc", "zemepisnadelka", "pituusaste", "pituus",
        "boylam", "hosszusag",
        // Russian, Greek, Chinese, Japanese
        "долгота", "μήκος", "经度", "經度", "経度"},
       {"lat", "latitude", "decimallatitude", "latitudedeg", "latdeg",
        // in the order of languages above
        "breite", "breitengrad", "geobreite", "latitud", "latitudine", "breedtegraad", "breddegrad", "szerokosc",
        "zemepisnasirka", "leveysaste", "leveys", "enlem", "szelesseg",
        // and of scripts
        "широта", "πλάτος", "纬度", "緯度"},
       true},
      {{"x", "xcoord", "xcoordinate", "coordx", "coordinatex", "xcoor", "pointx", "posx", "positionx", "utmx",
        "xkoordinate", "koordinatex", "xkoord", "abscissa", "abscisse", "abszisse", "abscisa", "ascissa"},
       {"y", "ycoord", "ycoordinate", "coordy", "coordinatey", "ycoor", "pointy", "posy", "positiony", "utmy",
        "ykoordinate", "koordinatey", "ykoord", "ordinate", "ordonnee", "ordenada", "ordinata"}},
      {{"easting", "eastings", "east", "e", "utmeasting", "utme", "rechtswert", "ostwert", "ost", "est", "este", "oost",
        "rechts", "rw", "ostkoordinate", "ostlig"},
       {"northing", "northings", "north", "n", "utmnorthing", "utmn", "hochwert", "nordwert", "nord", "norte", "noord",
        "hoch", "hw", "nordkoordinate", "nordlig"}}};
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

/// Removes the first character, in UTF-8 or Latin-1, from `text`, and appends it to `to`: a Latin letter in lower case
/// and without its accent, a Greek, Cyrillic or Chinese one in lower case, a digit as it is. Returns false, and appends
/// nothing, for any other character.
bool take_folded(std::string_view& text, std::string& to) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned lead = byte(0);
  const bool has_more = (byte(1) & 0xC0U) == 0x80U, is_pair = has_more && lead >= 0xC2 && lead < 0xE0;
  const bool is_chinese = has_more && lead >= 0xE3 && lead <= 0xE9 && (byte(2) & 0xC0U) == 0x80U;
  const std::string_view taken = text.substr(0, is_chinese ? 3 : is_pair ? 2 : 1);
  unsigned code = is_pair ? (lead & 0x1FU) << 6U | (byte(1) & 0x3FU) : lead;
  text.remove_prefix(taken.size());
  const std::size_t before = to.size();
  if (code < 0x80) {
    if (std::isalnum(static_cast<int>(code)) != 0) to += static_cast<char>(std::tolower(static_cast<int>(code)));
  } else if (is_chinese) {
    to += taken;
  } else if (is_pair && code >= 0x370) {
    if ((code >= 0x391 && code <= 0x3A9) || (code >= 0x410 && code <= 0x42F)) code += 0x20;
    to += {static_cast<char>(0xC0U | code >> 6U), static_cast<char>(0x80U | (code & 0x3FU))};
  } else if (code >= 0xC0 && code < 0x180 && (is_pair || !has_more) && base_letters[code - 0xC0] != ' ') {
    to += base_letters[code - 0xC0];
  }
  return to.size() > before;
}

std::string folded(std::string_view name) {
  name = name.substr(0, name.find_first_of("(["));
  if (const auto last = name.find_last_of(" _");
      last != name.npos && std::find(std::begin(units), std::end(units), name.substr(last + 1)) != std::end(units))
    name = name.substr(0, last);
  std::string result;
  while (!name.empty()) take_folded(name, result);
  return result;
}

/// Returns the words of a name, in the normal form, also those in brackets: between other characters than letters and
/// digits, and from a capital after a small letter on ("stopLat").
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words(1);
  for (char last = ' '; !name.empty();) {
    const char first = name.front();
    if (std::islower(static_cast<unsigned char>(last)) != 0 && std::isupper(static_cast<unsigned char>(first)) != 0)
      words.emplace_back();
    last = first;
    if (!take_folded(name, words.back())) words.emplace_back();
  }
  return words;
}

template <typename Known>
bool has_word(std::string_view name, const Known& known) {
  const std::vector<std::string> words = words_of(name);
  return std::find_first_of(words.begin(), words.end(), std::begin(known), std::end(known)) != words.end();
}

/// Returns the indices of the columns with a word that is one of the names, and, if `must_be_sure`, no word that says
/// that the number is no coordinate.
template <typename Known>
std::vector<std::size_t> with_word(const std::vector<std::string_view>& header, const Known& names,
                                   bool must_be_sure = true) {
  constexpr std::string_view others[] = {"rad",   "radians", "dms", "e7",    "min",    "max",      "sec",   "minutes",
                                         "error", "err",     "std", "sigma", "offset", "accuracy", "speed", "delta"};
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const std::string_view name = header[i].substr(0, header[i].find_first_of("(["));
    if (name.empty() || is_digit(name.front()) || !has_word(name, names)) continue;  // 52°34'03.07"N is no name
    if (!must_be_sure || !has_word(name, others)) places.push_back(i);
  }
  return places;
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
  return std::find(names.begin(), names.end(), folded(name)) != names.end() || !with_word({name}, names).empty();
}

/// Returns the columns whose names have words such as lon and lat; nothing if several pairs of columns have them.
std::optional<NamedColumns> find_by_words(const std::vector<std::string_view>& header) {
  std::optional<NamedColumns> one;
  for (const Names& known : known_names()) {
    const std::vector<std::size_t> x = with_word(header, known.x), y = with_word(header, known.y);
    if (x.empty() || y.empty() || (x == y && x.size() == 1)) continue;
    const bool is_other = one && (one->x != x.front() || one->y != y.front());
    if (x.size() > 1 || y.size() > 1 || is_other) return std::nullopt;
    if (!one) one = {x.front(), y.front(), known.degrees};
  }
  return one;
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
  return best ? best : find_by_words(header);
}

std::vector<std::size_t> find_likely_columns(const std::vector<std::string_view>& header) {
  for (const Names& known : known_names()) {
    const std::vector<std::size_t> x = with_word(header, known.x, false), y = with_word(header, known.y, false);
    if (!x.empty() && !y.empty() && x.front() != y.front()) return {x.front(), y.front()};
  }
  return {};
}

std::vector<std::size_t> find_space_columns(const std::vector<std::string_view>& header) {
  const std::vector<std::string> names = all_folded(header);
  const std::optional<NamedColumns> plane = find_coordinates(header);
  std::optional<std::size_t> z = find_first(names, height_names);
  if (const std::vector<std::size_t> words = with_word(header, height_names); !z && words.size() == 1)
    z = words.front();
  if (!plane || !z || *z == plane->x || *z == plane->y) return {};
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

bool is_reversed(std::string_view name) {
  constexpr std::string_view directions[] = {"w",    "s",     "west",  "south", "sud",
                                             "sued", "oeste", "ouest", "ovest", "sur"};
  return has_word(name, directions);
}
bool is_part_of_degree(std::string_view name) {
  constexpr std::string_view parts[] = {"min", "minute", "minutes", "minuten", "sec", "second", "seconds", "sekunden"};
  return has_word(name, parts);
}

std::optional<std::size_t> find_wkt(const std::vector<std::string_view>& header) {
  return find_first(all_folded(header), wkt_names);
}

}  // namespace rbpa::app
