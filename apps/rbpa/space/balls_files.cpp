#include "space/balls_files.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <type_traits>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/words.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

/// A reason why atoms are left out: its count, its key in JSON, and its text.
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

std::vector<NameColumn> names_of(AtomGroups groups, const std::string& column, bool are_atoms) {
  if (groups == AtomGroups::column) return {{column, &AtomRow::group}};
  if (groups == AtomGroups::chain) return {{"chain", &AtomRow::chain}};
  std::vector<NameColumn> names = {{"chain", &AtomRow::chain},
                                   {"resseq", nullptr, &AtomRow::resseq},
                                   {"icode", &AtomRow::icode},
                                   {"resname", &AtomRow::resname}};
  if (groups == AtomGroups::residue) return names;
  if (!are_atoms) return {};
  names.insert(names.begin(), {"serial", nullptr, &AtomRow::serial});
  names.insert(names.end(), {{"name", &AtomRow::name}, {"element", &AtomRow::element}, {"record", &AtomRow::record}});
  return names;
}

std::string range_of(double least, double greatest) {
  const std::string from = rounded(least, 6), to = rounded(greatest, 6);
  return from == to ? from : from + " to " + to;
}

}  // namespace

template <typename Value>
void BallRows::put(const Value& value) {
  file_.write(std::exchange(before_, ","));
  if constexpr (std::is_convertible_v<const Value&, std::string_view>)
    file_.write(csv_text(value));
  else if (!std::isnan(static_cast<double>(value)))  // a missing number is an empty field
    file_.write_number(value);
}

template <typename... Values>
void BallRows::end_row(Values... values) {
  (put(values), ...);
  file_.write("\n");
  before_ = "";
}

BallRows::BallRows(OutputFile& file, Of of, AtomGroups groups, const std::string& column, bool has_frames,
                   const AtomFrame& texts, bool are_atoms, bool has_cells)
    : file_(file),
      of_(of),
      groups_(groups),
      has_frames_(has_frames),
      texts_(texts),
      names_(names_of(groups, column, are_atoms)) {
  if (has_frames) put("frame");
  const bool is_atom = groups == AtomGroups::none;
  for (const std::string suffix : of == Of::atoms ? std::vector{""} : std::vector{"_a", "_b"}) {
    if (is_atom) put("point" + suffix);
    for (const NameColumn& name : names_) put(name.name + suffix);
  }
  if (of == Of::interfaces)
    end_row("area_a", "area_b", "contact_area");
  else if (of == Of::atoms)
    end_row(is_atom ? "radius" : "atoms", "area", "volume", "buried");
  else if (is_atom && has_cells)
    end_row("area", "arc", "distance", "offset_1", "offset_2", "offset_3");
  else if (is_atom)
    end_row("area", "arc", "distance");
  else
    end_row("contacts", "area", "arc");
}

/// Begins a row with the frame, if rows have one, and the names of the atoms.
void BallRows::begin_row(const MeasuredAtoms& frame, std::span<const std::uint32_t> atoms) {
  stop_if_interrupted();
  if (has_frames_) put(std::uint64_t{frame.number});
  for (const std::uint32_t i : atoms) {
    const AtomRow& atom = frame.rows[i];
    if (groups_ == AtomGroups::none) put(std::uint64_t{atom.index});
    for (const NameColumn& name : names_) name.text ? put(texts_.text(atom.*name.text)) : put(atom.*name.number);
  }
}

BallRows::Grouped BallRows::grouped(const std::vector<AtomRow>& rows) const {
  Grouped result;
  std::map<std::array<std::uint64_t, 4>, std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    std::uint32_t group = i;
    if (groups_ != AtomGroups::none) {
      std::array<std::uint64_t, 4> key{};
      for (std::size_t k = 0; k < names_.size(); ++k)
        key[k] = names_[k].text ? rows[i].*names_[k].text : std::bit_cast<std::uint64_t>(rows[i].*names_[k].number);
      group = numbers.try_emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second;
    }
    if (group == result.first.size()) result.first.push_back(i);
    result.of.push_back(group);
  }
  return result;
}

void BallRows::write_atoms(const MeasuredAtoms& frame) {
  struct Sum {
    std::uint64_t atoms = 0, buried = 0;
    double area = 0, volume = 0;
  };
  const Grouped groups = grouped(frame.rows);
  std::vector<Sum> sums(groups.first.size());
  for (std::size_t i = 0; i < frame.rows.size(); ++i) {
    Sum& sum = sums[groups.of[i]];
    ++sum.atoms;
    sum.buried += frame.balls.areas[i] == 0 ? 1U : 0U;
    sum.area += frame.balls.areas[i];
    sum.volume += frame.balls.volumes[i];
  }
  for (std::size_t g = 0; g < sums.size(); ++g) {
    begin_row(frame, {&groups.first[g], 1});
    groups_ == AtomGroups::none ? put(frame.radii[g]) : put(sums[g].atoms);
    end_row(sums[g].area, sums[g].volume, sums[g].buried);
  }
}

