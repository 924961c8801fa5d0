#include "meshtopo/places.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

namespace rbpa::app {
namespace {

template <typename Number>
std::vector<std::size_t> lines_of(std::span<const Number> numbers, const std::vector<std::size_t>& lines) {
  std::vector<std::size_t> result;
  if (!lines.empty())
    for (const Number number : numbers) result.push_back(lines[number]);
  return result;
}

/// Appends ", face 7" or ", faces 0 7" with the noun `one` or `several`; appends nothing if there are no numbers.
template <typename Number>
void append(std::string& text, std::string_view one, std::string_view several, std::span<const Number> numbers) {
  constexpr std::size_t most = 8;
  if (numbers.empty()) return;
  if (!text.empty()) text += ", ";
  text += numbers.size() == 1 ? one : several;
  for (const Number number : numbers.first(std::min(numbers.size(), most)))
    text.append(" ").append(std::to_string(number));
  if (numbers.size() > most) text += " ... (" + std::to_string(numbers.size()) + ")";
}

}  // namespace

std::string for_people(const Place& place, const MeshFile& mesh) {
  std::vector<std::size_t> lines = lines_of(place.faces, mesh.face_lines);
  if (lines.empty()) lines = lines_of(place.vertices, mesh.point_lines);
  std::string text;
  append(text, "vertex", "vertices", place.vertices);
  append(text, "face", "faces", place.faces);
  append(text, "line", "lines", std::span<const std::size_t>(lines));
  return text;
}

nlohmann::ordered_json as_json(const Place& place, const MeshFile& mesh) {
  nlohmann::ordered_json where = {{"vertices", place.vertices}, {"faces", place.faces}};
  if (!mesh.point_lines.empty()) where["vertex_lines"] = lines_of(place.vertices, mesh.point_lines);
  if (!mesh.face_lines.empty()) where["face_lines"] = lines_of(place.faces, mesh.face_lines);
  return where;
}

}  // namespace rbpa::app
