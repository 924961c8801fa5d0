// Source: https://www.wwpdb.org/documentation/file-format-content/format33/v3.3.html; numbers beyond the columns as in
//         http://cci.lbl.gov/hybrid_36
#include <algorithm>
#include <cctype>
#include <utility>

#include "io/cloud/atoms.h"
#include "io/failure.h"
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

/// Returns the decimal text of a number in so many columns, also in hybrid-36 notation: A000 in four columns is 10000.
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

class PdbAtoms final : public AtomSource {
 public:
  PdbAtoms(std::string_view text, const std::string& name) : lines_(text), name_(name) {}

  bool next(Atom& atom) override {
    while (lines_.next()) {
      const std::string_view line = lines_.line();
      if (line.starts_with("CRYST1"))
        cell_ = unit_cell("CRYST1", {at_columns(line, 7, 15), at_columns(line, 16, 24), at_columns(line, 25, 33),
                                     at_columns(line, 34, 40), at_columns(line, 41, 47), at_columns(line, 48, 54)});
      // Another structure, or the next frame of a simulation, may follow END.
      if (line.starts_with("MODEL ") || line.starts_with("ENDMDL") || line == "END") is_new_model_ = true;
      if (!is_atom(line)) continue;
      if (std::exchange(is_new_model_, false)) ++models_;
      if (models_ > 1) continue;
      take(line, atom);
      return true;
    }
    if (models_ == 0) bad_input(name_, "no record ATOM or HETATM", "the atoms of a file in PDB format");
    return false;
  }

 private:
  void take(std::string_view line, Atom& atom) const {
    atom.line = lines_.number();
    const std::size_t serial_end = has_digit(line, 11) && has_digit(line, 12) ? 12 : 11;
    const std::size_t residue_end = has_digit(line, 26) && has_digit(line, 27) ? 27 : 26;
    atom.fields = {number_in(at_columns(line, line.starts_with("HETATM") ? 7 : 5, serial_end), 5),
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
                   std::string(at_columns(line, 61, 66))};
  }

  Lines lines_;
  const std::string& name_;
  bool is_new_model_ = true;
};

}  // namespace

std::unique_ptr<AtomSource> pdb_atoms(std::string_view text, const std::string& name) {
  return std::make_unique<PdbAtoms>(text, name);
}

}  // namespace rbpa::app
