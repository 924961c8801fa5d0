#include "io/crs.h"

#include <algorithm>
#include <cctype>

#include "io/failure.h"

namespace rbpa::app {
namespace {

/// Systems of longitude and latitude that are common: WGS 84, ETRS89, NAD83, NAD27 and those of nations. Of any other
/// the file itself must say that it is one.
constexpr std::string_view geographic_codes[] = {
    "4326", "4979", "4258", "4937", "4269", "4267", "4283", "7844", "4171", "4230", "4277", "4289", "4313", "4314",
    "4149", "4150", "4167", "4152", "4612", "6668", "4490", "4610", "4214", "4674", "4618", "4617", "6318", "4275",
    "4231", "4148", "4222", "4164", "4166", "4737", "4756", "4759", "4740", "4284", "4200", "7683", "4124", "4619"};

bool is_word(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
  });
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::optional<Crs> crs_of(std::string_view authority, std::string_view code) {
  if (!is_word(authority) || !is_word(code)) return std::nullopt;
  Crs crs{.authority = upper(authority), .code = upper(code)};
  if (crs.authority == "CRS") crs.authority = "OGC";  // CRS:84, as WMS has it
  if (crs.authority == "OGC" && crs.code == "84") crs.code = "CRS84";
  if (crs.authority == "EPSG" && !std::all_of(code.begin(), code.end(), [](char c) { return c >= '0' && c <= '9'; }))
    return std::nullopt;
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

bool Crs::is_wgs84() const {
  return (authority == "OGC" && code == "CRS84") || (authority == "EPSG" && code == "4326");
}

Crs wgs84() { return {.authority = "EPSG", .code = "4326", .degrees = true}; }

std::optional<Crs> crs_of_name(std::string_view name) {
  const std::string folded = upper(name);
  constexpr std::string_view urn = "URN:OGC:DEF:CRS:";
  for (const std::string_view url : {"HTTP://WWW.OPENGIS.NET/DEF/CRS/", "HTTPS://WWW.OPENGIS.NET/DEF/CRS/"})
    if (folded.starts_with(url)) {  // authority/version/code
      const std::string_view rest = name.substr(url.size());
      return crs_of(rest.substr(0, std::min(rest.find('/'), rest.size())), rest.substr(rest.rfind('/') + 1));
    }
  if (folded.starts_with(urn)) {
    const std::string_view rest = name.substr(urn.size());  // authority:version:code
    return crs_of(rest.substr(0, std::min(rest.find(':'), rest.size())), rest.substr(rest.rfind(':') + 1));
  }
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  return crs_of(name.substr(0, colon), name.substr(colon + 1));
}

std::optional<Crs> crs_of_wkt(std::string_view text) {
  // What stands at depth 1 is about the whole; the systems that it is made of have theirs deeper.
  int depth = 0;
  bool quoted = false;
  std::optional<Crs> found;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '[' || c == '(') ++depth;
    if (c == ']' || c == ')') --depth;
    if (depth != 1 || (c != 'A' && c != 'I')) continue;
    const std::string_view rest = text.substr(i);
    std::size_t at = 0;
    if (rest.starts_with("AUTHORITY[")) at = 10;
    if (rest.starts_with("ID[")) at = 3;
    if (at == 0) continue;
    std::string_view words = rest.substr(at, std::min(rest.find(']'), rest.size()) - std::min(at, rest.size()));
    const std::size_t comma = words.find(',');
    if (comma == std::string_view::npos) continue;
    const auto bare = [](std::string_view word) {
      while (!word.empty() && (word.front() == '"' || word.front() == ' ')) word.remove_prefix(1);
      while (!word.empty() && (word.back() == '"' || word.back() == ' ')) word.remove_suffix(1);
      return word;
    };
    found = crs_of(bare(words.substr(0, comma)), bare(words.substr(comma + 1)));
  }
  if (found && text.substr(0, 3) == "GEO" && !text.starts_with("GEOCCS")) found->degrees = true;
  return found;
}

Crs parse_crs(const std::string& text) {
  const std::optional<Crs> crs = crs_of_name(text);
  if (!crs) throw WrongUsage("--crs: found " + in_quotes(text) + ", expected an authority and a code: EPSG:28992");
  // Codes of systems are given out from this range. Which of them there are only EPSG's tables know.
  constexpr int least = 1024, greatest = 32767;
  if (crs->authority == "EPSG" &&
      (crs->code.size() > 5 || std::stoi(crs->code) < least || std::stoi(crs->code) > greatest))
    throw WrongUsage("--crs: found " + in_quotes(text) + ", expected a code of EPSG, from " + std::to_string(least) +
                     " to " + std::to_string(greatest));
  return *crs;
}

}  // namespace rbpa::app
