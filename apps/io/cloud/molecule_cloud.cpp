#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/bytes/number.h"
#include "io/cloud/atoms.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/text/fields.h"
#include "io/text/line_selection.h"
#include "io/text/lines.h"

namespace rbpa::app {
namespace {

constexpr std::size_t chain = 1, resseq = 2, icode = 3, resname = 4, name_of_atom = 5, altloc = 10;

bool is_water(std::string_view residue) {
  constexpr std::string_view waters[] = {"HOH", "DOD",  "WAT",  "H2O", "OH2", "TIP", "TIP3",
                                         "TP3", "TIP4", "TIP5", "TP4", "TP5", "SOL", "SPC"};
  return std::find(std::begin(waters), std::end(waters), residue) != std::end(waters);
}

/// Counts the atoms for which a file has several places.
class AlternateLocations {
 public:
  void take(const Atom& atom) {
    if (atom.fields[altloc].empty()) return;
    std::string key;
    for (const std::size_t k : {chain, resseq, icode, name_of_atom}) (key += atom.fields[k]) += '\t';
    if (++places_[key] == 2) ++count_;
    if (first_.empty()) first_ = atom.fields[altloc];
  }
  std::size_t count() const { return count_; }
  const std::string& first() const { return first_; }

 private:
  std::unordered_map<std::string, std::size_t> places_ = {};  // of each atom with a letter of an alternate location
  std::size_t count_ = 0;
  std::string first_ = {};  // the first letter of an alternate location
};

class MoleculeCloud final : public Cloud {
 public:
  MoleculeCloud(Content content, const CloudRequest& request, decltype(&pdb_atoms) open)
      : content_(std::move(content)),
        name_(content_.name()),
        source_(open(content_.ahead(), name_)),
        waters_(request.waters) {
    if (!request.where) return;
    const Condition& where = *request.where;
    for (const std::string& field : where.fields()) places_.push_back(atom_column(field));
    for (const Condition::Text& text : where.texts()) {
      texts_.push_back({atom_column(text.field), text.text});
      if (texts_.back().first == resname) waters_ = Waters::counted;
    }
    for (std::size_t k = 0; k < where.columns(); ++k) {
      const WantedColumn::Kind kind = where.column(k).kind;
      const bool is_text =
          kind == WantedColumn::Kind::by_value ? is_text_of_atom(places_[k]) : kind == WantedColumn::Kind::text;
      facts_.file.texts.emplace_back();
      if (is_text) facts_.file.texts.back().emplace();
      numbers_.emplace_back();
    }
    selection_.emplace(where);
  }

  bool next(CloudBlock& block) override {
    stop_if_interrupted();
    block.count = 0;
    for (std::vector<double>& column : block.column) column.clear();
    block.index.clear();
    clear_fields(block, numbers_.size());
    while (block.count < points_at_once && source_->next(atom_)) take(block);
    return block.count > 0;
  }

  void finish() override {
    std::vector<std::string>& warnings = facts_.file.warnings;
    facts_.cell = std::move(source_->cell());
    facts_.file.all_points = atoms_;
    for (std::size_t k = 0; k < numbers_.size(); ++k)
      if (facts_.file.texts[k]) facts_.file.texts[k] = numbers_[k].take_texts();
    if (source_->blocks() > 1)
      warnings.push_back("the atoms are those of the first of " + std::to_string(source_->blocks()) +
                         " blocks of data");
    if (source_->models() > 1)
      warnings.push_back("the atoms are those of the first of " + std::to_string(source_->models()) + " models");
    if (water_atoms_ > 0 && waters_ == Waters::left_out) {
      if (water_atoms_ == atoms_) bad_input(name_, "no atoms but those of water", "others (--waters reads water too)");
      warnings.push_back(counted(water_atoms_, "atom") + " of water " + (water_atoms_ == 1 ? "is" : "are") +
                         " left out (--waters keeps them)");
    }
    if (water_atoms_ > 0 && waters_ == Waters::noted)
      warnings.push_back(counted(water_atoms_, "atom") + (water_atoms_ == 1 ? " is" : " are") +
                         " of water (where \"resname != 'HOH'\" leaves them out)");
    if (selection_) selection_->warning("atom", warnings);
    if (const std::size_t places = alternates_.count(); places > 0)
      warnings.push_back(counted(places, "atom") + (places == 1 ? " has" : " have") +
                         " alternate locations, each a point of its own (where \"altloc in ('', '" +
                         alternates_.first() + "')\" takes one of each)");
  }

 private:
  void take(CloudBlock& block) {
    const std::size_t index = atoms_++;
    const bool is_of_water = is_water(atom_.fields[resname]);
    if (is_of_water && waters_ == Waters::left_out) {
      ++water_atoms_;
      return;
    }
    const auto number = [&](std::size_t field) { return number_at(places_[field], of_where); };
    const auto is_text = [&](std::size_t text) { return has_text(texts_[text]); };
    if (selection_ && !selection_->holds(number, is_text)) return;
    if (is_of_water) ++water_atoms_;
    alternates_.take(atom_);
    for (std::size_t k = 0; k < 3; ++k) block.column[k].push_back(coordinate(x_of_atom + k));
    for (std::size_t k = 0; k < numbers_.size(); ++k)
      block.fields[k].push_back(facts_.file.texts[k] ? numbers_[k].number_of(atom_.fields[places_[k]])
                                                     : number_at(places_[k], of_where));
    block.index.push_back(index);
    ++block.count;
  }

