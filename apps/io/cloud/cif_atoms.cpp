// Source: https://www.iucr.org/resources/cif/spec/version1.1/cifsyntax and
//         https://mmcif.wwpdb.org/dictionaries/mmcif_pdbx_v50.dic/Categories/atom_site.html
#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <set>
#include <utility>
#include <vector>

#include "io/cloud/atoms.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/text/lines.h"

namespace rbpa::app {
namespace {

/// The tokens of a text in CIF. The case of names and keywords does not matter. A quoted value ends at its closing
/// quote.
class CifTokens {
 public:
  enum class Kind : std::uint8_t {
    end,
    name,  ///< _atom_site.id
    loop,
    block,    ///< data_NAME, save_NAME, or another keyword that ends the loop before
    value,    ///< without its quotes
    no_value  ///< ? or .
  };

  /// Goes to the first token. `name` stands for the text in messages; both must outlive this object. Throws as next().
  CifTokens(std::string_view text, const std::string& name);

  /// Goes to the next token. Throws BadInput for quotes and multi-line texts without an end; Cancelled.
  void next();

  Kind kind() const { return kind_; }
  bool is_value() const { return kind_ == Kind::value || kind_ == Kind::no_value; }
  std::string_view text() const { return text_; }   ///< empty for no_value
  std::size_t line() const { return token_line_; }  ///< line where the token begins, from 1

 private:
  void pass_blanks();
  void take_quoted();
  void take_lines();

  const char* begin_;
  const char* at_;
  const char* end_;
  const std::string& name_;
  Kind kind_ = Kind::end;
  std::string_view text_ = {};
  std::size_t line_ = 1, token_line_ = 1, tokens_ = 0;
};

using Kind = CifTokens::Kind;

bool ends_line(char c) { return c == '\n' || c == '\r'; }
bool is_white(char c) { return is_blank(c) || c == '\n'; }

Kind kind_of(std::string_view word) {
  const auto begins = [&](std::string_view keyword) { return same_letters(word.substr(0, keyword.size()), keyword); };
  if (word.front() == '_') return Kind::name;
  if (same_letters(word, "loop_")) return Kind::loop;
  if (begins("data_") || begins("save_") || same_letters(word, "global_") || same_letters(word, "stop_"))
    return Kind::block;
  return word == "?" || word == "." ? Kind::no_value : Kind::value;
}

CifTokens::CifTokens(std::string_view text, const std::string& name)
    : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), name_(name) {
  next();
}

void CifTokens::next() {
  if (++tokens_ % 65536 == 0) stop_if_interrupted();
  pass_blanks();
  token_line_ = line_;
  text_ = {};
  kind_ = Kind::end;
  if (at_ == end_) return;
  if (*at_ == ';' && (at_ == begin_ || ends_line(at_[-1]))) return take_lines();
  if (*at_ == '\'' || *at_ == '"') return take_quoted();
  const char* const first = at_;
  at_ = std::find_if(at_, end_, is_white);
  text_ = {first, static_cast<std::size_t>(at_ - first)};
  kind_ = kind_of(text_);
  if (kind_ == Kind::no_value) text_ = {};
}

/// Skips blanks, and comments, which may begin only where a token may.
void CifTokens::pass_blanks() {
  for (; at_ != end_; ++at_) {
    if (*at_ == '#') at_ = std::find_if(at_, end_, ends_line);
    if (at_ == end_ || !is_white(*at_)) return;
    const bool is_half = *at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n';
    if (ends_line(*at_) && !is_half && ++line_ % 65536 == 0) stop_if_interrupted();
  }
}

/// Takes a quoted value. A quote ends the value only if a blank follows: 'O5'' is O5'.
void CifTokens::take_quoted() {
  const char quote = *at_;
  const char* const first = ++at_;
  for (; at_ != end_ && !ends_line(*at_); ++at_) {
    if (*at_ != quote || (at_ + 1 != end_ && !is_white(at_[1]))) continue;
    text_ = {first, static_cast<std::size_t>(at_++ - first)};
    kind_ = Kind::value;
    return;
  }
  bad_input(at_line(name_, line_), in_quotes({first - 1, static_cast<std::size_t>(at_ - first + 1)}),
            "a value whose quotes end in its line");
}

/// Takes a multi-line value, up to a line that begins with a semicolon.
void CifTokens::take_lines() {
  const char* const first = ++at_;
  for (; at_ != end_; ++at_) {
    if (!ends_line(*at_)) continue;
    const bool is_half = *at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n';
    if (!is_half && ++line_ % 65536 == 0) stop_if_interrupted();
    if (is_half || at_ + 1 == end_ || at_[1] != ';') continue;
    text_ = trimmed({first, static_cast<std::size_t>(at_ - first)});
    kind_ = Kind::value;
    at_ += 2;
    return;
  }
  bad_input(at_line(name_, token_line_), "a multi-line text without an end", "a later line that begins with ';'");
}

constexpr std::string_view missing_columns = "the Cartesian coordinates Cartn_x, Cartn_y and Cartn_z";

/// The items of CIF for each of atom_columns; the second counts if the first has no value. Names of the author (auth_)
/// are those of the PDB file of the same structure.
constexpr std::array<std::array<std::string_view, 2>, atom_columns.size()> names_in_cif = {
    {{"id"},
     {"auth_asym_id", "label_asym_id"},
     {"auth_seq_id", "label_seq_id"},
     {"pdbx_PDB_ins_code"},
     {"auth_comp_id", "label_comp_id"},
     {"auth_atom_id", "label_atom_id"},
     {"type_symbol"},
     {"Cartn_x"},
     {"Cartn_y"},
     {"Cartn_z"},
     {"label_alt_id"},
     {"occupancy"},
     {"B_iso_or_equiv"},
     {"pdbx_formal_charge"},
     {"group_PDB"}}};

/// Returns the name of an item of the category without the category; empty for an item of another category. Early
/// dictionaries have an underscore in place of the dot.
std::string_view item_of(std::string_view name, std::string_view category) {
  if (name.size() <= category.size() + 1 || !same_letters(name.substr(0, category.size()), category)) return {};
  const char dot = name[category.size()];
  name.remove_prefix(category.size() + 1);
  const bool is_other =
      dot == '_' && (name.find('.') != std::string_view::npos || same_letters(name.substr(0, 5), "aniso"));
  return (dot == '.' || dot == '_') && !is_other ? name : std::string_view();
}

class CifAtoms final : public AtomSource {
 public:
  CifAtoms(std::string_view text, const std::string& name, bool all_frames)
      : AtomSource(name), text_(text), tokens_(text, name), all_frames_(all_frames) {}

