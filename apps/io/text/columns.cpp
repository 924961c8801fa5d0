#include "io/text/columns.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <span>
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

/// Throws WrongUsage, which names `text`, if two columns are the same.
void refuse_repeated(const std::vector<Column>& columns, const std::string& text) {
  for (auto column = columns.begin(); column != columns.end(); ++column)
    if (std::find(columns.begin(), column, *column) != column) refuse_repeated_column(text);
}

}  // namespace

void refuse_repeated_column(std::string_view columns, const std::string& expected) {
  bad_usage("--columns", in_quotes(columns) + ", the same column twice", expected);
}

std::vector<Column> parse_columns(const std::string& text, bool may_have_z) {
  const std::vector<std::string_view> words = split_at_commas(text);
  const bool any_empty = std::any_of(words.begin(), words.end(), [](std::string_view word) { return word.empty(); });
  if (words.size() > (may_have_z ? 3 : 2) || any_empty)
    bad_usage("--columns", in_quotes(text),
              (may_have_z ? "X,Y or X,Y,Z (" : "X,Y (two ") +
                  std::string("column numbers or names), or one column of geometries"));
  if (words.size() == 1 && text.find(';') != std::string::npos)
    bad_usage("--columns", in_quotes(text), "X,Y, with a comma between two columns");
  std::vector<Column> columns;
  for (const std::string_view word : words) columns.push_back(parse_column(word));
  if (columns.size() == 2 && columns[0] == columns[1]) refuse_repeated_column(text, "two columns");
  refuse_repeated(columns, text);
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
  refuse_repeated(columns, text);
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
        "rechts", "rw", "ostkoordinate", "ostlig",
        // Finnish, Polish, Czech, Hungarian, Turkish, Portuguese, Russian
        "ita", "itakoordinaatti", "wschod", "vychod", "kelet", "dogu", "leste", "восток"},
       {"northing", "northings", "north", "n", "utmnorthing", "utmn", "hochwert", "nordwert", "nord", "norte", "noord",
        "hoch", "hw", "nordkoordinate", "nordlig", "norr",
        // in the order of languages above
        "pohjoinen", "pohjoiskoordinaatti", "polnoc", "sever", "eszak", "kuzey", "север"}}};
  return known;
}
/// Names that may also mean a side of a box, or the length or the width of a thing: less sure than any other name.
constexpr std::string_view weak_names[] = {"e",      "n",       "lange",     "laenge",    "breite",   "pituus",
                                           "leveys", "dlugosc", "szerokosc", "hosszusag", "szelesseg"};
constexpr std::string_view south_names[] = {"s", "south", "sud", "sued", "sur"},
                           west_names[] = {"w", "west", "ouest", "oeste", "ovest"};
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

constexpr std::string_view units[] = {"m", "ft", "deg", "km", "cm", "mm"};

/// Words that say that a number is no coordinate.
constexpr std::string_view other_words[] = {"rad",    "radians",  "dms",   "e7",    "min",    "max",
                                            "sec",    "minutes",  "error", "err",   "std",    "sigma",
                                            "offset", "accuracy", "speed", "delta", "normal", "velocity"};

template <typename Word, typename Known>
bool is_among(const Word& word, const Known& known) {
  return std::find(std::begin(known), std::end(known), word) != std::end(known);
}

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

/// Returns a name without its unit, and the unit: the text in brackets, or the last word if that is a known unit.
std::pair<std::string_view, std::string_view> split_unit(std::string_view name) {
  if (const std::size_t bracket = name.find_first_of("(["); bracket < name.size())
    return {name.substr(0, bracket), name.substr(bracket + 1, name.find_first_of(")]") - bracket - 1)};
  const std::size_t last = std::min(name.find_last_of(" _"), name.size() - 1);
  const std::string_view word = name.substr(last + 1);
  return is_among(word, units) ? std::pair(name.substr(0, last), word) : std::pair(name, std::string_view());
}

constexpr std::size_t longest_name = 1024;  // bytes that are compared: no known name is as long

std::string folded(std::string_view name) {
  name = split_unit(name.substr(0, longest_name)).first;
  std::string result;
  while (!name.empty()) take_folded(name, result);
  return result;
}

/// Returns the words of a name as take_folded() writes them, also words in brackets. A word ends before a character
/// that is neither a letter nor a digit, and before a capital after a small letter ("stopLat").
std::vector<std::string> folded_words(std::string_view name) {
  std::vector<std::string> words(1);
  name = name.substr(0, longest_name);
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
  const std::vector<std::string> words = folded_words(name);
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return is_among(word, known); });
}

/// Returns the indices of the columns with a word that is one of the names, and, if `must_be_sure`, no word that says
/// that the number is no coordinate.
template <typename Known>
std::vector<std::size_t> with_word(const std::vector<std::string_view>& header, const Known& names,
                                   bool must_be_sure = true) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < header.size(); ++i) {
    std::string_view name = header[i].substr(0, longest_name);
    name = name.substr(0, name.find_first_of("(["));
    if (name.empty() || is_digit(name.front()) || !has_word(name, names)) continue;  // 52°34'03.07"N is no name
    if (!must_be_sure || !has_word(name, other_words)) places.push_back(i);
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
  return is_among(folded(name), names) || !with_word({name}, names).empty();
}

/// Returns the names that may stand for points in a table with this header: all names but east and north if the columns
/// are sides of boxes.
std::span<const Names> names_for(const std::vector<std::string_view>& header) {
  return std::span(known_names()).first(known_names().size() - (are_sides(header) ? 1U : 0U));
}

