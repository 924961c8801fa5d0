// Source: https://www.wwpdb.org/documentation/file-format-content/format33/v3.3.html; numbers beyond the columns as in
//         http://cci.lbl.gov/hybrid_36; PQR: https://apbs.readthedocs.io/en/latest/formats/pqr.html
#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "io/cloud/atoms.h"
#include "io/failure.h"
#include "io/number.h"
#include "io/text/lines.h"

namespace rbpa::app {
namespace {

/// Returns the text in columns `first` to `last`, counted from 1.
std::string_view at_columns(std::string_view line, std::size_t first, std::size_t last) {
  if (line.size() < first) return {};
  return trimmed(line.substr(first - 1, last - first + 1));
}
bool has_digit(std::string_view line, std::size_t column) {
  return line.size() >= column && is_digit(line[column - 1]);
}

/// Returns whether a line is a record ATOM or HETATM. A serial number of six digits may take the blank after ATOM.
bool is_atom(std::string_view line) {
  const auto may_follow = [](char c) { return c == ' ' || is_digit(c); };
  return line.starts_with("HETATM") ||
         (line.starts_with("ATOM") && line.size() > 5 && may_follow(line[4]) && may_follow(line[5]));
}

std::string_view record_of(std::string_view atom) { return atom.substr(0, atom.starts_with("HETATM") ? 6 : 4); }

/// Returns the decimal text of a number in `columns` columns, also in hybrid-36: A000 in four columns is 10000.
/// Asterisks give an empty text.
std::string number_in(std::string_view text, std::size_t columns) {
  if (text.find_first_not_of('*') == std::string_view::npos) return {};
  const auto is_upper = [](char c) { return c >= 'A' && c <= 'Z'; };
  const auto is_lower = [](char c) { return c >= 'a' && c <= 'z'; };
  const bool upper = is_upper(text.front());
  const bool is_hybrid =
      text.size() == columns && (upper || is_lower(text.front())) &&
      std::all_of(text.begin(), text.end(), [&](char c) { return is_digit(c) || (upper ? is_upper(c) : is_lower(c)); });
  if (!is_hybrid) return std::string(text);
  std::size_t value = 0, decimal = 1, leading = 1;  // decimal becomes 10^columns, leading 36^(columns − 1)
  for (std::size_t i = 0; i < columns; ++i) {
    value =
        36 * value + static_cast<std::size_t>(is_digit(text[i]) ? text[i] - '0' : text[i] - (upper ? 'A' : 'a') + 10);
    decimal *= 10;
    if (i > 0) leading *= 36;
  }
  return std::to_string(upper ? value - 10 * leading + decimal : value + 16 * leading + decimal);
}

/// Returns the decimal text of a formal charge of two columns, "2+", "1-" or "-1"; empty for any other text, as files
/// before version 3 have other things there.
std::string formal_charge(std::string_view text) {
  const auto is_sign = [](char c) { return c == '+' || c == '-'; };
  if (text.size() != 2 || is_sign(text[0]) == is_sign(text[1]) || is_digit(text[0]) == is_digit(text[1])) return {};
  const std::size_t sign = is_sign(text[0]) ? 0 : 1;
  return (text[sign] == '-' ? "-" : "") + std::string(1, text[1 - sign]);
}

class PdbAtoms final : public AtomSource {
 public:
  PdbAtoms(std::string_view text, const std::string& name, bool is_pqr)
      : AtomSource(name), lines_(text), is_pqr_(is_pqr) {}

  bool next_frame() override {
    while (!waits_ || !is_new_frame_) {
      waits_ = find_atom();
      if (waits_) continue;
      if (frames_ == 0)
        bad_input(name_, "no record ATOM or HETATM",
                  is_pqr_ ? "the atoms of a file in PQR format" : "the atoms of a file in PDB format");
      return false;
    }
    is_new_frame_ = false;
    cell_ = next_cell_;
    ++frames_;
    return true;
  }

  bool next(Atom& atom) override {
    if (!waits_) waits_ = find_atom();
    if (!waits_ || is_new_frame_) return false;
    waits_ = false;
    is_pqr_ ? take_pqr(lines_.line(), atom) : take(lines_.line(), atom);
    return true;
  }

  bool has_radii() const override { return is_pqr_; }

 private:
  /// Goes to the next atom; returns false at the end of the file.
  bool find_atom() {
    while (lines_.next()) {
      const std::string_view line = lines_.line();
      if (line.starts_with("CRYST1")) {
        next_cell_ =
            unit_cell("CRYST1", {at_columns(line, 7, 15), at_columns(line, 16, 24), at_columns(line, 25, 33),
                                 at_columns(line, 34, 40), at_columns(line, 41, 47), at_columns(line, 48, 54)});
        next_cell_.symmetry = at_columns(line, 56, 66);
        if (!cell_.is_there()) cell_ = next_cell_;
      }
      // Another structure, or the next frame of a simulation, may follow END.
      if (line.starts_with("MODEL ") || line.starts_with("ENDMDL") || line == "END") is_new_frame_ = true;
      if (is_atom(line)) return true;
    }
    return false;
  }