  bool next_frame() override {
    while (!waits_ || !is_new_frame_) {
      waits_ = find_row();
      if (waits_) continue;
      if (frames_ == 0) bad_input(name_, "no atom in a category _atom_site", "the atoms of a file in PDBx/mmCIF");
      cell_ = cell_of_values();
      return false;
    }
    is_new_frame_ = false;
    if (std::exchange(finds_cell_, false)) find_cell();
    return true;
  }

  bool next(Atom& atom) override {
    if (!waits_) waits_ = find_row();
    if (!waits_ || is_new_frame_) return false;
    waits_ = false;
    fill(atom);
    if (odd_line_ > 0) require_columns(atom);
    return true;
  }

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  /// Goes to the next atom of the first block; returns false at the end of the file.
  bool find_row() {
    while (in_rows_ || find_rows()) {
      in_rows_ = take_row();
      if (in_rows_ && is_wanted()) return true;
    }
    return false;
  }

  /// Finds the cell of all frames, also if the text has the cell after the atoms.
  void find_cell() {
    const bool is_found =
        std::any_of(cell_values_.begin(), cell_values_.begin() + symmetry, [](auto value) { return !value.empty(); });
    if (!is_found && text_.find("_cell") != std::string_view::npos) {
      CifAtoms all(text_, name_, false);
      all.finds_cell_ = false;
      while (all.next_frame()) continue;
      cell_values_ = all.cell_values_;
    }
    cell_ = cell_of_values();
  }

  UnitCell cell_of_values() const {
    std::array<std::string_view, symmetry> numbers{};
    std::copy_n(cell_values_.begin(), symmetry, numbers.begin());
    UnitCell cell = unit_cell("_cell", numbers);
    cell.symmetry = cell_values_[symmetry];
    return cell;
  }

