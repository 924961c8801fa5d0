#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "io/cloud/atom_frames.h"
#include "io/cloud/atoms.h"
#include "io/cloud/ball_radii.h"
#include "io/cloud/chemical_elements.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "python/file_errors.h"
#include "python/module.h"

namespace rbpa::python {
namespace {

using app::AtomFrame;
using app::AtomRow;
using MaybeText = std::optional<std::string>;

/// Puts the atoms of a frame in the order of the first frame, if the serials are the same numbers in another order, as
/// in dumps that are not sorted.
void sort_as(const AtomFrame& first, AtomFrame& frame) {
  std::map<double, std::size_t> place;
  for (const AtomRow& row : first.rows)
    if (!std::isnan(row.serial)) place.try_emplace(row.serial, place.size());
  if (place.size() != first.rows.size() || frame.rows.size() != place.size()) return;
  std::vector<AtomRow> sorted(place.size());
  std::vector<bool> is_taken(place.size(), false);
  for (const AtomRow& row : frame.rows) {
    const auto at = std::isnan(row.serial) ? place.end() : place.find(row.serial);
    if (at == place.end() || is_taken[at->second]) return;
    is_taken[at->second] = true;
    sorted[at->second] = row;
  }
  frame.rows = std::move(sorted);
}

/// All frames that were read. Names of atoms are those of the first frame.
struct Frames {
  AtomFrame first = {};
  std::vector<Point3> positions = {};
  std::vector<double> radii = {};  // empty if the file has no radii
  std::vector<double> boxes = {};  // the nine numbers of each frame whose cell repeats along all edges
  std::vector<std::size_t> numbers = {};
  std::vector<std::string> warnings = {};
};

/// Throws BadInput that names the first difference unless the atoms of a frame are those of the first frame.
void require_same_atoms(const AtomFrame& frame, const AtomFrame& first, const std::string& file) {
  const std::string number = std::to_string(frame.number);
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    app::bad_input(
        file, found + " in frame " + number,
        expected + ", as in frame " + std::to_string(first.number) + " (models=" + number + " reads this frame alone)");
  };
  if (frame.rows.size() != first.rows.size())
    refuse(app::counted(frame.rows.size(), "atom"), std::to_string(first.rows.size()));
  for (std::size_t i = 0; i < frame.rows.size(); ++i) {
    const AtomRow &row = frame.rows[i], &before = first.rows[i];
    const std::string of_atom = std::isnan(row.serial) ? std::to_string(row.index) : app::text_of(row.serial);
    for (const auto& [what, member] : {std::pair("name ", &AtomRow::name),
                                       {"residue ", &AtomRow::resname},
                                       {"chain ", &AtomRow::chain},
                                       {"element ", &AtomRow::element}})
      if (row.*member != before.*member)
        refuse(what + app::in_quotes(frame.text(row.*member)) + " of atom " + of_atom,
               app::in_quotes(first.text(before.*member)));
    if (row.resseq != before.resseq && !std::isnan(row.resseq))
      refuse("residue number " + app::text_of(row.resseq) + " of atom " + of_atom, app::text_of(before.resseq));
  }
}

Frames read_frames(app::AtomFrames& file) {
  Frames result;
  for (AtomFrame frame; file.next(frame);) {
    if (result.numbers.empty()) {
      result.first = frame;
    } else {
      sort_as(result.first, frame);
      require_same_atoms(frame, result.first, file.name());
    }
    result.numbers.push_back(frame.number);
    if (const app::UnitCell& cell = frame.cell; cell.edges && cell.repeats == std::array{true, true, true})
      for (const Point3& edge : *cell.edges) result.boxes.insert(result.boxes.end(), {edge.x, edge.y, edge.z});
    for (const AtomRow& row : frame.rows) {
      result.positions.push_back(row.center);
      if (frame.has_radii) result.radii.push_back(row.radius);
    }
  }
  result.warnings = file.warnings();
  if (const std::string text = app::warning_of_symmetry(result.first.cell); !text.empty())
    result.warnings.push_back(text);
  return result;
}

/// Returns the edges of a cell as three rows, or None. Requires: six numbers.
std::optional<std::vector<std::vector<double>>> edges_of_cell(const std::vector<double>& lengths_and_angles) {
  std::array<double, 6> numbers{};
  std::copy_n(lengths_and_angles.begin(), std::min<std::size_t>(lengths_and_angles.size(), 6), numbers.begin());
  const auto edges = app::edges_of_cell(numbers);
  if (!edges) return std::nullopt;
  std::vector<std::vector<double>> rows;
  for (const Point3& edge : *edges) rows.push_back({edge.x, edge.y, edge.z});
  return rows;
}

/// Returns warnings about centers of shape (n, 3), and a box whose edges are the rows of `cell`, of shape (3, 3).
std::vector<std::string> warnings_of_range(const Doubles& centers, const Doubles& cell) {
  require_shape(cell.ndim() == 2 && cell.shape(0) == 3 && cell.shape(1) == 3, cell, "cell", "(3, 3)");
  return app::warnings_of_range(points3_of(centers, "centers"), *reinterpret_cast<const app::CellEdges*>(cell.data()),
                                "centers");
}

/// Returns a column of texts as a pair: for each atom the position of its text in a list, and the list.
py::tuple texts_of(const AtomFrame& frame, std::uint32_t AtomRow::*member) {
  py::list texts;
  for (const std::string& text : frame.texts) texts.append(app::printable(text));
  return py::make_tuple(line<std::int32_t>(frame.column(member)), texts);
}

py::dict read_atoms(const py::bytes& path, const MaybeText& format, const std::string& models, bool waters,
                    bool ligands, bool hydrogens, bool alternates, const MaybeText& where, const MaybeText& radius) {
  return with_file_errors([&] {
    const std::string file_name = path;
    const auto found = app::find_format(app::Use::space, format ? *format : app::input_ending(file_name));
    if (!found && format) app::refuse_name("format", *format, app::endings(app::Use::space));
    if (!found) app::refuse_input(file_name, app::Use::space, "format");
    Frames made = watched(long_work, py::none(), [&](Watch& watch) {
      const app::Interruption interruption(watch.until_stopped());
      app::AtomFrames file(file_name, *found,
                           {.frames = app::parse_frames("models", models),
                            .waters = waters,
                            .ligands = ligands,
                            .hydrogens = hydrogens,
                            .alternates = alternates,
                            .where = where,
                            .radius = radius});
      return read_frames(file);
    });
    const AtomFrame& first = made.first;
    py::dict result;
    result["positions"] = rows<double>(std::move(made.positions));
    result["radii"] = first.has_radii ? py::object(line<double>(std::move(made.radii))) : py::object(py::none());
    const bool has_boxes = !made.numbers.empty() && made.boxes.size() == 9 * made.numbers.size();
    result["box"] = has_boxes ? py::object(line<double>(std::move(made.boxes))) : py::object(py::none());
    result["frames"] = made.numbers;
    result["warnings"] = made.warnings;
    py::dict left_out, columns;
    for (const auto& [name, count] : {std::pair("where", &app::AtomCounts::deselected),
                                      {"waters", &app::AtomCounts::waters},
                                      {"ligands", &app::AtomCounts::ligands},
                                      {"hydrogens", &app::AtomCounts::hydrogens},
                                      {"alternates", &app::AtomCounts::alternates}})
      left_out[name] = first.counts.*count;
    for (const auto& [name, text] : {std::pair("elements", &AtomRow::element),
                                     {"names", &AtomRow::name},
                                     {"residue_names", &AtomRow::resname},
                                     {"insertion_codes", &AtomRow::icode},
                                     {"chains", &AtomRow::chain},
                                     {"records", &AtomRow::record}})
      columns[name] = texts_of(first, text);
    for (const auto& [name, number] : {std::pair("residue_numbers", &AtomRow::resseq),
                                       {"serials", &AtomRow::serial},
                                       {"occupancies", &AtomRow::occupancy},
                                       {"bfactors", &AtomRow::bfactor},
                                       {"charges", &AtomRow::charge}})
      columns[name] = line<double>(first.column(number));
    columns["index"] = line<std::int64_t>(first.column(&AtomRow::index));
    result["left_out"] = left_out;
    result["columns"] = columns;
    return result;
  });
}

/// The element, residue and name that several atoms share, and the index of the first of these atoms.
using AtomKind = std::tuple<std::string, std::string, std::string, std::size_t>;

Doubles atom_radii(const std::vector<AtomKind>& kinds, const std::string& choice, std::optional<double> otherwise,
                   const std::map<std::string, double>& overrides) {
  return with_file_errors([&] {
    app::BallRadii radii(choice, otherwise);
    for (const auto& [element, radius] : overrides) radii.override_element(element, radius);
    AtomFrame frame;
    frame.number_of("");
    for (const auto& [element, residue, name, index] : kinds) {
      app::Atom atom;
      atom.fields[app::AtomColumn::element] = element;
      atom.fields[app::AtomColumn::resname] = residue;
      atom.fields[app::AtomColumn::name] = name;
      const std::string_view symbol = app::element_of(atom);
      AtomRow& row = frame.rows.emplace_back();
      row.element = frame.number_of(symbol.empty() ? std::string_view(element) : symbol);
      row.resname = frame.number_of(residue);
      row.name = frame.number_of(name);
      row.index = index;
    }
    return line<double>(radii.of(frame, "atoms"));
  });
}

}  // namespace

void bind_molecules(py::module_& module) {
  using py::arg;
  module.def("edges_of_cell", &edges_of_cell, arg("lengths_and_angles"));
  module.def("warnings_of_range", &warnings_of_range, as_is("centers"), as_is("cell"));
  module.def("read_atoms", &read_atoms, arg("path"), arg("format"), arg("models"), arg("waters"), arg("ligands"),
             arg("hydrogens"), arg("alternates"), arg("where"), arg("radius"));
  module.def("atom_radii", &atom_radii, arg("kinds"), arg("choice"), arg("otherwise"), arg("overrides"));
}

}  // namespace rbpa::python
