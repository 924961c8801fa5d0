#include "io/crs.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/words.h"

namespace rbpa::app {
namespace {

/// EPSG codes of common geographic systems: WGS 84, ETRS89, NAD83, NAD27 and national systems. Any other system counts
/// as geographic only if the file names it so.
constexpr std::string_view geographic_codes[] = {
    "4326", "4979", "4258", "4937", "4269", "4267", "4283", "7844", "4171", "4230", "4277", "4289", "4313", "4314",
    "4149", "4150", "4167", "4152", "4612", "6668", "4490", "4610", "4214", "4674", "4618", "4617", "6318", "4275",
    "4231", "4148", "4222", "4164", "4166", "4737", "4756", "4759", "4740", "4284", "4200", "7683", "4124", "4619"};

/// Ranges of EPSG codes, first and last, whose assigned codes are all systems of heights or depths.
/// Source: EPSG dataset 10.076, as PROJ 9.1.1 has it.
// clang-format off
constexpr std::pair<std::uint16_t, std::uint16_t> vertical_codes[] = {
    {3855, 3855}, {3886, 3886}, {3900, 3900}, {4440, 4440}, {4458, 4458}, {5193, 5195}, {5214, 5214}, {5237, 5237},
    {5317, 5317}, {5336, 5336}, {5597, 5597}, {5600, 5621}, {5701, 5706}, {5709, 5799}, {5829, 5829}, {5831, 5831},
    {5843, 5843}, {5861, 5874}, {5941, 5941}, {6130, 6132}, {6178, 6187}, {6357, 6360}, {6638, 6644}, {6647, 6647},
    {6693, 6695}, {6916, 6916}, {7446, 7447}, {7651, 7652}, {7699, 7707}, {7832, 7841}, {7888, 7890}, {7962, 7979},
    {8050, 8053}, {8089, 8089}, {8228, 8228}, {8266, 8267}, {8357, 8358}, {8378, 8378}, {8434, 8434}, {8675, 8675},
    {8690, 8691}, {8841, 8841}, {8881, 8881}, {8897, 8897}, {8904, 8904}, {8911, 8911}, {9130, 9130}, {9245, 9245},
    {9255, 9255}, {9274, 9279}, {9287, 9288}, {9303, 9303}, {9335, 9351}, {9389, 9390}, {9392, 9402}, {9451, 9451},
    {9458, 9458}, {9471, 9471}, {9650, 9651}, {9663, 9672}, {9675, 9675}, {9681, 9681}, {9721, 9722}, {9923, 9923},
    {9927, 9927}, {20000, 20000}, {20034, 20036}};

/// EPSG codes of all geocentric systems, of the same source.
constexpr std::uint16_t geocentric_codes[] = {
    3822, 3887, 4000, 4039, 4073, 4079, 4328, 4330, 4331, 4332, 4333, 4334, 4335, 4336, 4337, 4338, 4340, 4342, 4344,
    4346, 4348, 4350, 4352, 4354, 4356, 4358, 4360, 4362, 4364, 4366, 4368, 4370, 4372, 4374, 4376, 4378, 4380, 4382,
    4384, 4385, 4387, 4389, 4465, 4468, 4473, 4479, 4481, 4556, 4882, 4884, 4886, 4888, 4890, 4892, 4894, 4896, 4897,
    4899, 4906, 4908, 4910, 4911, 4912, 4913, 4914, 4915, 4916, 4917, 4918, 4919, 4920, 4922, 4924, 4926, 4928, 4930,
    4932, 4934, 4936, 4938, 4940, 4942, 4944, 4946, 4948, 4950, 4952, 4954, 4956, 4958, 4960, 4962, 4964, 4966, 4968,
    4970, 4972, 4974, 4976, 4978, 4980, 4982, 4984, 4986, 4988, 4990, 4992, 4994, 4996, 4998, 5011, 5244, 5250, 5262,
    5322, 5332, 5341, 5352, 5358, 5363, 5368, 5369, 5379, 5391, 5487, 5544, 5558, 5591, 5828, 5884, 6133, 6309, 6317,
    6320, 6323, 6363, 6666, 6704, 6781, 6934, 6978, 6981, 6985, 6988, 7071, 7134, 7137, 7371, 7656, 7658, 7660, 7662,
    7664, 7677, 7679, 7681, 7684, 7789, 7796, 7815, 7842, 7879, 7884, 7914, 7916, 7918, 7920, 7922, 7924, 7926, 7928,
    7930, 8084, 8227, 8230, 8233, 8238, 8242, 8247, 8250, 8253, 8397, 8401, 8425, 8429, 8541, 8543, 8683, 8697, 8816,
    8898, 8905, 8915, 8917, 8919, 8921, 8923, 8925, 8927, 8929, 8931, 8933, 8935, 8937, 8939, 8941, 8943, 8945, 8947,
    9001, 9004, 9007, 9010, 9015, 9070, 9073, 9138, 9146, 9151, 9182, 9266, 9292, 9307, 9331, 9378, 9468, 9545, 9694,
    9700, 9753, 9775, 9780, 9892, 9988, 20039};
// clang-format on

/// Returns the number of an EPSG code; 0, which is none, for other systems.
std::size_t epsg_number(const Crs& crs) { return crs.authority == "EPSG" ? parse_count(crs.code).value_or(0) : 0; }

bool is_vertical(const Crs& crs) {
  const std::size_t code = epsg_number(crs);
  return std::any_of(std::begin(vertical_codes), std::end(vertical_codes),
                     [&](const auto& codes) { return code >= codes.first && code <= codes.second; });
}

bool is_word(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
  });
}

