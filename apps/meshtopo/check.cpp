#include "meshtopo/check.h"

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "io/failure.h"
#include "io/number.h"
#include "meshtopo/report_text.h"

namespace rbpa::app {
namespace {

using meshops::SoupDefectKind;

constexpr std::string_view yes_or_no[] = {"closed", "manifold", "oriented", "orientable"};
constexpr std::string_view crossings = "crossings";
constexpr std::string_view counts[] = {"vertices",          "edges",  "faces",   "euler",    "components",
                                       "boundary_curves",   "genus",  "pinches", "isolated", "defects",
                                       "geometric_defects", crossings};

template <std::size_t count>
bool is_among(const std::string_view (&names)[count], std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

Check parse_check(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  if (is_among(yes_or_no, name)) {
    if (equals != std::string::npos) bad_usage("--check", in_quotes(text), "'" + name + "' without a value");
    return {name, std::nullopt};
  }
  if (!is_among(counts, name)) bad_usage("--check", in_quotes(text), "one of " + known_checks());
  const char* const first = text.data() + std::min(equals, text.size() - 1) + 1;
  const char* const last = text.data() + text.size();
  long number = 0;
  const auto [end, error] = std::from_chars(first, last, number);
  if (error != std::errc() || end != last)
    bad_usage("--check", in_quotes(text), name + "=N, N a whole number, such as " + name + "=0");
  return {name, number};
}

long value_of(std::size_t number) { return static_cast<long>(number); }

/// Returns the number in the report that the check `name` compares, or nothing for the genus of a mesh without a genus.
std::optional<long> count_of(std::string_view name, const Examined& mesh) {
  const meshops::TopologyReport& t = mesh.topology;
  if (name == "euler") return t.euler();
  if (name == "genus") return t.genus;
  const std::pair<std::string_view, std::size_t> numbers[] = {{"vertices", t.vertices},
                                                              {"edges", t.edges},
                                                              {"faces", t.faces},
                                                              {"components", t.components},
                                                              {"boundary_curves", t.boundary_curves},
                                                              {"pinches", t.pinches},
                                                              {"isolated", t.isolated},
                                                              {"defects", mesh.defects.size()},
                                                              {"geometric_defects", mesh.geometric_defects.size()},
                                                              {crossings, mesh.crossings}};
  return value_of(
      std::find_if(std::begin(numbers), std::end(numbers), [&](const auto& n) { return n.first == name; })->second);
}

/// Returns the counts of defects of `kinds`, such as "2 non-manifold edges and 1 pinch"; "" if there are none.
std::string counted_kinds(const Examined& mesh, std::initializer_list<SoupDefectKind> kinds) {
  std::vector<std::string> parts;
  for (const SoupDefectKind kind : kinds) {
    const auto count =
        std::count_if(mesh.defects.begin(), mesh.defects.end(), [&](const auto& d) { return d.kind == kind; });
    if (count == 0) continue;
    std::string noun(meshops::name(kind));
    if (kind == SoupDefectKind::pinch && count > 1) noun = "pinche";  // counted() appends the s of "pinches"
    if (kind == SoupDefectKind::not_orientable) {
      parts.push_back(counted(static_cast<std::size_t>(count), "component") + " not orientable");
      continue;
    }
    parts.push_back(counted(static_cast<std::size_t>(count), noun));
  }
  return listed(parts, " and ");
}

CheckResult of_kinds(const Check& check, const Examined& mesh, std::initializer_list<SoupDefectKind> kinds) {
  const std::string found = counted_kinds(mesh, kinds);
  return {check, found.empty(), found, "none", std::nullopt};
}

}  // namespace

std::vector<Check> parse_checks(const std::string& list) {
  std::vector<Check> checks;
  for (const std::string_view text : split_at_commas(list)) checks.push_back(parse_check(std::string(text)));
  return checks;
}

bool requires_crossings(const std::vector<Check>& checks) {
  return std::any_of(checks.begin(), checks.end(), [](const Check& check) { return check.name == crossings; });
}

std::string known_checks() {
  std::string text;
  for (const std::string_view name : yes_or_no) text.append(name).append(", ");
  for (const std::string_view name : counts) text.append(name).append("=N, ");
  return text.substr(0, text.size() - 2);
}

CheckResult evaluate(const Check& check, const Examined& mesh) {
  if (check.name == "closed") {
    const meshops::TopologyReport& t = mesh.topology;
    if (t.faces == 0) return {check, false, "no face", "a closed surface", std::nullopt};
    return {check, t.boundary_curves == 0, counted(t.boundary_curves, "boundary curve"), "none", std::nullopt};
  }
  if (check.name == "manifold")
    return of_kinds(check, mesh,
                    {SoupDefectKind::degenerate_face, SoupDefectKind::duplicate_face, SoupDefectKind::non_manifold_edge,
                     SoupDefectKind::pinch});
  if (check.name == "oriented")
    return of_kinds(check, mesh, {SoupDefectKind::inconsistent_orientation, SoupDefectKind::not_orientable});
  if (check.name == "orientable") return of_kinds(check, mesh, {SoupDefectKind::not_orientable});
  const std::optional<long> found = count_of(check.name, mesh);
  return {check, found == check.number, found ? std::to_string(*found) : genus_text(mesh.topology),
          std::to_string(*check.number), found};
}

std::string failure_of(const CheckResult& result) {
  return result.check.name + ": found " + result.found + ", expected " + result.expected;
}

}  // namespace rbpa::app
