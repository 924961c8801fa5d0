#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/cloud/atoms.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/text/fields.h"
#include "io/text/line_selection.h"
#include "io/text/lines.h"
#include "io/text/typed_words.h"

namespace rbpa::app {
namespace {

/// Counts the atoms for which a file has several places.
class AlternateLocations {
 public:
  void take(const Atom& atom) {
    const std::string& altloc = atom.fields[AtomColumn::altloc];
    if (altloc.empty()) return;
    std::string key;
    for (const std::size_t k : {AtomColumn::chain, AtomColumn::resseq, AtomColumn::icode, AtomColumn::name})
      (key += atom.fields[k]) += '\t';
    if (++places_[key] == 2) ++count_;
    if (first_.empty()) first_ = altloc;
  }
  std::size_t count() const { return count_; }
  const std::string& first() const { return first_; }

 private:
  std::unordered_map<std::string, std::size_t> places_ = {};  // number for each atom with alternate locations
  std::size_t count_ = 0;
  std::string first_ = {};  // the first letter of an alternate location
};

class MoleculeCloud final : public Cloud {
 public:
  MoleculeCloud(Content content, const CloudRequest& request, OpenAtoms open)
      : content_(std::move(content)),
        name_(content_.name()),
        source_(open(content_.ahead(), name_, false)),
        waters_(request.waters) {
    source_->next_frame();
    if (request.keeps)
      for (const auto& [name, column] : source_->other_columns()) {
        if (!request.keeps->has(name)) continue;
        kept_.push_back(column);
        facts_.file.kept.push_back({.name = name, .type = Scalar::int64});
        if (is_text_of_atom(column)) facts_.file.kept.back() = {.name = name, .type = Scalar::int32, .is_text = true};
      }
    if (!request.where) return;
    selection_.emplace(*request.where, *source_);
    for (std::size_t k = 0; k < request.where->columns(); ++k) {
      facts_.file.texts.emplace_back();
      if (selection_->is_text(k)) facts_.file.texts.back().emplace();
      numbers_.emplace_back();
    }
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
    while (source_->next_frame()) continue;
    facts_.cell = std::move(source_->cell());
    facts_.file.all_points = atoms_;
    std::erase_if(facts_.file.kept, [](const PointColumn& column) {  // the file has no such column
      std::size_t i = 0;
      while (i < column.size() && column.is_missing(i)) ++i;
      return i > 0 && i == column.size();
    });
    for (std::size_t k = 0; k < numbers_.size(); ++k)
      if (facts_.file.texts[k]) facts_.file.texts[k] = numbers_[k].take_texts();
    if (source_->blocks() > 1)
      warnings.push_back("the atoms are those of the first of " + std::to_string(source_->blocks()) +
                         " blocks of data");
    if (source_->frames() > 1)
      warnings.push_back("the atoms are those of the first of " + std::to_string(source_->frames()) + " models");
    if (!source_->remark().empty()) warnings.emplace_back(source_->remark());
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
    const std::string& residue = atom_.fields[AtomColumn::resname];
    const bool is_of_water = is_water(residue) && !(selection_ && selection_->names_residue(residue));
    if (is_of_water && waters_ == Waters::left_out) {
      ++water_atoms_;
      return;
    }
    if (selection_ && !selection_->holds(atom_)) return;
    if (is_of_water) ++water_atoms_;
    alternates_.take(atom_);
    const Point3 center = source_->center(atom_);
    for (const auto& [k, value] :
         {std::pair(CloudBlock::x, center.x), {CloudBlock::y, center.y}, {CloudBlock::z, center.z}})
      block.column[k].push_back(value);
    for (std::size_t k = 0; k < numbers_.size(); ++k)
      block.fields[k].push_back(facts_.file.texts[k] ? numbers_[k].number_of(selection_->text(atom_, k))
                                                     : selection_->number(atom_, k));
    for (std::size_t k = 0; k < kept_.size(); ++k) append_word(facts_.file.kept[k], AtomSource::text(atom_, kept_[k]));
    block.index.push_back(index);
    ++block.count;
  }

  Content content_;
  const std::string& name_;
  std::unique_ptr<AtomSource> source_;
  Waters waters_;
  Atom atom_ = {};
  std::optional<AtomSelection> selection_ = std::nullopt;
  std::vector<TextNumbers> numbers_ = {};  // numbers of the texts in each column of the condition
  std::vector<std::size_t> kept_ = {};     // the column of the file for each of PointFile::kept
  AlternateLocations alternates_ = {};
  std::size_t atoms_ = 0, water_atoms_ = 0;
};

/// Returns the rule for names of fields: the first `columns` of atom_columns.
template <std::size_t columns>
FieldNames names_of_atoms() {
  std::string all;
  for (std::size_t k = 0; k < columns; ++k) (all += all.empty() ? "" : ", ") += atom_columns[k];
  return {[](std::string_view word) { return atom_column(word) < columns; }, "a column of atoms: " + all, true};
}

}  // namespace

template <OpenAtoms open, FieldNames (*fields)()>
constexpr CloudFormat molecule_format = {
    .open = open_as<MoleculeCloud, open>, .fields = fields, .is_molecule = true, .is_text = true};

/// Read the atoms of the first model, in the order of the file, alternate locations included: PDB's records ATOM and
/// HETATM, PDBx/mmCIF's _atom_site, PQR, GROMACS' .gro and LAMMPS' dump. Fields are atom_columns; of dumps, all
/// columns. Requires: content in memory.
const CloudFormat pdb_reader = molecule_format<pdb_atoms, names_of_atoms<columns_of_pdb>>;
const CloudFormat cif_reader = molecule_format<cif_atoms, names_of_atoms<columns_of_pdb>>;
const CloudFormat pqr_reader = molecule_format<pqr_atoms, names_of_atoms<no_atom_column>>;
const CloudFormat gro_reader = molecule_format<gro_atoms, names_of_atoms<columns_of_pdb>>;
const CloudFormat dump_reader = molecule_format<dump_atoms, names_of_columns>;

OpenAtoms atoms_of(Format format) {
  for (const auto& [known, open] : {std::pair<Format, OpenAtoms>(Format::pdb, pdb_atoms),
                                    {Format::pqr, pqr_atoms},
                                    {Format::cif, cif_atoms},
                                    {Format::gro, gro_atoms},
                                    {Format::dump, dump_atoms}})
    if (known == format) return open;
  return nullptr;
}

}  // namespace rbpa::app