std::optional<Crs> crs_of(std::string_view authority, std::string_view code) {
  if (!is_word(authority) || !is_word(code)) return std::nullopt;
  Crs crs{.authority = in_capitals(authority), .code = in_capitals(code)};
  if (crs.authority == "CRS") crs.authority = "OGC";  // CRS:84, as WMS has it
  if (crs.authority == "OGC" && crs.code == "84") crs.code = "CRS84";
  if (crs.authority == "EPSG" && !std::all_of(code.begin(), code.end(), is_digit)) return std::nullopt;
  crs.degrees = crs.authority == "OGC"
                    ? crs.code.starts_with("CRS")
                    : crs.authority == "EPSG" && std::find(std::begin(geographic_codes), std::end(geographic_codes),
                                                           crs.code) != std::end(geographic_codes);
  return crs;
}

}  // namespace

std::string Crs::urn() const { return "urn:ogc:def:crs:" + authority + (authority == "OGC" ? ":1.3:" : "::") + code; }

std::optional<std::string> Crs::srid() const {
  if (is_wgs84()) return "4326";
  if (authority == "EPSG") return code;
  return std::nullopt;
}

bool Crs::is_geocentric() const {
  return std::find(std::begin(geocentric_codes), std::end(geocentric_codes), epsg_number(*this)) !=
         std::end(geocentric_codes);
}

bool Crs::is_wgs84() const {
  return (authority == "OGC" && code == "CRS84") || (authority == "EPSG" && code == "4326");
}

Crs wgs84() { return {.authority = "EPSG", .code = "4326", .degrees = true}; }

