// What: frames of simulations: GROMACS' .gro, LAMMPS' dump, and the .xyz of chemistry.
// Source: https://manual.gromacs.org/current/reference-manual/file-formats.html#gro, https://docs.lammps.org/dump.html,
//         https://docs.lammps.org/Howto_triclinic.html, https://github.com/libAtoms/extxyz
#include <cmath>
#include <initializer_list>
#include <utility>

#include "io/cloud/atoms.h"
#include "io/cloud/table_beginning.h"
#include "io/failure.h"
#include "io/number.h"
#include "io/text/fields.h"
#include "io/text/lines.h"

namespace rbpa::app {
namespace {

/// The source of atoms that are one to a line: the base class of all formats of simulations.
class LineAtoms : public AtomSource {
 protected:
  LineAtoms(std::string_view text, const std::string& name) : AtomSource(name), lines_(text) {}

  std::string here() const { return at_line(name_, lines_.number()); }
  void take_line(const std::string& expected) {
    if (lines_.next()) return;
    bad_input(name_, "the end of the file behind line " + std::to_string(lines_.number()), expected);
  }
  /// Goes to the line of the next atom, and returns it with the blanks at its beginning.
  std::string_view take_atom() {
    const char* const begin = lines_.rest().data();
    take_line(counted(left_, "further atom"));
    --left_;
    return {begin, static_cast<std::size_t>(lines_.line().data() + lines_.line().size() - begin)};
  }
  void take_count() {
    const std::optional<std::size_t> count = parse_count(lines_.line());
    if (!count || *count == 0) bad_input(here(), in_quotes(lines_.line()), "the number of atoms, at least 1");
    left_ = *count;
  }

  Lines lines_;
  std::size_t left_ = 0;  // atoms of the frame that are not read yet
};

/// Returns ten times the number in `text`, whose nearest double is `number`. The result is rounded once, as the digits
/// are read with another exponent, unless `text` has an exponent.
double ten_times(double number, std::string_view text) {
  if (text.find_first_of("eE") != std::string_view::npos) return 10 * number;
  return parse_whole_number(std::string(text) + "e1").value;
}

/// Frames of a title, the number of atoms, atoms in columns, and the box; all lengths in nanometers.
class GroAtoms final : public LineAtoms {
 public:
  GroAtoms(std::string_view text, const std::string& name) : LineAtoms(text, name) {
    remark_ = "coordinates and the box are in angstroms, ten times the nanometers of the file";
  }

  bool next_frame() override {
    while (left_ > 0) take_atom();
    if (frames_ > 0 && !std::exchange(has_box_, true)) read_box();
    const std::string_view title = lines_.rest();
    if (title.find_first_not_of(" \t\r\n") == std::string_view::npos) {
      if (frames_ == 0) bad_input(name_, "no atom", "the atoms of a file in GROMACS' .gro format");
      return false;
    }
    for (std::size_t k = 0; k < 2; ++k) take_line("a title and the number of atoms");
    take_count();
    ++frames_;
    has_box_ = false;
    return true;
  }

  bool next(Atom& atom) override {
    if (left_ == 0) {
      if (!std::exchange(has_box_, true)) read_box();
      return false;
    }
    const std::string_view line = take_atom();
    // The distance of two decimal points is the width of a column.
    const std::size_t first = line.find('.', 20), second = line.find('.', first + 1);
    if (second == std::string_view::npos || second - first > 32)
      bad_input(here(), in_quotes(trimmed(line)),
                "an atom of .gro in columns: residue number and name, atom name and number, x, y, z");
    atom.line = lines_.number();
    atom.fields = {};
    const auto take = [&](std::size_t k, std::size_t from, std::size_t size) {
      atom.fields[k] = trimmed(line.substr(std::min(from, line.size()), size));
    };
    take(AtomColumn::resseq, 0, 5);
    take(AtomColumn::resname, 5, 5);
    take(AtomColumn::name, 10, 5);
    take(AtomColumn::serial, 15, 5);
    for (std::size_t k = 0; k < 3; ++k) take(x_of_atom + k, 20 + k * (second - first), second - first);
    return true;
  }

