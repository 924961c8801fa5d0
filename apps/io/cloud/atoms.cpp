#include "io/cloud/atoms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "io/cloud/chemical_elements.h"
#include "io/failure.h"
#include "io/number.h"
#include "io/text/line_selection.h"

namespace rbpa::app {
namespace {

/// Returns the cosine of an angle in degrees; exact for 60, 90 and 120 degrees.
double cosine(double degrees) {
  for (const auto& [angle, exact] : {std::pair(60.0, 0.5), {90.0, 0.0}, {120.0, -0.5}})
    if (degrees == angle) return exact;
  return std::cos(degrees * (std::numbers::pi / 180));
}

}  // namespace

std::size_t atom_column(std::string_view name) {
  const auto found = std::find_if(atom_columns.begin(), atom_columns.end(),
                                  [&](std::string_view known) { return same_letters(known, name); });
  return static_cast<std::size_t>(found - atom_columns.begin());
}

bool is_text_of_atom(std::size_t column) {
  constexpr std::string_view texts[] = {"chain", "icode", "resname", "name", "element", "altloc", "record"};
  return column < no_atom_column &&
         std::find(std::begin(texts), std::end(texts), atom_columns[column]) != std::end(texts);
}

bool is_water(std::string_view residue) {
  constexpr std::string_view waters[] = {"HOH",  "DOD",  "WAT", "H2O", "OH2",   "TIP",   "TIP3",  "TP3", "TIP4",
                                         "TIP5", "TP4",  "TP5", "SOL", "SPC",   "TIP3P", "TIP4P", "T3P", "T4P",
                                         "SPCE", "HOH2", "HO4", "T5P", "TIP5P", "TIP2",  "D2O"};
  return std::find(std::begin(waters), std::end(waters), residue) != std::end(waters);
}

double AtomSource::parsed(const Atom& atom, std::size_t column, std::string_view where) const {
  const ParsedNumber number = parse_whole_number(text(atom, column));
  if (number.fault == NumberFault::none) return number.value;
  bad_input(at_line(name_, atom.line),
            in_quotes(text(atom, column)) +
                (column < no_atom_column ? " as " + std::string(atom_columns[column]) : std::string()),
            expected_instead(number.fault) + std::string(where));
}

double AtomSource::number(const Atom& atom, std::size_t column, std::string_view where) const {
  return text(atom, column).empty() ? std::numeric_limits<double>::quiet_NaN() : parsed(atom, column, where);
}

Point3 AtomSource::center(const Atom& atom) const {
  return {parsed(atom, x_of_atom, ""), parsed(atom, x_of_atom + 1, ""), parsed(atom, x_of_atom + 2, "")};
}

std::size_t AtomSource::column(std::string_view name) const {
  const std::size_t found = atom_column(name);
  if (found == no_atom_column) bad_input(name_, "no column " + in_quotes(name), "a column of atoms");
  return found;
}

std::vector<std::pair<std::string, std::size_t>> AtomSource::other_columns() const {
  std::vector<std::pair<std::string, std::size_t>> all;
  for (std::size_t k = 0; k < no_atom_column; ++k)
    if (k < x_of_atom || k >= x_of_atom + 3) all.emplace_back(atom_columns[k], k);
  return all;
}

AtomSelection::AtomSelection(const Condition& where, const AtomSource& source) : source_(source), selection_(where) {
  for (const std::string& field : where.fields()) places_.push_back(source.column(field));
  for (const Condition::Text& text : where.texts()) texts_.emplace_back(source.column(text.field), text.text);
  for (std::size_t k = 0; k < where.columns(); ++k) {
    const WantedColumn::Kind kind = where.column(k).kind;
    is_text_.push_back(kind == WantedColumn::Kind::by_value ? is_text_of_atom(places_[k])
                                                            : kind == WantedColumn::Kind::text);
  }
}

bool AtomSelection::names_residue(std::string_view name) const {
  return std::any_of(texts_.begin(), texts_.end(),
                     [&](const auto& text) { return text.first == AtomColumn::resname && text.second == name; });
}

bool AtomSelection::holds(const Atom& atom) {
  const auto number = [&](std::size_t field) { return source_.number(atom, places_[field], of_where); };
  // '?' matches an empty value, as in PDBx/mmCIF. An element is that of the column, or the one that is used.
  const auto is_text = [&](std::size_t k) {
    const auto& [column, text] = texts_[k];
    const std::string& field = AtomSource::text(atom, column);
    if (column == AtomColumn::element && (same_letters(field, text) || same_letters(element_of(atom), text)))
      return true;
    return field == text || (field.empty() && text == "?");
  };
  return selection_.holds(number, is_text);
}

double AtomSelection::number(const Atom& atom, std::size_t k) const {
  return source_.number(atom, places_[k], of_where);
}

std::optional<CellEdges> edges_of_cell(const std::array<double, 6>& lengths_and_angles) {
  const auto& [a, b, c, alpha, beta, gamma] = lengths_and_angles;
  for (const double length : {a, b, c})
    if (!(length > 0 && std::isfinite(length))) return std::nullopt;
  for (const double angle : {alpha, beta, gamma})
    if (!(angle > 0 && angle < 180)) return std::nullopt;
  const double cos_a = cosine(alpha), cos_b = cosine(beta), cos_c = cosine(gamma);
  const double sin_c = std::sqrt(1 - cos_c * cos_c), y = (cos_a - cos_b * cos_c) / sin_c;
  const double height = 1 - cos_b * cos_b - y * y;
  if (!(height > 0)) return std::nullopt;
  return {{{{a, 0, 0}, {b * cos_c, b * sin_c, 0}, {c * cos_b, c * y, c * std::sqrt(height)}}}};
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
  if (numbers[0] == 1 && numbers[1] == 1 && numbers[2] == 1)
    return {.fault = record + " of 1 x 1 x 1, which stands for none"};
  return unit_cell(record, numbers);
}

std::string warning_of_symmetry(const UnitCell& cell) {
  std::string name = cell.symmetry;
  std::erase(name, ' ');
  if (name.empty() || same_letters(name, "P1")) return {};
  return "the cell has the space group " + shown(cell.symmetry) +
         ", and the file one of the copies of the atoms in it: the box has no others (apply the symmetry first)";
}

UnitCell unit_cell(const std::string& record, const std::array<double, 6>& lengths_and_angles) {
  const auto& [a, b, c, alpha, beta, gamma] = lengths_and_angles;
  UnitCell cell{.edges = edges_of_cell(lengths_and_angles)};
  if (alpha == 90 && beta == 90 && gamma == 90)
    cell.sides = {{a, b, c}};
  else
    cell.fault =
        record + " with angles of " + text_of(alpha) + ", " + text_of(beta) + " and " + text_of(gamma) + " degrees";
  return cell;
}

UnitCell unit_cell(const std::string& record, const std::array<double, 9>& edges, const std::array<bool, 3>& repeats) {
  const auto& [ax, ay, az, bx, by, bz, cx, cy, cz] = edges;
  const double volume = ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx);
  if (!(volume != 0 && std::isfinite(volume))) return {.fault = record + " without a volume, which stands for none"};
  UnitCell cell{.edges = CellEdges{{{ax, ay, az}, {bx, by, bz}, {cx, cy, cz}}}, .repeats = repeats};
  const bool has_right_angles = ay == 0 && az == 0 && bx == 0 && bz == 0 && cx == 0 && cy == 0;
  if (!(has_right_angles && ax > 0 && by > 0 && cz > 0))
    cell.fault = record + " with edges that are not along x, y and z";
  else if (repeats != std::array{true, true, true})
    cell.fault = record + " that does not repeat along all of x, y and z";
  else
    cell.sides = {{ax, by, cz}};
  return cell;
}