/// Returns the pairs of columns whose names differ only in an ending such as lon and lat: "INTPTLONG", "INTPTLAT".
std::vector<NamedColumns> find_by_endings(const std::vector<std::string>& names) {
  constexpr std::size_t shortest = 3;  // of an ending
  const auto beginning = [](std::string_view name, const std::vector<std::string_view>& endings) {
    std::string_view least;
    for (const std::string_view ending : endings)
      if (ending.size() >= shortest && name.ends_with(ending))
        if (const auto rest = name.substr(0, name.size() - ending.size()); least.empty() || rest.size() < least.size())
          least = rest;
    return is_among(least, other_words) ? std::string_view() : least;
  };
  std::vector<NamedColumns> pairs;
  for (const Names& known : known_names())
    for (std::size_t x = 0; x < names.size(); ++x)
      for (std::size_t y = 0; y < names.size(); ++y)
        if (const std::string_view of_x = beginning(names[x], known.x);
            x != y && !of_x.empty() && of_x == beginning(names[y], known.y))
          pairs.push_back({x, y, known.degrees});
  return pairs;
}

/// Returns the columns whose names have words such as lon and lat; nothing if several pairs of columns have them.
std::optional<NamedColumns> find_by_words(const std::vector<std::string_view>& header) {
  std::optional<NamedColumns> one;
  for (const Names& known : names_for(header)) {
    const std::vector<std::size_t> x = with_word(header, known.x), y = with_word(header, known.y);
    if (x.empty() || y.empty() || (x == y && x.size() == 1)) continue;
    const bool is_other = one && (one->x != x.front() || one->y != y.front());
    if (x.size() > 1 || y.size() > 1 || is_other) return std::nullopt;
    if (!one) one = {x.front(), y.front(), known.degrees};
  }
  return one;
}

}  // namespace

bool are_sides(const std::vector<std::string_view>& header) {
  const auto has = [&](const auto& known) {
    return std::any_of(header.begin(), header.end(), [&](std::string_view name) { return has_word(name, known); });
  };
  return has(south_names) && has(west_names);
}

std::optional<NamedColumns> find_coordinates(const std::vector<std::string_view>& header) {
  const std::vector<std::string> names = all_folded(header);
  std::optional<NamedColumns> best;
  const auto rank = [&](const NamedColumns& found) {
    return std::pair(is_among(names[found.x], weak_names) && is_among(names[found.y], weak_names),
                     std::min(found.x, found.y));
  };
  // Returns the first column with the name of column `a` that begins, as that of column `b`, with a capital or not.
  const auto of_same_case = [&](std::size_t a, std::size_t b) {
    const auto is_capital = [&](std::size_t i) {
      return std::isupper(static_cast<unsigned char>(header[i].front())) != 0;
    };
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == names[a] && is_capital(i) == is_capital(b)) return i;
    return a;
  };
  for (const Names& known : names_for(header)) {
    const std::optional<std::size_t> x = find_first(names, known.x), y = find_first(names, known.y);
    if (!x || !y) continue;
    NamedColumns found{*x, *y, known.degrees};
    found.x = of_same_case(found.x, found.y);
    found.y = of_same_case(found.y, found.x);
    if (!best || rank(found) < rank(*best)) best = found;
  }
  if (best && !rank(*best).first) return best;
  std::vector<std::string_view> others = header;
  if (best) others[best->x] = others[best->y] = {};
  if (const std::optional<NamedColumns> by_words = find_by_words(others)) return by_words;
  const std::vector<NamedColumns> by_endings = find_by_endings(names);
  return best || by_endings.size() != 1 ? best : by_endings.front();
}

std::vector<std::size_t> find_likely_columns(const std::vector<std::string_view>& header) {
  for (const Names& known : names_for(header)) {
    const std::vector<std::size_t> x = with_word(header, known.x, false), y = with_word(header, known.y, false);
    if (!x.empty() && !y.empty() && x.front() != y.front()) return {x.front(), y.front()};
  }
  for (const NamedColumns& pair : find_by_endings(all_folded(header))) return {pair.x, pair.y};
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

bool is_reversed(std::string_view name) { return has_word(name, south_names) || has_word(name, west_names); }

bool is_part_of_degree(std::string_view name) {
  constexpr std::string_view parts[] = {"min", "minute", "minutes", "minuten", "sec", "second", "seconds", "sekunden"};
  const Names& degrees = known_names().front();
  const auto is_degree = [&](const std::string& word) {
    return is_among(word, degrees.x) || is_among(word, degrees.y);
  };
  const std::vector<std::string> words = folded_words(name.substr(0, name.find_first_of("([")));
  const bool any_degree = std::any_of(words.begin(), words.end(), is_degree);
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return (any_degree && (word == "m" || word == "s")) ||
           std::any_of(parts, std::end(parts), [&](std::string_view part) {
             return word == part || (word.ends_with(part) && is_degree(word.substr(0, word.size() - part.size())));
           });
  });
}

bool have_different_units(std::string_view a, std::string_view b) {
  const std::string_view of_a = split_unit(a).second, of_b = split_unit(b).second;
  const auto is_length = [](std::string_view unit) { return unit != "deg" && is_among(unit, units); };
  return is_length(of_a) && is_length(of_b) && of_a != of_b;
}

std::optional<std::size_t> find_wkt(const std::vector<std::string_view>& header) {
  return find_first(all_folded(header), wkt_names);
}

}  // namespace rbpa::app