 private:
  double parsed(const Atom& atom, std::size_t column, std::string_view where) const override {
    const double number = AtomSource::parsed(atom, column, where);
    return column >= x_of_atom && column < x_of_atom + 3 ? ten_times(number, atom.fields[column]) : number;
  }

  /// Reads v1(x) v2(y) v3(z), and, for a box with other than right angles, v1(y) v1(z) v2(x) v2(z) v3(x) v3(y).
  void read_box() {
    take_line("the box, three or nine numbers");
    constexpr std::size_t places[] = {0, 4, 8, 1, 2, 3, 5, 6, 7};
    std::array<double, 9> edges{};
    const std::vector<std::string_view> words = split_words(lines_.line());
    bool is_box = words.size() == 3 || words.size() == 9;
    for (std::size_t k = 0; is_box && k < words.size(); ++k) {
      const ParsedNumber number = parse_whole_number(words[k]);
      is_box = number.fault == NumberFault::none;
      edges[places[k]] = ten_times(number.value, words[k]);
    }
    if (!is_box) bad_input(here(), in_quotes(lines_.line()), "the box, three or nine numbers");
    cell_ = unit_cell("the box", edges);
  }

  bool has_box_ = true;  // the box of the frame is read
};

class NamedAtoms : public LineAtoms {
 public:
  bool next_frame() override {
    while (left_ > 0) take_atom();
    bool any = lines_.next();
    while (any && lines_.line().empty()) any = lines_.next();
    if (!any && frames_ == 0) bad_input(name_, "no atom", "frames of atoms");
    if (!any) return false;
    read_header();
    ++frames_;
    return true;
  }

  bool next(Atom& atom) override {
    if (left_ == 0) return false;
    take_atom();
    atom.line = lines_.number();
    atom.others.resize(names_.size());
    std::size_t count = 0;
    for (Fields fields(lines_.line(), blanks); !fields.at_end(); ++count) {
      const std::string_view word = without_quotes(fields.take());
      if (count < names_.size()) atom.others[count] = word;
    }
    if (count != names_.size())
      bad_input(here(), counted(count, "value") + " (" + in_quotes(lines_.line()) + ")",
                std::to_string(names_.size()) + ", one for each column");
    for (std::size_t k = 0; k < places_.size(); ++k)
      if (has(k)) atom.fields[k] = atom.others[places_[k]];
    return true;
  }

  std::size_t column(std::string_view name) const override {
    if (const std::size_t known = atom_column(name); known < no_atom_column && has(known)) return known;
    const std::size_t place = place_of(without_quotes(name));
    if (place == names_.size())
      bad_input(at_line(name_, line_of_names_), "no column " + in_quotes(name), "one of " + list_of_names());
    return no_atom_column + place;
  }

  std::vector<std::pair<std::string, std::size_t>> other_columns() const override {
    std::vector<std::pair<std::string, std::size_t>> all;
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (std::find(&places_[x_of_atom], &places_[x_of_atom + 3], k) == &places_[x_of_atom + 3])
        all.emplace_back(names_[k], no_atom_column + k);
    return all;
  }

  bool has_radii() const override { return has(AtomColumn::radius); }

 protected:
  using LineAtoms::LineAtoms;

  /// Reads the lines before the atoms of a frame; the first is the current line.
  virtual void read_header() = 0;

  /// Returns the first `size` numbers of a text.
  std::vector<double> take_numbers(std::string_view text, std::size_t size, const std::string& expected) const {
    std::vector<double> numbers;
    for (std::string_view rest = text; numbers.size() < size;) {
      const ParsedNumber number = parse_whole_number(take_word(rest));
      if (number.fault != NumberFault::none) bad_input(here(), in_quotes(text), expected);
      numbers.push_back(number.value);
    }
    return numbers;
  }

  /// Sets the names of the columns in the first frame, and finds the column of each of `of_atoms`: the first of its
  /// names, which blanks separate, that is there. Throws BadInput if a later frame has other columns.
  void set_names(std::vector<std::string> names,
                 std::initializer_list<std::pair<std::size_t, std::string_view>> of_atoms) {
    if (frames_ > 0 && names != names_) bad_input(here(), "other columns than in the first frame", list_of_names());
    if (frames_ > 0) return;
    names_ = std::move(names);
    line_of_names_ = lines_.number();
    places_.fill(names_.size());
    for (const auto& [k, words] : of_atoms)
      for (const std::string_view word : split_words(words))
        if (!has(k)) places_[k] = place_of(word);
  }
  bool has(std::size_t k) const { return places_[k] < names_.size(); }

