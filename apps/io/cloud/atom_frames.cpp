#include "io/cloud/atom_frames.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <map>
#include <utility>

#include "io/cloud/chemical_elements.h"
#include "io/cloud/read_space_points.h"
#include "io/cloud/table_beginning.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/text/plain_text.h"
#include "io/text/signature.h"
#include "io/utf8.h"
#include "meshops/core/large_pages.h"
#include "rbpa/base/read_ahead.h"

namespace rbpa::app {
namespace {

/// Keeps one location of each atom, and returns the number of removed rows. A residue has the location of its atom with
/// the highest occupancy, of equal occupancies the first letter. An atom without this location keeps its own best one.
/// If locations have different residue names, atoms with names other than that of the location are removed.
std::size_t keep_best_locations(AtomFrame& frame) {
  const auto is_better = [&](const AtomRow& row, const AtomRow& than) {
    const double a = std::isnan(row.occupancy) ? 0 : row.occupancy, b = std::isnan(than.occupancy) ? 0 : than.occupancy;
    return a > b || (a == b && frame.text(row.altloc) < frame.text(than.altloc));
  };
  std::map<Residue, const AtomRow*> best;  // an atom with the best location, of each residue with locations
  for (const AtomRow& row : frame.rows) {
    if (row.altloc == 0) continue;
    const auto [place, is_new] = best.try_emplace(residue_of(row), &row);
    if (!is_new && is_better(row, *place->second)) place->second = &row;
  }
  if (best.empty()) return 0;
  std::vector<char> leaves(frame.rows.size(), 0);
  std::map<std::pair<Residue, std::uint32_t>, std::size_t> kept;  // the atom kept, by name in such a residue
  for (std::size_t i = 0; i < frame.rows.size(); ++i) {
    const AtomRow& row = frame.rows[i];
    const auto residue = best.find(residue_of(row));
    if (residue == best.end()) continue;
    const AtomRow& chosen = *residue->second;
    leaves[i] = row.altloc != 0 && row.resname != chosen.resname ? 1 : 0;
    if (leaves[i] != 0) continue;
    const auto [place, is_new] = kept.try_emplace({residue->first, row.name}, i);
    const AtomRow& other = frame.rows[place->second];
    if (is_new || row.altloc == other.altloc) continue;
    const bool wins = row.altloc == chosen.altloc || (other.altloc != chosen.altloc && is_better(row, other));
    leaves[wins ? std::exchange(place->second, i) : i] = 1;
  }
  return std::erase_if(
      frame.rows, [&](const AtomRow& row) { return leaves[static_cast<std::size_t>(&row - frame.rows.data())] != 0; });
}

/// Returns the number in a column; NaN for any other text, such as serials in base 16.
double number_if_any(const Atom& atom, std::size_t column) {
  const ParsedNumber number = parse_whole_number(atom.fields[column]);
  return number.fault == NumberFault::none ? number.value : AtomRow::none;
}

void require_radius(double radius, const std::string& where) {
  if (!(radius >= 0 && std::isfinite(radius)))
    bad_input(where, (std::isnan(radius) ? "no number" : in_quotes(text_of(radius))) + " as a radius",
              "a number of at least 0");
}

/// Atoms that are read together; then an exception for the next one.
struct AtomBatch {
  struct Values {
    AtomRow row = {};  // without texts
    std::string_view element = {};
    std::exception_ptr failure = nullptr;  // of a number of the atom, which counts unless the atom is left out
  };
  std::vector<Atom> atoms = {};
  std::vector<Values> values = {};
  std::exception_ptr failure = nullptr;
};

/// Returns a function that reads the next atoms of a frame; it returns false at the end.
std::function<bool(AtomBatch&)> batches_of(AtomSource& source) {
  return [&source, ended = false](AtomBatch& batch) mutable {
    constexpr std::size_t most = 256;
    while (!ended && batch.atoms.size() < most) {
      try {
        ended = !source.next(batch.atoms.emplace_back());
      } catch (...) {
        batch.failure = std::current_exception();
        ended = true;
      }
      if (ended) batch.atoms.pop_back();
    }
    return !batch.atoms.empty() || batch.failure;
  };
}

/// Finds the values of each atom but texts; `radius` is the column of radii.
void find_values(AtomBatch& batch, const AtomSource& source, std::optional<std::size_t> radius,
                 const std::string& name) {
  std::string residue;  // whose atoms are of water if `of_water`
  bool of_water = false;
  batch.values.resize(batch.atoms.size());
  for (std::size_t i = 0; i < batch.atoms.size(); ++i) {
    const Atom& atom = batch.atoms[i];
    auto& [row, element, failure] = batch.values[i];
    if (residue != atom.fields[AtomColumn::resname]) {
      residue = atom.fields[AtomColumn::resname];
      of_water = is_water(residue);
    }
    row.line = atom.line;
    row.is_water = of_water;
    element = element_of(atom);
    for (const auto& [column, number] : {std::pair(AtomColumn::serial, &AtomRow::serial),
                                         {AtomColumn::resseq, &AtomRow::resseq},
                                         {AtomColumn::occupancy, &AtomRow::occupancy},
                                         {AtomColumn::bfactor, &AtomRow::bfactor},
                                         {AtomColumn::charge, &AtomRow::charge}})
      row.*number = number_if_any(atom, column);
    try {
      row.center = source.center(atom);
      if (!radius) continue;
      row.radius = source.number(atom, *radius);
      require_radius(row.radius, at_line(name, atom.line));
    } catch (const BadInput&) {
      failure = std::current_exception();
    }
  }
}

}  // namespace

std::uint32_t AtomFrame::number_of(std::string_view text, std::uint32_t likely) {
  if (likely < texts.size() && texts[likely] == text) return likely;
  const auto [place, is_new] = numbers.try_emplace(as_utf8(text), static_cast<std::uint32_t>(texts.size()));
  if (is_new) texts.push_back(place->first);
  return place->second;
}

std::string AtomFrame::title(const AtomRow& row) const {
  std::string title = "atom " + (row.name == 0 ? std::to_string(row.index) : text(row.name));
  if (row.resname != 0) title += " of residue " + text(row.resname);
  if (row.chain != 0) title += ' ' + text(row.chain);
  if (!std::isnan(row.resseq)) title += ' ' + text_of(row.resseq) + text(row.icode);
  return shown(title);
}

bool FrameChoice::has(std::size_t number) const {
  if (!all) return std::binary_search(numbers.begin(), numbers.end(), number);
  return number >= first && (number - first) % step == 0;
}

FrameChoice parse_frames(const std::string& option, const std::string& text) {
  constexpr std::size_t most = 10'000'000;
  if (text == "all") return {.all = true};
  FrameChoice choice{.numbers = {}};
  const auto require = [&](bool is_right) {
    if (!is_right)
      bad_usage(option, in_quotes(text), "all, numbers from 1 such as 1,3,10-20, or FIRST:LAST:STEP such as 1:1000:10");
  };
  const auto number = [&](std::string_view word) {
    const auto found = parse_count(word);
    require(found && *found >= 1 && *found <= most);
    return *found;
  };
  const auto add = [&](std::string_view first, std::string_view last, std::string_view step) {
    const std::size_t end = number(last), by = number(step);
    std::size_t i = number(first);
    require(i <= end);
    for (; i <= end; i += by) choice.numbers.push_back(i);
  };
  if (std::vector<std::string_view> parts = split_at(text, ':'); parts.size() > 1) {
    require(parts.size() <= 3);
    parts.resize(3, "1");
    if (parts[1].empty()) return {.all = true, .first = number(parts[0]), .step = number(parts[2])};
    add(parts[0], parts[1], parts[2]);
    return choice;
  }
  for (const std::string_view part : split_at(text, ',')) {
    const std::vector<std::string_view> ends = split_at(part, '-');
    require(ends.size() <= 2);
    add(ends.front(), ends.back(), "1");
  }
  std::sort(choice.numbers.begin(), choice.numbers.end());
  return choice;
}

AtomFrames::AtomFrames(const std::string& path, Format format, AtomChoice choice)
    : input_(std::in_place, path, "a file of atoms", decompression_of(format, path)),
      name_(input_->name()),
      format_(format),
      choice_(std::move(choice)) {
  open(input_->bytes());
}

AtomFrames::AtomFrames(std::string_view bytes, std::string name, Format format, AtomChoice choice)
    : name_(std::move(name)), format_(format), choice_(std::move(choice)) {
  open(bytes);
}

void AtomFrames::open(std::string_view bytes) {
  if (bytes.empty()) bad_input(name_, "an empty file", "atoms");
  if (format_ == Format::by_content) format_ = format_of_content(Use::space, bytes, name_, Format::text);
  bytes_ = plain_text(bytes, name_, format_, room_);
  OpenAtoms open_atoms = atoms_of(format_);
  if (format_ == Format::text && find_xyz_atoms(bytes_, true)) open_atoms = xyz_atoms;
  if (open_atoms == nullptr) return;
  source_ = open_atoms(bytes_, name_, choice_.frames.all || choice_.frames.required() > 1);
  is_begun_ = source_->next_frame();
  frames_ = 1;
  if (choice_.where) selection_.emplace(Condition(*choice_.where, *fields_of(format_)), *source_);
  if (choice_.radius || source_->has_radii())
    radius_ = choice_.radius ? source_->column(*choice_.radius) : AtomColumn::radius;
  if (choice_.group) group_ = source_->column(*choice_.group);
}

bool AtomFrames::next(AtomFrame& frame) {
  while (is_begun_ || (source_ ? source_->next_frame() : frames_ == 0)) {
    frames_ += is_begun_ ? 0 : 1;
    is_begun_ = false;
    if (!choice_.frames.has(frames_)) continue;
    frame.number = frames_;
    frame.rows.clear();
    frame.counts = {};
    frame.cell = {};
    frame.number_of("");
    source_ ? read_atoms(frame) : read_points(frame);
    const std::size_t atoms = frame.counts.in_file - frame.counts.waters;
    if (first_.number == 0) first_ = {frame.number, atoms};
    if (other_.number == 0 && atoms != first_.atoms) other_ = {frame.number, atoms};
    return true;
  }
  if (source_) frames_ = source_->frames();
  const std::size_t last = choice_.frames.required();
  if (last > frames_) bad_input(name_, counted(frames_, "frame"), "frame " + std::to_string(last));
  if (!source_ || !warnings_.empty()) return false;
  if (source_->blocks() > 1)
    warnings_.push_back("the atoms are those of the first of " + std::to_string(source_->blocks()) + " blocks of data");
  if (frames_ > 1 && !choice_.frames.may_have_several())
    warnings_.push_back("the atoms are those of frame " + std::to_string(last) + " of " + std::to_string(frames_));
  if (other_.number != 0)
    warnings_.push_back("frame " + std::to_string(other_.number) + " has " + counted(other_.atoms, "atom") +
                        ", frame " + std::to_string(first_.number) + " has " + std::to_string(first_.atoms) +
                        ": is the file whole?");
  if (!source_->remark().empty()) warnings_.emplace_back(source_->remark());
  return false;
}

void AtomFrames::read_atoms(AtomFrame& frame) {
  AtomCounts& counts = frame.counts;
  const auto leave_out = [](bool is_left_out, std::size_t& count) {
    count += is_left_out ? 1 : 0;
    return is_left_out;
  };
  const auto is_left_out_water = [&](const Atom& atom, const AtomRow& row) {
    return row.is_water && !choice_.waters &&
           !(selection_ && selection_->names_residue(atom.fields[AtomColumn::resname]));
  };
  frame.has_radii = radius_.has_value();
  if (!choice_.frames.may_have_several()) {
    // Growing would touch each row twice. Memory that is reserved and not used is never touched.
    constexpr std::size_t least_line = 32, most_rows = 10'000'000;
    meshops::reserve_in_large_pages(frame.rows, std::min(bytes_.size() / least_line, most_rows));
  }
  const auto take = [&](const Atom& atom, AtomBatch::Values& values) {
    AtomRow& row = values.row;
    row.index = counts.in_file++;
    if (leave_out(is_left_out_water(atom, row), counts.waters)) return;
    if (leave_out(selection_ && !selection_->holds(atom), counts.deselected)) return;
    if (leave_out(atom.is_hetero() && !row.is_water && !choice_.ligands, counts.ligands)) return;
    if (leave_out(!choice_.hydrogens && is_hydrogen(values.element), counts.hydrogens)) return;
    if (values.failure) std::rethrow_exception(values.failure);
    const AtomRow& before = frame.rows.empty() ? row : frame.rows.back();
    for (const auto& [column, text] : {std::pair(AtomColumn::name, &AtomRow::name),
                                       {AtomColumn::resname, &AtomRow::resname},
                                       {AtomColumn::chain, &AtomRow::chain},
                                       {AtomColumn::icode, &AtomRow::icode},
                                       {AtomColumn::altloc, &AtomRow::altloc},
                                       {AtomColumn::record, &AtomRow::record}})
      row.*text = frame.number_of(atom.fields[column], before.*text);
    if (group_) row.group = frame.number_of(AtomSource::text(atom, *group_), before.group);
    const std::string_view element = values.element.empty() ? atom.fields[AtomColumn::element] : values.element;
    row.element = frame.number_of(element, before.element);
    frame.rows.push_back(row);
  };
  ReadAhead<AtomBatch> batches(choice_.threads == 1 ? 0 : 1, 4, batches_of(*source_),
                               [&](AtomBatch& batch) { find_values(batch, *source_, radius_, name_); });
  for (AtomBatch batch; batches.next(batch); stop_if_interrupted()) {
    for (std::size_t i = 0; i < batch.atoms.size(); ++i) take(batch.atoms[i], batch.values[i]);
    if (batch.failure) std::rethrow_exception(batch.failure);
  }
  frame.cell = source_->cell();
  if (!choice_.alternates) counts.alternates = keep_best_locations(frame);
  if (!frame.rows.empty()) return;
  if (counts.waters == counts.in_file)
    bad_input(name_, "no atoms but those of water", "others (--waters reads water too)");
  bad_input(name_, "no atom in frame " + std::to_string(frame.number) + " that is not left out", "at least one");
}

/// Reads points that are no atoms.
void AtomFrames::read_points(AtomFrame& frame) {
  CloudRequest request{.threads = choice_.threads};
  const std::optional<FieldNames> names = fields_of(format_);
  std::vector<WantedColumn> columns;
  if (choice_.radius) columns.push_back({.name = *choice_.radius});
  if (choice_.group && choice_.group != choice_.radius)
    columns.push_back({.name = *choice_.group,
                       .kind = names && names->texts ? WantedColumn::Kind::by_value : WantedColumn::Kind::number});
  if (choice_.where || !columns.empty()) {
    const std::string option = choice_.radius ? "--radii" : "--group";
    require_format(names.has_value(), choice_.where ? "--where" : option, "without fields", with_fields(Use::space));
    request.where = Condition(choice_.where.value_or(""), *names, columns, option);
  }
  SpacePoints file = space_points_in(bytes_, name_, format_, request);
  if (file.points.empty()) bad_input(name_, "no points", "at least one");
  frame.has_radii = choice_.radius.has_value();
  for (std::size_t i = 0; i < file.points.size(); ++i) {
    AtomRow& row = frame.rows.emplace_back();
    row.center = file.points[i];
    row.index = file.index.empty() ? i : file.index[i];
    if (choice_.group) {
      const std::size_t k = columns.size() - 1;
      const double value = file.fields[k][i];
      const bool is_text = k < file.texts.size() && file.texts[k];
      row.group = frame.number_of(is_text ? (*file.texts[k])[static_cast<std::size_t>(value)] : text_of(value));
    }
    if (!frame.has_radii) continue;
    row.radius = file.fields[0][i];
    require_radius(row.radius, name_ + ": point " + std::to_string(row.index));
  }
  frame.counts.in_file = file.all_points;
  frame.counts.deselected = file.all_points - file.points.size();
  warnings_ = std::move(file.warnings);
}

}  // namespace rbpa::app