void BallRows::write_contacts(const MeasuredAtoms& frame) {
  struct Sum {
    std::uint64_t contacts = 0;
    double area = 0, arc = 0;
  };
  const Grouped groups = grouped(frame.rows);
  std::map<std::array<std::uint32_t, 2>, Sum> sums;  // of contacts between different groups
  for (std::size_t k = 0; k < frame.balls.contacts.size(); ++k) {
    const BallContact& contact = frame.balls.contacts[k];
    if (groups_ == AtomGroups::none) {
      begin_row(frame, contact.balls);
      put(contact.area);
      put(contact.arc);
      put(contact.distance);
      if (frame.cell)
        for (const std::int32_t offset : frame.balls.contact_offsets[k]) put(std::to_string(offset));
      end_row();
      continue;
    }
    const auto [a, b] = std::minmax(groups.of[contact.balls[0]], groups.of[contact.balls[1]]);
    if (a == b) continue;
    Sum& sum = sums[{a, b}];
    ++sum.contacts;
    sum.area += contact.area;
    sum.arc += contact.arc;
  }
  for (const auto& [pair, sum] : sums) {
    begin_row(frame, std::array{groups.first[pair[0]], groups.first[pair[1]]});
    end_row(sum.contacts, sum.area, sum.arc);
  }
}

void BallRows::write_interfaces(const MeasuredAtoms& frame) {
  const Grouped groups = grouped(frame.rows);
  for (const BallInterface& of : frame.interfaces.all) {
    begin_row(frame, std::array{groups.first[of.groups[0]], groups.first[of.groups[1]]});
    end_row(of.areas[0], of.areas[1], of.contact_area);
  }
}

Json json_of(double probe, const BallRadii& radii, const std::vector<BallTotals>& frames) {
  Json report = {{"probe", probe}, {"radii", Json::array()}, {"frames", Json::array()}};
  for (const auto& [of, used] : radii.used())
    report["radii"].push_back({{"element", of.first.empty() ? Json() : Json(printable(of.first))},
                               {"source", of.second},
                               {"least", used.least},
                               {"greatest", used.greatest},
                               {"atoms", used.atoms}});
  for (const BallTotals& frame : frames) {
    Json left_out;
    for (const LeftOut& reason : reasons) left_out[reason.key] = frame.counts.*reason.count;
    report["frames"].push_back({{"frame", frame.number},
                                {"atoms_in_file", frame.counts.in_file},
                                {"left_out", left_out},
                                {"atoms", frame.kept},
                                {"buried", frame.buried},
                                {"cell_volume", frame.cell_volume ? Json(*frame.cell_volume) : Json()},
                                {"volume", frame.volume},
                                {"area", frame.area},
                                {"volume_vdw", frame.volume_without_probe},
                                {"area_vdw", frame.area_without_probe}});
    if (frame.pores)
      report["frames"].back()["pores"] = {{"radius_included", frame.pores->included},
                                          {"radius_passing", frame.pores->passing},
                                          {"radius_on_the_way", frame.pores->on_the_way},
                                          {"radii_along_edges", frame.pores->along}};
  }
  return report;
}

std::vector<std::string> text_of(double probe, const BallRadii& radii, const std::vector<BallTotals>& frames,
                                 const std::string& noun) {
  const auto sum = [&](const auto& count) {
    std::size_t all = 0;
    for (const BallTotals& frame : frames) all += count(frame);
    return all;
  };
  const auto range = [&](double BallTotals::*size) {
    const auto less = [&](const BallTotals& a, const BallTotals& b) { return a.*size < b.*size; };
    const auto [least, greatest] = std::minmax_element(frames.begin(), frames.end(), less);
    return range_of((*least).*size, (*greatest).*size);
  };
  const std::string kept = std::to_string(sum([](const BallTotals& frame) { return frame.kept; }));
  const std::string of_all = frames.size() == 1 ? "" : " in all frames";
  std::vector<std::string> left_out, used_radii;
  for (const LeftOut& reason : reasons)
    if (const std::size_t count = sum([&](const BallTotals& frame) { return frame.counts.*reason.count; }); count > 0)
      left_out.push_back(std::to_string(count) + reason.text);
  for (const auto& [of, used] : radii.used())
    used_radii.push_back((of.first.empty() ? "" : shown(of.first) + " ") + range_of(used.least, used.greatest) + " (" +
                         std::to_string(used.atoms) + ", " + std::string(of.second) + ")");
  return {(frames.size() == 1 ? "" : counted(frames.size(), "frame") + " with ") +
              counted(sum([](const BallTotals& frame) { return frame.counts.in_file; }), noun) + ", " + kept + " kept" +
              (left_out.empty() ? "" : "; left out: " + listed(left_out, " and ")),
          "radii" + of_all + ": " + listed(used_radii, ", "),
          "probe " + text_of(probe) + ": volume " + range(&BallTotals::volume) + ", area " + range(&BallTotals::area) +
              ", " + std::to_string(sum([](const BallTotals& frame) { return frame.buried; })) + " of " + kept +
              " buried" + of_all +
              (probe == 0 ? ""
                          : "; without it (van der Waals): volume " + range(&BallTotals::volume_without_probe) +
                                ", area " + range(&BallTotals::area_without_probe))};
}

}  // namespace rbpa::app
