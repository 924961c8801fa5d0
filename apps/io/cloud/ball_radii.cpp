#include "io/cloud/ball_radii.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "io/cloud/chemical_elements.h"
#include "io/failure.h"
#include "io/number.h"
#include "io/text/lines.h"
#include "io/text/plain_text.h"

namespace rbpa::app {
namespace {

/// The carbons of side chains that have three bonds: without a hydrogen and with one.
struct SideChain {
  std::string_view residues, bare, with_hydrogen;
};
constexpr SideChain side_chains[] = {{"ARG", "CZ", ""},
                                     {"ASN ASP ASH", "CG", ""},
                                     {"GLN GLU GLH", "CD", ""},
                                     {"HIS HID HIE HIP HSD HSE HSP", "CG", "CD2 CE1"},
                                     {"PHE", "CG", "CD1 CD2 CE1 CE2 CZ"},
                                     {"TYR", "CG CZ", "CD1 CD2 CE1 CE2"},
                                     {"TRP", "CG CD2 CE2", "CD1 CE3 CZ2 CZ3 CH2"}};

}  // namespace

std::optional<double> protor_radius(std::string_view residue, std::string_view name) {
  if (residue != "MSE" && !is_amino_acid(residue)) return std::nullopt;
  for (const SideChain& chain : side_chains) {
    if (!is_word_of(residue, chain.residues)) continue;
    if (is_word_of(name, chain.bare)) return 1.61;
    if (is_word_of(name, chain.with_hydrogen)) return 1.76;
  }
  constexpr std::pair<std::string_view, double> others[] = {
      {"C", 1.61},         {"CA CB CG CG1 CG2 CD CD1 CD2 CE", 1.88},  {"O OXT OT1 OT2 OD1 OD2 OE1 OE2", 1.42},
      {"OG OG1 OH", 1.46}, {"N ND1 ND2 NE NE1 NE2 NH1 NH2 NZ", 1.64}, {"SG SD", 1.77}};
  for (const auto& [names, radius] : others)
    if (is_word_of(name, names)) return radius;
  return std::nullopt;
}

BallRadii::BallRadii(const std::optional<std::string>& choice, std::optional<double> otherwise)
    : otherwise_(otherwise) {
  constexpr std::string_view column = "column:";
  if (otherwise && !(*otherwise >= 0 && std::isfinite(*otherwise)))
    throw WrongUsage("--radius-default: found " + text_of(*otherwise) + ", expected a number of at least 0");
  if (!choice) return;
  if (choice->starts_with(column)) {
    column_ = choice->substr(column.size());
    if (column_->empty()) throw WrongUsage("--radii: found column: and no name, expected column:NAME");
    return;
  }
  has_table_ = true;
  is_protor_ = *choice == "protor";
  if (!is_protor_ && *choice != "bondi") read(*choice);
}

void BallRadii::read(const std::string& path) {
  const bool is_number = parse_whole_number(path).fault == NumberFault::none;
  const InputBytes input(
      path, "a file of radii, or bondi, protor or column:NAME" + (is_number ? " (--radius-default " + path + ")" : ""));
  std::string room;
  for (Lines lines(plain_text(input.bytes(), path, room)); lines.next();) {
    const std::vector<std::string_view> words = split_words(lines.line().substr(0, lines.line().find('#')));
    if (words.empty()) continue;
    const auto refuse = [&](const std::string& expected) {
      bad_input(at_line(path, lines.number()), in_quotes(lines.line()), expected);
    };
    const ParsedNumber radius = parse_whole_number(words.back());
    const Element* const element = words.size() == 2 ? find_element(words[0]) : nullptr;
    if ((element == nullptr && words.size() != 3) || radius.fault != NumberFault::none || radius.value < 0)
      refuse("'ELEMENT RADIUS', 'RESIDUE ATOM RADIUS' or '* ATOM RADIUS'");
    const bool is_element = words.size() == 2;
    const std::pair key(is_element ? "" : std::string(words[0]), std::string(is_element ? element->symbol : words[1]));
    if (!overrides_.emplace(key, radius.value).second) refuse("one radius for each element and each atom");
  }
}

void BallRadii::override_element(const std::string& symbol, double radius) {
  const Element* const element = find_element(symbol);
  if (element == nullptr) throw WrongUsage("overrides: found " + in_quotes(symbol) + ", expected an element");
  if (!(radius >= 0 && std::isfinite(radius)))
    throw WrongUsage("overrides: found " + text_of(radius) + " for " + symbol + ", expected a number of at least 0");
  overrides_[{"", std::string(element->symbol)}] = radius;
}

std::pair<double, std::string_view> BallRadii::find(const AtomFrame& frame, const AtomRow& atom,
                                                    const std::string& name) const {
  const std::string &symbol = frame.text(atom.element), &residue = frame.text(atom.resname),
                    &of_atom = frame.text(atom.name);
  if (!has_table_ && frame.has_radii) return {atom.radius, "file"};
  for (const auto& key : {std::pair(residue, of_atom), {"*", of_atom}, {"", symbol}})
    if (const auto found = overrides_.find(key); found != overrides_.end()) return {found->second, "override"};
  const std::string where = atom.line > 0 ? at_line(name, atom.line) : name;
  if (is_protor_) {
    if (const std::optional<double> radius = protor_radius(residue, of_atom)) return {*radius, "ProtOr"};
    if (is_hydrogen(symbol) && is_amino_acid(residue))
      bad_input(where, "hydrogen, " + frame.title(atom), "none, as ProtOr's radii include it (--no-hydrogens)");
  }
  if (const Element* const element = find_element(symbol); element != nullptr && element->radius > 0)
    return {element->radius, source_of_radius(symbol)};
  if (otherwise_) return {*otherwise_, "default"};
  if (atom.line == 0 && symbol.empty() && of_atom.empty())
    bad_input(name, "points without radii", "radii (--radii column:NAME, or --radius-default R)");
  bad_input(
      where, (symbol.empty() ? "no element" : "element " + in_quotes(symbol)) + " of " + frame.title(atom),
      "one with a radius of Bondi, Mantina or Alvarez (--radii FILE names its radius, --radius-default R is for all "
      "without one)");
}

std::vector<double> BallRadii::of(const AtomFrame& frame, const std::string& name) {
  std::vector<double> radii;
  radii.reserve(frame.rows.size());
  // Find a radius once for atoms with equal element, name and residue, unless the file of atoms has the radii.
  using Kind = std::array<std::uint32_t, 3>;
  std::map<Kind, std::pair<double, UsedRadii*>> known;
  for (const AtomRow& atom : frame.rows) {
    const auto [place, is_new] = known.try_emplace(Kind{atom.element, atom.name, atom.resname});
    auto& [radius, used] = place->second;
    if (is_new || (!has_table_ && frame.has_radii)) {
      const auto [found, source] = find(frame, atom, name);
      radius = found;
      used = &used_.try_emplace({frame.text(atom.element), source}, UsedRadii{found, found, 0}).first->second;
      used->least = std::min(used->least, found);
      used->greatest = std::max(used->greatest, found);
    }
    ++used->atoms;
    radii.push_back(radius);
  }
  return radii;
}

}  // namespace rbpa::app