  /// Returns whether the atom has the text that the condition asks for; '?' matches an empty value, as in PDBx/mmCIF.
  bool has_text(const std::pair<std::size_t, std::string>& asked) const {
    const std::string& field = atom_.fields[asked.first];
    return field == asked.second || (field.empty() && asked.second == "?");
  }

  double coordinate(std::size_t column) const { return parsed(column, ""); }

  /// Returns the number in a column of the atom; NaN if the column is empty.
  double number_at(std::size_t column, std::string_view where) const {
    if (atom_.fields[column].empty()) return std::numeric_limits<double>::quiet_NaN();
    return parsed(column, where);
  }

  double parsed(std::size_t column, std::string_view where) const {
    const ParsedNumber number = parse_whole_number(atom_.fields[column]);
    if (number.fault == NumberFault::none) return number.value;
    source_->require_columns();
    bad_input(at_line(name_, atom_.line), in_quotes(atom_.fields[column]) + " as " + std::string(atom_columns[column]),
              expected_instead(number.fault) + std::string(where));
  }

  Content content_;
  const std::string& name_;
  std::unique_ptr<AtomSource> source_;
  Waters waters_;
  Atom atom_ = {};
  std::vector<std::size_t> places_ = {};                         // columns of the condition's fields
  std::vector<std::pair<std::size_t, std::string>> texts_ = {};  // columns of its texts, and the texts
  std::optional<Selection> selection_ = std::nullopt;
  std::vector<TextNumbers> numbers_ = {};  // numbers of the texts in each of its columns
  AlternateLocations alternates_ = {};
  std::size_t atoms_ = 0, water_atoms_ = 0;
};

FieldNames names_of_atoms() {
  std::string all;
  for (const std::string_view column : atom_columns) (all += all.empty() ? "" : ", ") += column;
  return {[](std::string_view word) { return atom_column(word) != no_atom_column; }, "a column of atoms: " + all, true};
}

}  // namespace

std::size_t atom_column(std::string_view name) {
  const auto found = std::find_if(atom_columns.begin(), atom_columns.end(),
                                  [&](std::string_view known) { return same_letters(known, name); });
  return static_cast<std::size_t>(found - atom_columns.begin());
}

bool is_text_of_atom(std::size_t column) {
  constexpr std::string_view texts[] = {"chain", "icode", "resname", "name", "element", "altloc"};
  return std::find(std::begin(texts), std::end(texts), atom_columns[column]) != std::end(texts);
}

UnitCell unit_cell(const std::string& record, const std::array<std::string_view, 6>& values) {
  if (std::all_of(values.begin(), values.end(), [](std::string_view value) { return value.empty(); })) return {};
  std::array<double, 6> numbers{};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const ParsedNumber number = parse_whole_number(values[k]);
    if (number.fault != NumberFault::none || (k < 3 && !(number.value > 0)))
      return {.fault = record + " with " + in_quotes(values[k]) + (k < 3 ? " as a length" : " as an angle")};
    numbers[k] = number.value;
  }
  const auto text = [&](std::size_t k) { return text_of(numbers[k]); };
  if (numbers[0] == 1 && numbers[1] == 1 && numbers[2] == 1)
    return {.fault = record + " of 1 x 1 x 1, which stands for none"};
  if (numbers[3] != 90 || numbers[4] != 90 || numbers[5] != 90)
    return {.fault = record + " with angles of " + text(3) + ", " + text(4) + " and " + text(5) + " degrees"};
  return {.sides = {{numbers[0], numbers[1], numbers[2]}}};
}

std::string_view without_uncertainty(std::string_view number) {
  const std::size_t bracket = number.find('(');
  const std::string_view digits = number.substr(std::min(bracket, number.size()));
  const bool is_one =
      digits.size() > 2 && digits.back() == ')' && digits.find_first_not_of("0123456789", 1) == digits.size() - 1;
  return is_one ? number.substr(0, bracket) : number;
}

/// Read the atoms of the first model, in the order of the file, alternate locations included: PDB's records ATOM and
/// HETATM, and PDBx/mmCIF's _atom_site, with atom_columns as their fields. Requires: content in memory.
const CloudFormat pdb_reader = {
    .open = open_as<MoleculeCloud, pdb_atoms>, .fields = names_of_atoms, .is_molecule = true, .is_text = true};
const CloudFormat cif_reader = {
    .open = open_as<MoleculeCloud, cif_atoms>, .fields = names_of_atoms, .is_molecule = true, .is_text = true};

}  // namespace rbpa::app