std::vector<std::string> warnings_of_range(std::span<const Point3> points, const CellEdges& box,
                                           const std::string& noun) {
  if (points.empty()) return {};
  std::string reach, of_box;
  bool is_over = false;
  for (const auto coordinate : {&Point3::x, &Point3::y, &Point3::z}) {
    const auto less = [&](const Point3& a, const Point3& b) { return a.*coordinate < b.*coordinate; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    double size = 0;
    for (const Point3& edge : box) size += std::abs(edge.*coordinate);
    const double distance = (*high).*coordinate - (*low).*coordinate;
    is_over |= distance > 2 * size;
    reach += (reach.empty() ? "" : " x ") + rounded(distance, 3);
    of_box += (of_box.empty() ? "" : " x ") + rounded(size, 3);
  }
  if (!is_over) return {};
  return {noun + " reach over " + reach + ", more than twice the box, which reaches over " + of_box +
          ": is it in their unit? (coordinates count modulo its edges)"};
}

std::string_view without_uncertainty(std::string_view number) {
  const std::size_t bracket = number.find('(');
  const std::string_view digits = number.substr(std::min(bracket, number.size()));
  const bool is_one =
      digits.size() > 2 && digits.back() == ')' && digits.find_first_not_of("0123456789", 1) == digits.size() - 1;
  return is_one ? number.substr(0, bracket) : number;
}

}  // namespace rbpa::app