  std::vector<std::string> names_ = {};  // names of the columns in the file
  std::array<std::size_t, atom_columns.size()> places_ =
      {};  // index in names_ of each of atom_columns; names_.size() if there is none

 private:
  std::size_t place_of(std::string_view name) const {
    return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
  }
  std::string list_of_names() const { return shown(listed(names_, ", ")); }

  std::size_t line_of_names_ = 0;
};

class DumpAtoms final : public NamedAtoms {
 public:
  DumpAtoms(std::string_view text, const std::string& name) : NamedAtoms(text, name) {}

 private:
  double parsed(const Atom& atom, std::size_t column, std::string_view where) const override {
    const double number = AtomSource::parsed(atom, column, where);
    if (column == AtomColumn::radius && is_diameter_) return number / 2;
    if (!is_scaled_ || column < x_of_atom || column >= x_of_atom + 3) return number;
    const std::size_t k = column - x_of_atom;
    double sum = origin_[k];
    for (std::size_t i = 0; i < 3; ++i) sum += AtomSource::parsed(atom, x_of_atom + i, where) * edges_[3 * i + k];
    if (!std::isfinite(sum)) bad_input(at_line(name_, atom.line), "a place that is not finite", "finite coordinates");
    return sum;
  }

  void read_header() override {
    bool has_count = false, has_box = false;
    for (;; take_line("an item of a dump")) {
      std::string_view item = lines_.line();
      if (!item.starts_with("ITEM: ")) bad_input(here(), in_quotes(item), "a line that begins with ITEM:");
      item.remove_prefix(6);
      if (item.starts_with("ATOMS")) {
        if (!has_count) bad_input(here(), "atoms without their number", "'ITEM: NUMBER OF ATOMS' before them");
        return read_names(item.substr(5), has_box);
      }
      if (item.starts_with("BOX BOUNDS")) {
        read_box(item.substr(10));
        has_box = true;
        continue;
      }
      take_line("the value of " + in_quotes(item));
      if (!item.starts_with("NUMBER OF ATOMS")) continue;
      take_count();
      has_count = true;
    }
  }

  void read_names(std::string_view words, bool has_box) {
    const std::vector<std::string_view> names = split_words(words);
    set_names({names.begin(), names.end()}, {{AtomColumn::serial, "id"},
                                             {AtomColumn::resseq, "mol"},
                                             {AtomColumn::name, "name type"},
                                             {AtomColumn::element, "element"},
                                             {x_of_atom, "x xu xs xsu"},
                                             {x_of_atom + 1, "y yu ys ysu"},
                                             {x_of_atom + 2, "z zu zs zsu"},
                                             {AtomColumn::charge, "q"},
                                             {AtomColumn::radius, "radius diameter"}});
    const auto kind = [&](std::size_t k) { return has(k) ? names_[places_[k]].substr(1) : "none"; };
    if (!has(x_of_atom) || kind(x_of_atom + 1) != kind(x_of_atom) || kind(x_of_atom + 2) != kind(x_of_atom))
      bad_input(here(), in_quotes(lines_.line()), "columns x y z, xu yu zu, xs ys zs or xsu ysu zsu");
    is_scaled_ = kind(x_of_atom).starts_with('s');
    is_diameter_ = has_radii() && names_[places_[AtomColumn::radius]] == "diameter";
    if (is_scaled_ && !has_box) bad_input(here(), "scaled coordinates without ITEM: BOX BOUNDS", "a box before them");
  }