  /// Goes to the first value of the next loop of atoms; returns false at the end of the file.
  bool find_rows() {
    for (;;) {
      const std::string_view item = tokens_.kind() == Kind::name ? item_of(tokens_.text(), "_atom_site") : "";
      if (item.empty() && !columns_.empty()) return begin_rows();  // one atom, as pairs of name and value
      if (tokens_.kind() == Kind::end) return false;
      if (tokens_.kind() == Kind::block) {
        ++block_;
        if (first_block_ == 0) cell_values_ = {};
      }
      if (tokens_.kind() == Kind::loop) {
        if (read_names()) return begin_rows();
      } else if (tokens_.kind() == Kind::name) {
        read_pair(item);
      } else {
        tokens_.next();
      }
    }
  }

  /// Reads the names of a loop; returns whether it has items of atoms. Of other loops also reads the first row, for the
  /// cell.
  bool read_names() {
    bool is_of_atoms = false;
    std::vector<std::size_t> of_cell;
    for (tokens_.next(); tokens_.kind() == Kind::name; tokens_.next()) {
      columns_.push_back(item_of(tokens_.text(), "_atom_site"));
      of_cell.push_back(place_in_cell(tokens_.text()));
      is_of_atoms = is_of_atoms || !columns_.back().empty();
    }
    if (is_of_atoms) return true;
    columns_.clear();
    for (std::size_t i = 0; i < of_cell.size() && tokens_.is_value(); ++i, tokens_.next()) take_of_cell(of_cell[i]);
    return false;
  }

  /// Reads a name and its value.
  void read_pair(std::string_view item) {
    const std::size_t of_cell = place_in_cell(tokens_.text());
    tokens_.next();
    if (!tokens_.is_value()) return;
    if (!item.empty()) {
      columns_.push_back(item);
      values_.push_back(tokens_.text());
      row_line_ = tokens_.line();
    }
    take_of_cell(of_cell);
    tokens_.next();
  }

  /// Returns the index in cell_values_ of an item with this name; another index if it is not of the cell.
  static std::size_t place_in_cell(std::string_view name) {
    constexpr std::string_view items[][2] = {{"_cell", "length_a"},
                                             {"_cell", "length_b"},
                                             {"_cell", "length_c"},
                                             {"_cell", "angle_alpha"},
                                             {"_cell", "angle_beta"},
                                             {"_cell", "angle_gamma"},
                                             {"_symmetry", "space_group_name_H-M"},
                                             {"_space_group", "name_H-M_alt"}};
    std::size_t k = 0;
    while (k < std::size(items) && !same_letters(item_of(name, items[k][0]), items[k][1])) ++k;
    return k == symmetry + 1 ? symmetry : k;
  }
  /// Takes the current value, if it has a place in cell_values_.
  void take_of_cell(std::size_t place) {
    if (place <= symmetry && (first_block_ == 0 || block_ == first_block_))
      cell_values_[place] = place == symmetry ? tokens_.text() : without_uncertainty(tokens_.text());
  }

  bool begin_rows() {
    const std::size_t line = tokens_.line();
    const auto place_of = [&](std::string_view name) {
      const auto found = std::find_if(columns_.begin(), columns_.end(),
                                      [&](std::string_view column) { return same_letters(column, name); });
      return name.empty() || found == columns_.end() ? none : static_cast<std::size_t>(found - columns_.begin());
    };
    for (std::size_t k = 0; k < places_.size(); ++k)
      places_[k] = {place_of(names_in_cif[k][0]), place_of(names_in_cif[k][1])};
    model_ = place_of("pdbx_PDB_model_num");
    const bool has_fractions = place_of("fract_x") != none;
    for (std::size_t k = x_of_atom; k < x_of_atom + 3; ++k)
      if (places_[k][0] == none)
        bad_input(
            at_line(name_, line),
            has_fractions ? "atoms in fractions of the cell (_atom_site.fract_x)"
                          : "atoms without _atom_site." + std::string(names_in_cif[k][0]),
            std::string(missing_columns) +
                (has_fractions ? " (Python: atoms = ase.io.read(FILE); rbpa.balls(atoms, box=atoms.cell[:]))" : ""));
    if (first_block_ == 0) {
      first_block_ = block_;
    } else if (block_ == first_block_) {
      bad_input(at_line(name_, line), "a second loop of _atom_site in a block of data", "one loop in each block");
    } else {
      blocks_ += block_ == last_block_ ? 0 : 1;
    }
    last_block_ = block_;
    is_by_lines_ = is_first_row_ = true;
    width_ = std::exchange(columns_, {}).size();
    has_pairs_ = !values_.empty();
    return true;
  }