namespace {

/// Returns the system that `name` names, also a system of heights.
std::optional<Crs> system_of_name(std::string_view name) {
  const std::string folded = in_capitals(name);
  // Take the first part of a compound system, which is the horizontal one: "EPSG:6339+5703" or
  // "urn:ogc:def:crs,crs:EPSG::6339,crs:EPSG::5703".
  const auto before = [](std::string_view text, char sign) {
    return text.substr(0, std::min(text.find(sign), text.size()));
  };
  constexpr std::string_view urn = "URN:OGC:DEF:CRS:", compound_urn = "URN:OGC:DEF:CRS,CRS:";
  for (const std::string_view url : {"HTTP://WWW.OPENGIS.NET/DEF/CRS/", "HTTPS://WWW.OPENGIS.NET/DEF/CRS/"})
    if (folded.starts_with(url)) {  // authority/version/code
      const std::string_view rest = name.substr(url.size());
      return crs_of(before(rest, '/'), rest.substr(rest.rfind('/') + 1));
    }
  for (const std::string_view start : {urn, compound_urn})
    if (folded.starts_with(start)) {
      const std::string_view rest = before(name.substr(start.size()), ',');  // authority:version:code
      return crs_of(before(rest, ':'), rest.substr(rest.rfind(':') + 1));
    }
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  return crs_of(name.substr(0, colon), before(name.substr(colon + 1), '+'));
}

std::optional<Crs> plane(std::optional<Crs> crs) { return crs && is_vertical(*crs) ? std::nullopt : std::move(crs); }

constexpr std::string_view how_to_name = " (--crs EPSG:CODE names it)";

}  // namespace

std::optional<Crs> crs_of_name(std::string_view name) { return plane(system_of_name(name)); }

std::string warning_on_crs(std::string_view name) {
  const std::optional<Crs> crs = system_of_name(name);
  if (crs && is_vertical(*crs))
    return crs->text() + " is a system of heights, and the horizontal system is not known" + std::string(how_to_name);
  return "the system of coordinates is " + in_quotes(name) + ", which is not understood" + std::string(how_to_name);
}

void require_same_crs(const std::optional<Crs>& crs, const std::string& name, const std::optional<Crs>& first,
                      const std::string& first_name) {
  const auto text = [](const std::optional<Crs>& of) { return of ? of->text() : std::string("no system"); };
  const bool both_are_wgs84 = crs && first && crs->is_wgs84() && first->is_wgs84();
  if (both_are_wgs84 || text(crs) == text(first)) return;
  const std::string code = crs && first ? "EPSG:CODE" : text(crs ? crs : first);
  bad_input(name, "points in " + text(crs) + (crs && crs->implied ? ", which GeoJSON without a crs member means" : ""),
            text(first) + ", as in " + first_name + " (--crs " + code + " applies to all)");
}

// Well-known text.

namespace {

/// A node of well-known text: KEYWORD[items].
struct WktNode {
  std::string keyword = {};                  ///< in capitals; empty if the text is not KEYWORD[items]
  std::vector<std::string_view> items = {};  ///< the texts between the commas in its brackets
};

std::string_view without_blanks_around(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// Returns the parts of `text` between commas that are neither in quotes nor in brackets.
std::vector<std::string_view> items_of(std::string_view text) {
  std::vector<std::string_view> items;
  std::size_t begin = 0;
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '[' || c == '(') ++depth;
    if (c == ']' || c == ')') --depth;
    if (c != ',' || depth > 0) continue;
    items.push_back(without_blanks_around(text.substr(begin, i - begin)));
    begin = i + 1;
  }
  items.push_back(without_blanks_around(text.substr(begin)));
  return items;
}

WktNode node_of(std::string_view item) {
  const std::size_t bracket = item.find_first_of("[(\"");
  if (bracket == std::string_view::npos || item[bracket] == '"') return {};
  const std::size_t end = std::min(item.find_last_of("])"), item.size());  // a text that is cut off may have no end
  return {in_capitals(without_blanks_around(item.substr(0, bracket))),
          items_of(item.substr(bracket + 1, end - bracket - 1))};
}

std::string_view string_of(std::string_view text) {
  if (text.size() < 2 || text.front() != '"' || text.back() != '"') return text;
  return without_blanks_around(text.substr(1, text.size() - 2));
}