  /// Reads the bounds along x, y and z, with a tilt each or without. The bounds enclose the tilted box.
  void read_box(std::string_view words) {
    if (words.find("abc origin") != std::string_view::npos)
      bad_input(here(), "a general box", "bounds, of LAMMPS without triclinic/general");
    const bool is_tilted = words.find("xy xz yz") != std::string_view::npos;
    std::array<bool, 3> repeats = {true, true, true};
    std::size_t k = 0;
    for (const std::string_view word : split_words(words))
      if (word.size() == 2 && word[0] != 'x' && word[0] != 'y' && k < 3) repeats[k++] = word == "pp";
    std::array<std::vector<double>, 3> rows;
    for (std::vector<double>& row : rows) {
      take_line("three lines of the box");
      row = is_tilted ? take_numbers(lines_.line(), 3, "two bounds of the box and a tilt")
                      : take_numbers(lines_.line(), 2, "two bounds of the box");
      row.resize(3);
    }
    const double xy = rows[0][2], xz = rows[1][2], yz = rows[2][2];
    origin_ = {rows[0][0] - std::min({0.0, xy, xz, xy + xz}), rows[1][0] - std::min(0.0, yz), rows[2][0]};
    const double end_x = rows[0][1] - std::max({0.0, xy, xz, xy + xz}), end_y = rows[1][1] - std::max(0.0, yz);
    edges_ = {end_x - origin_[0], 0, 0, xy, end_y - origin_[1], 0, xz, yz, rows[2][1] - rows[2][0]};
    cell_ = unit_cell("BOX BOUNDS", edges_, repeats);
  }

  std::array<double, 9> edges_ = {};  // of the box, one after another
  std::array<double, 3> origin_ = {};
  bool is_scaled_ = false, is_diameter_ = false;
};

/// Returns the value of a key in the comment of an extended .xyz, without its quotes; empty if there is none.
std::string_view comment_value(std::string_view comment, std::string_view key) {
  const std::size_t at = comment.find(key);
  if (at == std::string_view::npos) return {};
  comment.remove_prefix(at + key.size());
  const char end = comment.starts_with('"') ? '"' : ' ';
  if (end == '"') comment.remove_prefix(1);
  return comment.substr(0, std::min(comment.find(end), comment.size()));
}

class XyzAtoms final : public NamedAtoms {
 public:
  XyzAtoms(std::string_view text, const std::string& name) : NamedAtoms(text, name) {}

 private:
  void read_header() override {
    take_count();
    take_line("a comment");
    const std::string_view comment = lines_.line();
    std::vector<std::string> names = xyz_columns(comment);
    if (names.empty()) {
      names = {"element", "x", "y", "z"};
      Lines behind(lines_.rest());
      const std::size_t all = behind.next() ? count_fields(behind.line(), blanks).all : 0;
      while (names.size() < all) names.push_back("column_" + std::to_string(names.size() + 1));
    }
    set_names(std::move(names), {{AtomColumn::serial, "id"},
                                 {AtomColumn::resseq, "resseq residuenumbers"},
                                 {AtomColumn::resname, "resname residuenames"},
                                 {AtomColumn::name, "name atomtypes"},
                                 {AtomColumn::element, "element"},
                                 {x_of_atom, "x"},
                                 {x_of_atom + 1, "y"},
                                 {x_of_atom + 2, "z"},
                                 {AtomColumn::occupancy, "occupancy"},
                                 {AtomColumn::charge, "charge charges initial_charges"},
                                 {AtomColumn::radius, "radius radii"}});
    cell_ = {};
    const std::string_view lattice = comment_value(comment, "Lattice=");
    if (lattice.empty()) return;
    const std::vector<double> n = take_numbers(lattice, 9, "nine numbers of Lattice");
    std::array<bool, 3> repeats = {true, true, true};
    std::string_view flags = comment_value(comment, "pbc=");
    for (bool& flag : repeats)
      if (const std::string_view word = take_word(flags); !word.empty()) flag = word.front() == 'T' || word == "1";
    cell_ = unit_cell("Lattice", {n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]}, repeats);
  }
};

}  // namespace

std::unique_ptr<AtomSource> gro_atoms(std::string_view text, const std::string& name, bool) {
  return std::make_unique<GroAtoms>(text, name);
}

std::unique_ptr<AtomSource> dump_atoms(std::string_view text, const std::string& name, bool) {
  return std::make_unique<DumpAtoms>(text, name);
}

std::unique_ptr<AtomSource> xyz_atoms(std::string_view text, const std::string& name, bool) {
  return std::make_unique<XyzAtoms>(text, name);
}

}  // namespace rbpa::app
