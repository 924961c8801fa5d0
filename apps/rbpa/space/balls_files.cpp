#include "space/balls_files.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <string_view>
#include <utility>

#include "io/bytes/number.h"
#include "io/failure.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

/// The groups of the atoms of a frame, in the order in which they begin.
struct Grouped {
  std::vector<std::uint32_t> of;     // group of each atom
  std::vector<std::uint32_t> first;  // first atom of each group
};

Grouped grouped(const std::vector<AtomRow>& rows, AtomGroups groups) {
  using Key = std::array<std::uint64_t, 4>;
  const auto key_of = [&](const AtomRow& row) {
    if (groups == AtomGroups::column) return Key{row.group};
    if (groups == AtomGroups::chain) return Key{row.chain};
    return Key{row.chain, std::bit_cast<std::uint64_t>(row.resseq), row.icode, row.resname};
  };
  Grouped result;
  std::map<Key, std::uint32_t> numbers;
  for (const AtomRow& row : rows) {
    const auto [place, is_new] = numbers.try_emplace(key_of(row), static_cast<std::uint32_t>(result.first.size()));
    if (is_new) result.first.push_back(static_cast<std::uint32_t>(result.of.size()));
    result.of.push_back(place->second);
  }
  return result;
}

/// A reason to leave atoms out, for messages, and its key in JSON.
struct LeftOut {
  std::size_t AtomCounts::*count;
  const char *key, *text;
};
constexpr LeftOut reasons[] = {
    {&AtomCounts::deselected, "where", " by --where"},
    {&AtomCounts::waters, "waters", " of water (--waters keeps them)"},
    {&AtomCounts::ligands, "ligands", " of ligands"},
    {&AtomCounts::hydrogens, "hydrogens", " of hydrogen"},
    {&AtomCounts::alternates, "alternates", " at alternate locations (--alternates keeps them)"}};

std::string range_of(double least, double greatest, int digits) {
  const std::string from = rounded(least, digits), to = rounded(greatest, digits);
  return from == to ? from : from + " to " + to;
}

}  // namespace

std::size_t MeasuredAtoms::buried() const {
  return static_cast<std::size_t>(std::count(with_probe.areas.begin(), with_probe.areas.end(), 0.0));
}

BallRows::BallRows(OutputFile& file, Format format, const BallsRequest& request, const AtomFrame& texts, bool are_atoms,
                   bool of_contacts)
    : file_(file),
      texts_(texts),
      groups_(request.groups),
      has_frames_(request.has_frames),
      are_atoms_(are_atoms),
      of_contacts_(of_contacts),
      row_(file, format, columns(request)) {}

std::vector<std::string> BallRows::columns(const BallsRequest& request) const {
  std::vector<std::string> all;
  const auto add = [&](const std::vector<std::string>& more) { all.insert(all.end(), more.begin(), more.end()); };
  const bool of_groups = groups_ != AtomGroups::none;
  if (has_frames_) add({"frame"});
  if (of_contacts_) {
    add(names(request, "_a"));
    add(names(request, "_b"));
    add(of_groups ? std::vector<std::string>{"contacts", "area", "arc"}
                  : std::vector<std::string>{"area", "arc", "distance"});
  } else {
    add(names(request, ""));
    add({of_groups ? "atoms" : "radius", "area", "volume", "buried"});
  }
  return all;
}

std::vector<std::string> BallRows::names(const BallsRequest& request, const std::string& suffix) const {
  std::vector<std::string> all;
  if (groups_ == AtomGroups::column)
    all = {*request.choice.group};
  else if (groups_ == AtomGroups::chain)
    all = {"chain"};
  else if (groups_ == AtomGroups::residue)
    all = {"chain", "resseq", "icode", "resname"};
  else if (are_atoms_)
    all = {"point", "serial", "chain", "resseq", "icode", "resname", "name", "element"};
  else
    all = {"point"};
  for (std::string& name : all) name += suffix;
  return all;
}

/// Writes the values of names().
void BallRows::write_names(const AtomRow& atom) {
  const auto text = [&](std::uint32_t of) { row_.text(texts_.text(of)); };
  if (groups_ == AtomGroups::column) return text(atom.group);
  if (groups_ == AtomGroups::none) row_.count(atom.index);
  if (groups_ == AtomGroups::none && !are_atoms_) return;
  if (groups_ == AtomGroups::none) row_.number(atom.serial);
  text(atom.chain);
  if (groups_ == AtomGroups::chain) return;
  row_.number(atom.resseq);
  text(atom.icode);
  text(atom.resname);
  if (groups_ == AtomGroups::residue) return;
  text(atom.name);
  text(atom.element);
}

void BallRows::write(const MeasuredAtoms& frame) { of_contacts_ ? write_contacts(frame) : write_atoms(frame); }

void BallRows::write_atoms(const MeasuredAtoms& frame) {
  const std::vector<double>&areas = frame.with_probe.areas, &volumes = frame.with_probe.volumes;
  const auto write_row = [&](const AtomRow& atom, const auto& write_middle, double area, double volume,
                             std::size_t buried) {
    if (has_frames_) row_.count(frame.number);
    write_names(atom);
    write_middle();
    row_.number(area);
    row_.number(volume);
    row_.count(buried);
  };
  if (groups_ == AtomGroups::none) {
    for (std::size_t i = 0; i < frame.rows.size(); ++i)
      write_row(
          frame.rows[i], [&] { row_.number(frame.radii[i]); }, areas[i], volumes[i], areas[i] == 0 ? 1 : 0);
    return;
  }
  struct Sum {
    std::size_t atoms = 0, buried = 0;
    double area = 0, volume = 0;
  };
  const Grouped groups = grouped(frame.rows, groups_);
  std::vector<Sum> sums(groups.first.size());
  for (std::size_t i = 0; i < frame.rows.size(); ++i) {
    Sum& sum = sums[groups.of[i]];
    ++sum.atoms;
    sum.buried += areas[i] == 0 ? 1 : 0;
    sum.area += areas[i];
    sum.volume += volumes[i];
  }
  for (std::size_t g = 0; g < sums.size(); ++g)
    write_row(
        frame.rows[groups.first[g]], [&] { row_.count(sums[g].atoms); }, sums[g].area, sums[g].volume, sums[g].buried);
}

