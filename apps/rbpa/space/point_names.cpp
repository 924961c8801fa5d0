#include "space/point_names.h"

#include <algorithm>
#include <charconv>
#include <cstddef>

#include "io/cloud/atoms.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

/// Returns a number if `text` is exactly the text of a whole number, null if it is empty, otherwise a string, as JSON.
Json value_of(const std::string& text) {
  std::int64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc() && stop == end && std::to_string(number) == text) return number;
  return text.empty() ? Json() : Json(text);
}

}  // namespace

Json PointNames::indices(std::span<const std::uint32_t> points) const { return renumbered(points, file_.index); }

bool PointNames::has(std::size_t column) const { return column < file_.texts.size() && file_.texts[column]; }

bool PointNames::has_any() const {
  return std::any_of(file_.texts.begin(), file_.texts.end(), [](const auto& texts) { return texts.has_value(); });
}

const std::string& PointNames::text(std::size_t column, std::uint32_t point) const {
  return (*file_.texts[column])[static_cast<std::size_t>(file_.fields[column][point])];
}

Json PointNames::atoms(std::span<const std::uint32_t> points) const {
  Json all = Json::array();
  for (const std::uint32_t point : points) {
    Json& atom = all.emplace_back(Json::object());
    for (std::size_t k = 0; k < names_of_atom; ++k) {
      if (!has(k)) continue;
      const bool is_text = atom_columns[k] != "serial" && atom_columns[k] != "resseq";
      const std::string& name = text(k, point);
      atom[std::string(atom_columns[k])] = is_text && !name.empty() ? Json(name) : value_of(name);
    }
    const Point3& p = file_.points[point];
    atom.update({{"x", p.x}, {"y", p.y}, {"z", p.z}});
  }
  return all;
}

}  // namespace rbpa::app
