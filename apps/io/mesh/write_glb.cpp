#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "io/failure.h"
#include "io/mesh/single_precision.h"
#include "io/mesh/write_mesh.h"

// glTF 2.0, binary: a header, a chunk of JSON, a chunk of numbers (Khronos, glTF 2.0 specification, section 4.4).

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int unsigned_short = 5123, unsigned_int = 5125, single_float = 5126;  // componentType
constexpr int array_buffer = 34962, element_array_buffer = 34963;               // target

/// Returns the normals with length 1, as the format demands; empty if a normal has no direction.
std::vector<std::array<float, 3>> unit_normals(std::span<const Point3> normals) {
  std::vector<std::array<float, 3>> units;
  units.reserve(normals.size());
  for (const Point3& n : normals) {
    const double larger = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    if (!(larger > 0) || !std::isfinite(larger)) return {};
    const double x = n.x / larger, y = n.y / larger, z = n.z / larger, length = std::sqrt(x * x + y * y + z * z);
    units.push_back({static_cast<float>(x / length), static_cast<float>(y / length), static_cast<float>(z / length)});
  }
  return units;
}

/// Returns sRGB colors as linear colors, as the format demands for vertices, each with full opacity, so that a color
/// has 8 bytes.
std::vector<std::array<std::uint16_t, 4>> linear_colors(std::span<const std::array<std::uint8_t, 3>> colors) {
  std::array<std::uint16_t, 256> linear;
  for (std::size_t i = 0; i < linear.size(); ++i) {
    const double s = static_cast<double>(i) / 255, l = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    linear[i] = static_cast<std::uint16_t>(std::lround(65535 * l));
  }
  std::vector<std::array<std::uint16_t, 4>> result;
  result.reserve(colors.size());
  for (const auto& [red, green, blue] : colors) result.push_back({linear[red], linear[green], linear[blue], 65535});
  return result;
}

/// The chunk of numbers, and its accessors in JSON. Refers to the added data, which must outlive this object.
class Numbers {
 public:
  /// Adds an array and returns the number of its accessor.
  template <typename Row>
  std::size_t add(std::span<const Row> rows, int target, int component, const char* type, std::size_t count,
                  const Json& more = Json::object()) {
    const auto bytes = std::as_bytes(rows);
    views_.push_back({{"buffer", 0}, {"byteOffset", size_}, {"byteLength", bytes.size()}, {"target", target}});
    Json accessor = {{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", count}, {"type", type}};
    accessor.update(more);
    accessors_.push_back(accessor);
    size_ += bytes.size();  // the size of every row is a multiple of four bytes
    write_.push_back([rows](OutputFile& file) {
      for (const Row& row : rows) file.write_binary(row);
    });
    return accessors_.size() - 1;
  }

  std::uint64_t size() const { return size_; }
  const Json& views() const { return views_; }
  const Json& accessors() const { return accessors_; }
  void write(OutputFile& file) const {
    for (const auto& write : write_) write(file);
  }

 private:
  std::uint64_t size_ = 0;
  Json views_ = Json::array(), accessors_ = Json::array();
  std::vector<std::function<void(OutputFile&)>> write_;
};

void write_word(OutputFile& file, std::uint64_t word) { file.write_binary(static_cast<std::uint32_t>(word)); }

void write_container(OutputFile& file, const Json& json, const Numbers& numbers) {
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::uint64_t size = 12 + 8 + text.size() + (numbers.size() == 0 ? 0 : 8 + numbers.size());
  if (size > std::numeric_limits<std::uint32_t>::max())
    bad_input(file.name(), counted(size, "byte"), "fewer than 2^32 in a GLB file (.ply has no limit)");
  file.write("glTF");
  write_word(file, 2);
  write_word(file, size);
  write_word(file, text.size());
  file.write("JSON");
  file.write(text);
  if (numbers.size() == 0) return;
  write_word(file, numbers.size());
  file.write({"BIN\0", 4});
  numbers.write(file);
}

}  // namespace

void write_glb(OutputFile& file, const SpaceMesh& mesh) {
  Json json = {{"asset", {{"version", "2.0"}, {"generator", "rbpa"}}}, {"scene", 0}};
  Numbers numbers;
  if (mesh.triangles.empty()) {  // the format cannot have a mesh without triangles
    json["scenes"] = Json::array({Json::object()});
    return write_container(file, json, numbers);
  }
  const SinglePositions positions = kept_positions(file, Format::glb, mesh);
  std::array<float, 3> least = positions.at.front(), greatest = least;
  for (const std::array<float, 3>& p : positions.at)
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], p[k]);
      greatest[k] = std::max(greatest[k], p[k]);
    }
  const std::vector<std::array<float, 3>> normals = unit_normals(mesh.normals);
  const std::vector<std::array<std::uint16_t, 4>> colors = linear_colors(mesh.colors);
  using Floats = std::span<const std::array<float, 3>>;
  Json attributes;
  attributes["POSITION"] = numbers.add(Floats(positions.at), array_buffer, single_float, "VEC3", positions.at.size(),
                                       {{"min", least}, {"max", greatest}});
  if (!normals.empty())
    attributes["NORMAL"] = numbers.add(Floats(normals), array_buffer, single_float, "VEC3", normals.size());
  if (!colors.empty())
    attributes["COLOR_0"] = numbers.add(std::span<const std::array<std::uint16_t, 4>>(colors), array_buffer,
                                        unsigned_short, "VEC4", colors.size(), {{"normalized", true}});
  const std::size_t indices =
      numbers.add(mesh.triangles, element_array_buffer, unsigned_int, "SCALAR", 3 * mesh.triangles.size());

  Json node = {{"mesh", 0}};
  if (positions.shift != Position{}) node["translation"] = positions.shift;
  json["scenes"] = Json::array({{{"nodes", {0}}}});
  json["nodes"] = Json::array({node});
  json["meshes"] = Json::array(
      {{{"primitives", Json::array({{{"attributes", attributes}, {"indices", indices}, {"material", 0}}})}}});
  json["materials"] =
      Json::array({{{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}, {"doubleSided", true}}});
  json["buffers"] = Json::array({{{"byteLength", numbers.size()}}});
  json["bufferViews"] = numbers.views();
  json["accessors"] = numbers.accessors();
  write_container(file, json, numbers);
}

}  // namespace rbpa::app