void BallRows::write_contacts(const MeasuredAtoms& frame) {
  const auto write_both = [&](std::uint32_t a, std::uint32_t b) {
    if (has_frames_) row_.count(frame.number);
    write_names(frame.rows[a]);
    write_names(frame.rows[b]);
  };
  if (groups_ == AtomGroups::none) {
    for (const BallContact& contact : frame.with_probe.contacts) {
      write_both(contact.balls[0], contact.balls[1]);
      row_.number(contact.area);
      row_.number(contact.arc);
      row_.number(contact.distance);
    }
    return;
  }
  struct Sum {
    std::size_t contacts = 0;
    double area = 0, arc = 0;
  };
  const Grouped groups = grouped(frame.rows, groups_);
  std::map<std::pair<std::uint32_t, std::uint32_t>, Sum> sums;
  for (const BallContact& contact : frame.with_probe.contacts) {
    const auto pair = std::minmax(groups.of[contact.balls[0]], groups.of[contact.balls[1]]);
    if (pair.first == pair.second) continue;
    Sum& sum = sums[pair];
    ++sum.contacts;
    sum.area += contact.area;
    sum.arc += contact.arc;
  }
  for (const auto& [pair, sum] : sums) {
    write_both(groups.first[pair.first], groups.first[pair.second]);
    row_.count(sum.contacts);
    row_.number(sum.area);
    row_.number(sum.arc);
  }
}

void BallRows::finish() {
  row_.finish();
  file_.finish();
}

Json json_of(const BallFacts& facts) {
  Json report = {{"probe", facts.probe}, {"radii", Json::array()}, {"frames", Json::array()}};
  for (const auto& [of, used] : facts.radii.used())
    report["radii"].push_back({{"element", of.first.empty() ? Json() : Json(printable(of.first))},
                               {"source", of.second},
                               {"least", used.least},
                               {"greatest", used.greatest},
                               {"atoms", used.atoms}});
  for (const BallTotals& frame : facts.frames) {
    Json left_out;
    for (const LeftOut& reason : reasons) left_out[reason.key] = frame.counts.*reason.count;
    report["frames"].push_back({{"frame", frame.number},
                                {"atoms_in_file", frame.counts.in_file},
                                {"atoms", frame.kept},
                                {"left_out", left_out},
                                {"buried", frame.buried},
                                {"volume", frame.volume},
                                {"area", frame.area},
                                {"volume_vdw", frame.volume_without_probe},
                                {"area_vdw", frame.area_without_probe},
                                {"volume_molecular", nullptr},  // not computed
                                {"area_molecular", nullptr}});
  }
  return report;
}

std::vector<std::string> text_of(const BallFacts& facts) {
  const std::size_t count = facts.frames.size();
  std::size_t in_file = 0, kept = 0, buried = 0;
  AtomCounts counts;
  for (const BallTotals& frame : facts.frames) {
    in_file += frame.counts.in_file;
    kept += frame.kept;
    buried += frame.buried;
    for (const LeftOut& reason : reasons) counts.*reason.count += frame.counts.*reason.count;
  }
  std::vector<std::string> lines = {(count == 1 ? "" : counted(count, "frame") + " with ") +
                                    counted(in_file, facts.are_atoms ? "atom" : "point") + ", " + std::to_string(kept) +
                                    " kept"};
  std::vector<std::string> left_out, radii;
  for (const LeftOut& reason : reasons)
    if (counts.*reason.count > 0) left_out.push_back(std::to_string(counts.*reason.count) + reason.text);
  if (!left_out.empty()) lines[0] += "; left out: " + listed(left_out, " and ");
  for (const auto& [of, used] : facts.radii.used())
    radii.push_back((of.first.empty() ? "" : shown(of.first) + " ") + range_of(used.least, used.greatest, 6) + " (" +
                    std::to_string(used.atoms) + ", " + std::string(of.second) + ")");
  lines.push_back("radii: " + listed(radii, ", "));
  const auto range = [&](double BallTotals::*size) {
    const auto less = [&](const BallTotals& a, const BallTotals& b) { return a.*size < b.*size; };
    const auto [least, greatest] = std::minmax_element(facts.frames.begin(), facts.frames.end(), less);
    return range_of((*least).*size, (*greatest).*size, 6);
  };
  std::string sizes = "probe " + text_of(facts.probe) + ": volume " + range(&BallTotals::volume) + ", area " +
                      range(&BallTotals::area) + ", " + std::to_string(buried) + " of " + std::to_string(kept) +
                      " buried";
  if (facts.probe > 0)
    sizes += "; without it (van der Waals): volume " + range(&BallTotals::volume_without_probe) + ", area " +
             range(&BallTotals::area_without_probe);
  lines.push_back(sizes + "; the molecular (Connolly) volume and area are not computed");
  return lines;
}

}  // namespace rbpa::app