  /// Reads the values of the next atom; returns false if there are no more.
  bool take_row() {
    if (std::exchange(has_pairs_, false)) {
      is_by_lines_ = false;
      row_ = std::exchange(values_, {});
      return true;
    }
    if (!tokens_.is_value()) return false;
    row_.clear();
    row_line_ = tokens_.line();
    std::size_t last = row_line_;
    for (; row_.size() < width_ && tokens_.is_value(); tokens_.next()) {
      row_.push_back(tokens_.text());
      last = tokens_.line();
    }
    const bool is_a_line = last == row_line_ && !(tokens_.is_value() && tokens_.line() == last);
    if (odd_line_ == 0 && is_by_lines_ && !is_a_line) {
      if (is_first_row_)
        is_by_lines_ = false;
      else
        odd_line_ = row_line_;
    }
    is_first_row_ = false;
    if (row_.size() < width_) refuse_row(odd_line_ > 0 ? odd_line_ : row_line_);
    return true;
  }

  /// Throws BadInput for a line with missing or surplus values.
  [[noreturn]] void refuse_row(std::size_t line) const {
    Lines lines(text_);
    while (lines.number() < line && lines.next()) continue;
    std::size_t count = is_by_lines_ ? 0 : row_.size();
    if (is_by_lines_)
      for (CifTokens words(lines.line(), name_); words.is_value(); words.next()) ++count;
    bad_input(at_line(name_, line), counted(count, "value") + " (" + in_quotes(lines.line()) + ")",
              std::to_string(width_) + ", one for each name of _atom_site");
  }

  /// Throws BadInput if texts of the atom are no numbers: then a value of an earlier atom is missing.
  void require_columns(const Atom& atom) const {
    for (const std::size_t k :
         {x_of_atom, x_of_atom + 1, x_of_atom + 2, AtomColumn::occupancy, AtomColumn::bfactor, AtomColumn::charge})
      if (!atom.fields[k].empty() && parse_whole_number(atom.fields[k]).fault != NumberFault::none)
        refuse_row(odd_line_);
  }

  /// Returns whether the atom is of the first block, and of the first model unless all frames are read.
  bool is_wanted() {
    if (block_ != first_block_) return false;
    const std::string_view model = model_ == none ? std::string_view() : row_[model_];
    const bool is_first = model_names_.empty();
    if (is_first) first_model_ = model;
    if (is_first || model != last_model_) {
      const bool is_new = model_names_.insert(model).second;
      if (all_frames_ && !is_new)
        bad_input(at_line(name_, row_line_), "an atom of model " + in_quotes(model) + " behind another model",
                  "all atoms of a model together");
      is_new_frame_ = all_frames_ || is_first;
    }
    frames_ = model_names_.size();
    last_model_ = model;
    return all_frames_ || model == first_model_;
  }

  void fill(Atom& atom) const {
    atom.line = row_line_;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      std::string_view value;
      for (const std::size_t place : places_[k])
        if (value.empty() && place != none) value = row_[place];
      atom.fields[k] = is_text_of_atom(k) ? value : without_uncertainty(value);
    }
  }

  std::string_view text_;
  CifTokens tokens_;
  bool all_frames_, finds_cell_ = true;  // find_cell() is to be called at the first frame
  static constexpr std::size_t symmetry = 6;
  std::array<std::string_view, 7> cell_values_ = {};          // lengths, angles, the space group
  std::size_t block_ = 1, first_block_ = 0, last_block_ = 0;  // data block; the first and the last one with atoms
  std::vector<std::string_view> columns_ = {}, values_ = {};  // items of a loop; or items of pairs and their values
  std::vector<std::string_view> row_ = {};                    // values of the current atom
  std::array<std::array<std::size_t, 2>, atom_columns.size()> places_ = {};
  std::size_t width_ = 0, model_ = none, row_line_ = 0, odd_line_ = 0;
  bool waits_ = false, is_new_frame_ = true;  // row_ is the next atom; the next atom is the first of a frame
  bool in_rows_ = false, has_pairs_ = false, is_by_lines_ = true, is_first_row_ = true;
  std::string_view first_model_ = {}, last_model_ = {};
  std::set<std::string_view> model_names_ = {};
};

}  // namespace

std::unique_ptr<AtomSource> cif_atoms(std::string_view text, const std::string& name, bool all_frames) {
  return std::make_unique<CifAtoms>(text, name, all_frames);
}

}  // namespace rbpa::app