  void take(std::string_view line, Atom& atom) const {
    atom.line = lines_.number();
    if (line.size() < 54 && !lines_.has_end())
      bad_input(at_line(name_, atom.line), in_quotes(line) + " at the end",
                "z in columns 47 to 54: is the file whole?");
    const std::string_view record = record_of(line);
    atom.name_begins = line.size() > 12 && line[12] != ' ' ? 13 : 14;
    const std::size_t serial_end = has_digit(line, 11) && has_digit(line, 12) ? 12 : 11;
    const std::size_t residue_end = has_digit(line, 26) && has_digit(line, 27) ? 27 : 26;
    atom.fields = {number_in(at_columns(line, record.size() + 1, serial_end), 5),
                   std::string(at_columns(line, 22, 22)),
                   number_in(at_columns(line, 23, residue_end), 4),
                   std::string(at_columns(line, residue_end + 1, 27)),
                   std::string(at_columns(line, 18, 21)),  // four letters in files of simulations
                   std::string(at_columns(line, 13, 16)),
                   std::string(at_columns(line, 77, 78)),
                   std::string(at_columns(line, 31, 38)),
                   std::string(at_columns(line, 39, 46)),
                   std::string(at_columns(line, 47, 54)),
                   std::string(at_columns(line, 17, 17)),
                   std::string(at_columns(line, 55, 60)),
                   std::string(at_columns(line, 61, 66)),
                   formal_charge(at_columns(line, 79, 80)),
                   std::string(record)};
  }

  /// Takes an atom of PQR: words, with or without the chain; or the columns of PDB, then words: charge, radius.
  void take_pqr(std::string_view line, Atom& atom) const {
    atom.line = lines_.number();
    const std::string_view record = record_of(line);
    atom.name_begins = 0;
    const std::vector<std::string_view> words = split_words(line.substr(record.size()));
    const bool has_chain = words.size() == 10;
    const auto is_any_number = [](std::string_view word) {
      return parse_whole_number(word).fault == NumberFault::none;
    };
    const bool are_words = (words.size() == 9 || has_chain) &&
                           std::any_of(words[words.size() - 6].begin(), words[words.size() - 6].end(), is_digit) &&
                           std::all_of(words.end() - 5, words.end(), is_any_number);
    if (!are_words) {
      const std::vector<std::string_view> behind = split_words(line.substr(std::min<std::size_t>(line.size(), 54)));
      if (behind.size() != 2)
        bad_input(at_line(name_, atom.line), in_quotes(line),
                  "an atom of PQR: serial, name, residue, chain or none, number, x, y, z, charge and radius");
      take(line, atom);
      atom.name_begins = 0;
      for (const std::size_t k : {AtomColumn::element, AtomColumn::occupancy, AtomColumn::bfactor})
        atom.fields[k].clear();
      atom.fields[AtomColumn::charge] = behind[0];
      atom.fields[AtomColumn::radius] = behind[1];
      return;
    }
    std::string_view number = words[has_chain ? 4 : 3], of_chain = has_chain ? words[3] : "";
    if (!has_chain && number.size() > 1 && std::isalpha(static_cast<unsigned char>(number.front())) != 0) {
      of_chain = number.substr(0, 1);  // "A1000": the columns of the chain and the number touch
      number.remove_prefix(1);
    }
    const std::size_t digits = std::min(number.find_last_of("0123456789") + 1, number.size());
    atom.fields = {number_in(words[0], 5),
                   std::string(of_chain),
                   std::string(number.substr(0, digits)),
                   std::string(number.substr(digits)),
                   std::string(words[2]),
                   std::string(words[1])};
    atom.fields[AtomColumn::record] = record;
    constexpr std::size_t last[] = {x_of_atom, x_of_atom + 1, x_of_atom + 2, AtomColumn::charge, AtomColumn::radius};
    for (std::size_t k = 0; k < 5; ++k) atom.fields[last[k]] = words[words.size() - 5 + k];
  }

  Lines lines_;
  bool is_pqr_;
  bool waits_ = false;  // the current line is the next atom
  bool is_new_frame_ = true;
  UnitCell next_cell_ = {};
};

}  // namespace

std::unique_ptr<AtomSource> pdb_atoms(std::string_view text, const std::string& name, bool) {
  return std::make_unique<PdbAtoms>(text, name, false);
}

std::unique_ptr<AtomSource> pqr_atoms(std::string_view text, const std::string& name, bool) {
  return std::make_unique<PdbAtoms>(text, name, true);
}

}  // namespace rbpa::app
