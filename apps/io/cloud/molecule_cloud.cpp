// Atoms as the table of their fields, which is read as any table is: a line for each line of the file, so that messages name the
// place in the file.
#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/cloud/readers.h"
#include "io/cloud/table_layout.h"
#include "io/failure.h"
#include "io/text/lines.h"

namespace rbpa::app {
namespace {

/// The atoms of the first model of a file, as lines of a table.
struct AtomTable {
  std::string lines = {};
  std::size_t models = 0;

  /// Passes over a line.
  void skip() { lines += "#\n"; }
  void append(const std::array<std::string_view, atom_columns.size()>& fields) {
    for (const std::string_view field : fields) {
      lines += field.empty() ? "?" : field;  // empty ones at an end would be no fields
      lines += '\t';
    }
    lines.back() = '\n';
  }
};

/// What stands in columns `first` to `last`, counted from 1.
std::string_view at_columns(std::string_view line, std::size_t first, std::size_t last) {
  if (line.size() < first) return {};
  return trimmed(line.substr(first - 1, last - first + 1));
}

/// The records ATOM and HETATM of wwPDB's format 3.3, which have their fields at fixed columns.
AtomTable atoms_of_pdb(std::string_view text) {
  AtomTable table;
  for (Lines lines(text); lines.next();) {
    const std::string_view line = lines.line();
    if (line.starts_with("ENDMDL")) ++table.models;
    if (table.models > 0 || !(line.starts_with("ATOM  ") || line.starts_with("HETATM"))) {
      table.skip();
      continue;
    }
    table.append({at_columns(line, 31, 38), at_columns(line, 39, 46), at_columns(line, 47, 54), at_columns(line, 7, 11),
                  at_columns(line, 13, 16), at_columns(line, 17, 17), at_columns(line, 18, 20),
                  at_columns(line, 22, 22), at_columns(line, 23, 26), at_columns(line, 55, 60),
                  at_columns(line, 61, 66), at_columns(line, 77, 78)});
  }
  return table;
}

/// The words of a line of CIF: apart at blanks, some between quotes, which end where a blank follows.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < line.size();) {
    if (is_blank(line[at])) {
      ++at;
      continue;
    }
    const char quote = line[at] == '\'' || line[at] == '"' ? line[at] : ' ';
    const std::size_t first = at + (quote == ' ' ? 0 : 1);
    std::size_t end = first;
    const auto ends = [&](std::size_t i) {
      if (quote == ' ') return is_blank(line[i]);
      return line[i] == quote && (i + 1 >= line.size() || is_blank(line[i + 1]));
    };
    while (end < line.size() && !ends(end)) ++end;
    const std::string_view word = line.substr(first, end - first);
    words.push_back(quote == ' ' && (word == "?" || word == ".") ? std::string_view() : word);  // no value
    at = end + (quote == ' ' ? 0 : 1);
  }
  return words;
}

/// The loop of _atom_site of PDBx/mmCIF, an atom a line.
AtomTable atoms_of_cif(std::string_view text, const std::string& name) {
  constexpr std::array<std::string_view, atom_columns.size()> known = {
      "Cartn_x",       "Cartn_y",      "Cartn_z",      "id",        "label_atom_id",  "label_alt_id",
      "label_comp_id", "auth_asym_id", "label_seq_id", "occupancy", "B_iso_or_equiv", "type_symbol"};
  constexpr std::string_view prefix = "_atom_site.";
  AtomTable table;
  std::vector<std::string_view> columns;  // of the loop
  std::array<std::size_t, known.size()> place{};
  std::size_t model = 0;  // its column
  std::string_view first_model;
  const auto place_of = [&](std::string_view column) {
    return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin());
  };
  bool in_rows = false, in_text = false;  // a value of several lines, from one that begins with a semicolon to another
  for (Lines lines(text); lines.next();) {
    const std::string_view line = lines.line();
    const bool is_first_column = line.data() == text.data() || line.data()[-1] == '\n';
    const bool has_mark = line.starts_with(';') && is_first_column;
    if (in_text || (has_mark && !in_rows)) {
      in_text = in_text != has_mark;
      table.skip();
      continue;
    }
    if (line.starts_with(prefix)) {
      columns.push_back(trimmed(line.substr(prefix.size())));
      table.skip();
      continue;
    }
    const bool ends =
        line.empty() || line.starts_with('#') || line.starts_with('_') || line == "loop_" || line.starts_with("data_");
    if (columns.empty() || ends) {
      if (in_rows) columns.clear();
      in_rows = false;
      table.skip();
      continue;
    }
    if (!in_rows) {
      in_rows = true;
      for (std::size_t k = 0; k < known.size(); ++k) place[k] = place_of(known[k]);
      model = place_of("pdbx_PDB_model_num");
      for (std::size_t k = 0; k < 3; ++k)
        if (place[k] == columns.size())
          bad_input(at_line(name, lines.number()), "atoms without _atom_site." + std::string(known[k]),
                    "Cartn_x, Cartn_y and Cartn_z");
    }
    const std::vector<std::string_view> words = words_of(line);
    if (words.size() != columns.size())
      bad_input(at_line(name, lines.number()), counted(words.size(), "value") + " (" + in_quotes(line) + ")",
                std::to_string(columns.size()) + ", one for each name of _atom_site");
    if (model < words.size()) {
      if (table.models == 0 || words[model] != first_model) ++table.models;
      if (table.models == 1) first_model = words[model];
      if (words[model] != first_model) {
        table.skip();
        continue;
      }
    }
    std::array<std::string_view, known.size()> fields;
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (place[k] < words.size()) fields[k] = words[place[k]];
    table.append(fields);
  }
  return table;
}

class MoleculeCloud final : public Cloud {
 public:
  MoleculeCloud(AtomTable table, const std::string& name, const CloudRequest& request)
      : text_(std::move(table.lines)), models_(table.models), atoms_(open_atoms(Content(text_, name), request)) {
    std::swap(facts_, atoms_->facts());
  }

  bool next(CloudBlock& block) override { return atoms_->next(block); }
  void finish() override {
    atoms_->finish();
    std::vector<std::string>& remarks = facts_.file.remarks;
    std::vector<std::string>& more = atoms_->facts().file.remarks;
    remarks.insert(remarks.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    facts_.file.keys = std::move(atoms_->facts().file.keys);
    if (models_ > 1) remarks.push_back("the atoms are those of the first of " + std::to_string(models_) + " models");
  }

 private:
  std::string text_;
  std::size_t models_;
  std::unique_ptr<Cloud> atoms_;
};

}  // namespace

std::unique_ptr<Cloud> open_pdb(Content content, const CloudRequest& request) {
  return std::make_unique<MoleculeCloud>(atoms_of_pdb(content.ahead()), content.name(), request);
}
std::unique_ptr<Cloud> open_cif(Content content, const CloudRequest& request) {
  return std::make_unique<MoleculeCloud>(atoms_of_cif(content.ahead(), content.name()), content.name(), request);
}

}  // namespace rbpa::app