bool is_among(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Returns the system that an AUTHORITY or ID among the items of the node names; deeper ones do not count.
std::optional<Crs> own_crs(const WktNode& node) {
  for (const std::string_view item : node.items) {
    const WktNode inner = node_of(item);
    if (!is_among(inner.keyword, {"AUTHORITY", "ID"}) || inner.items.size() < 2) continue;
    if (auto crs = plane(crs_of(string_of(inner.items[0]), string_of(inner.items[1])))) return crs;
  }
  return std::nullopt;
}

/// Returns whether the system has longitudes and latitudes. A geodetic system may instead have earth-centered Cartesian
/// coordinates.
bool is_in_degrees(const WktNode& node) {
  if (is_among(node.keyword, {"GEOGCS", "GEOGCRS", "GEOGRAPHICCRS"})) return true;
  return is_among(node.keyword, {"GEODCRS", "GEODETICCRS"}) &&
         std::none_of(node.items.begin(), node.items.end(), [](std::string_view part) {
           const WktNode axes = node_of(part);
           return axes.keyword == "CS" && !axes.items.empty() && in_capitals(axes.items[0]) == "CARTESIAN";
         });
}

/// A horizontal system in well-known text; of a compound or bound system, the horizontal part.
struct PlaneSystem {
  WktNode node = {};  ///< has no keyword if there is no such system
  std::optional<Crs> crs = std::nullopt;
};
PlaneSystem find_plane(const std::vector<std::string_view>& items, int depth = 0) {
  constexpr int deepest = 8;
  for (const std::string_view item : items) {
    const WktNode node = node_of(item);
    PlaneSystem found{};
    if (is_among(node.keyword, {"COMPD_CS", "COMPOUNDCRS", "BOUNDCRS", "SOURCECRS", "COORDINATEMETADATA"}) &&
        depth < deepest)
      found = find_plane(node.items, depth + 1);
    else if (is_among(node.keyword,
                      {"GEOGCS", "GEOGCRS", "GEOGRAPHICCRS", "GEODCRS", "GEODETICCRS", "PROJCS", "PROJCRS",
                       "PROJECTEDCRS", "DERIVEDPROJCRS", "GEOCCS", "LOCAL_CS", "ENGCRS", "ENGINEERINGCRS"}))
      found.node = node;
    if (found.node.keyword.empty()) continue;
    if (!found.crs) found.crs = own_crs(node);
    if (found.crs && is_in_degrees(found.node)) found.crs->degrees = true;
    return found;
  }
  return {};
}

}  // namespace

std::optional<Crs> crs_of_wkt(std::string_view text) { return find_plane(items_of(text)).crs; }

std::optional<double> unit_of_wkt(std::string_view text) {
  const WktNode system = find_plane(items_of(text)).node;
  if (!system.keyword.starts_with("PROJ")) return std::nullopt;
  // Take the unit of all axes, or of the first axis.
  for (const std::string_view item : system.items) {
    WktNode node = node_of(item);
    if (node.keyword == "AXIS")
      for (const std::string_view part : node.items)
        if (WktNode inner = node_of(part); inner.keyword == "LENGTHUNIT") node = std::move(inner);
    if (!is_among(node.keyword, {"UNIT", "LENGTHUNIT"}) || node.items.size() < 2) continue;
    double factor = 0;
    const std::string_view text_of_factor = node.items[1];
    if (std::from_chars(text_of_factor.data(), text_of_factor.data() + text_of_factor.size(), factor).ec == std::errc())
      return factor;
  }
  return std::nullopt;
}

Crs parse_crs(const std::string& text) {
  const std::optional<Crs> crs = system_of_name(text);
  if (!crs)
    bad_usage("--crs", in_quotes(text),
              "an authority and a code, such as EPSG:28992, or EPSG:4326 for longitudes and latitudes");
  if (is_vertical(*crs))
    bad_usage("--crs", in_quotes(text) + ", a system of heights", "a horizontal one, such as EPSG:28992");
  // Accept the range from which EPSG assigns codes of systems, also codes that are not assigned.
  constexpr int least = 1024, greatest = 32767;
  if (crs->authority == "EPSG" &&
      (crs->code.size() > 5 || std::stoi(crs->code) < least || std::stoi(crs->code) > greatest))
    bad_usage("--crs", in_quotes(text),
              "a code as EPSG assigns them, from " + std::to_string(least) + " to " + std::to_string(greatest));
  return *crs;
}

}  // namespace rbpa::app
