// Surfaces as .glb and .vtu: a reader by the rules of the formats finds the surface in them.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "support/program.h"
#include "support/vtu_arrays.h"

using namespace apps_test;
using nlohmann::json;

namespace {

template <typename T>
T value_at(const std::string& bytes, std::size_t at) {
  T value{};
  REQUIRE(at + sizeof value <= bytes.size());
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// A .glb, split into chunks whose sizes are checked.
struct Scene {
  json tree;
  std::string numbers;

  explicit Scene(const std::string& glb) {
    REQUIRE(glb.substr(0, 4) == "glTF");
    CHECK(value_at<std::uint32_t>(glb, 4) == 2);
    CHECK(value_at<std::uint32_t>(glb, 8) == glb.size());
    const auto size = value_at<std::uint32_t>(glb, 12);
    CHECK(size % 4 == 0);
    CHECK(glb.substr(16, 4) == "JSON");
    tree = json::parse(glb.substr(20, size));
    if (glb.size() == 20 + size) return;
    CHECK(value_at<std::uint32_t>(glb, 20 + size) == glb.size() - 28 - size);
    CHECK(glb.substr(24 + size, 4) == std::string("BIN\0", 4));
    numbers = glb.substr(28 + size);
    CHECK(tree["buffers"][0]["byteLength"] == numbers.size());
  }

  const json& primitive() const { return tree["meshes"][0]["primitives"][0]; }
  bool has(const char* attribute) const { return primitive()["attributes"].contains(attribute); }

  template <typename T>
  std::vector<T> values(const json& accessor_number, int component, const std::string& type) const {
    const json& accessor = tree["accessors"][accessor_number.get<std::size_t>()];
    CHECK(accessor["componentType"] == component);
    CHECK(accessor["type"] == type);
    const json& view = tree["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t offset = view["byteOffset"],
                      components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type[3] - '0');
    CHECK(offset % 4 == 0);
    std::vector<T> result(accessor["count"].get<std::size_t>() * components);
    CHECK(view["byteLength"] == result.size() * sizeof(T));
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = value_at<T>(numbers, offset + i * sizeof(T));
    return result;
  }
  std::vector<float> positions() const { return values<float>(primitive()["attributes"]["POSITION"], 5126, "VEC3"); }
  std::vector<std::uint32_t> indices() const { return values<std::uint32_t>(primitive()["indices"], 5125, "SCALAR"); }
};

/// Rows of an OBJ file that begin with that word.
std::vector<std::array<double, 3>> rows(const std::string& obj, const std::string& word) {
  std::vector<std::array<double, 3>> found;
  for (std::size_t at = 0; at < obj.size(); at = obj.find('\n', at) + 1)
    if (obj.compare(at, word.size() + 1, word + " ") == 0) {
      std::array<double, 3> row;
      REQUIRE(std::sscanf(obj.c_str() + at + word.size(), "%lf %lf %lf", &row[0], &row[1], &row[2]) == 3);
      found.push_back(row);
    }
  return found;
}

/// A sheet of a grid in space, with colors.
std::string sheet(double origin) {
  std::string text = "x y z r g b\n";
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      text += std::to_string(origin + i) + " " + std::to_string(origin + j + 0.125) + " 0.5 " + std::to_string(25 * i) +
              " 128 255\n";
  return text;
}

}  // namespace

TEST_SUITE("surface scenes") {
  TEST_CASE("a scene has the positions, triangles, normals and linear colors of the surface") {
    const Folder folder("s.txt", sheet(0));
    REQUIRE(folder.rbpa("surface s.txt --radius 1 -o m.glb -o m.obj --manifold -q").code == 0);
    const Scene scene(folder.content("m.glb"));
    CHECK(scene.tree["asset"]["version"] == "2.0");
    CHECK_FALSE(scene.tree["nodes"][0].contains("translation"));  // floats hold these
    const std::string obj = folder.content("m.obj");
    const auto vertices = rows(obj, "v"), faces = rows(obj, "f");
    const std::vector<float> positions = scene.positions();
    REQUIRE(positions.size() == 3 * vertices.size());
    for (std::size_t i = 0; i < positions.size(); ++i) CHECK(positions[i] == vertices[i / 3][i % 3]);
    const std::vector<std::uint32_t> indices = scene.indices();
    REQUIRE(indices.size() == 3 * faces.size());
    CHECK(indices.size() == 3 * 162);
    for (std::size_t i = 0; i < indices.size(); ++i) CHECK(indices[i] + 1 == faces[i / 3][i % 3]);
    const json& bounds = scene.tree["accessors"][scene.primitive()["attributes"]["POSITION"].get<std::size_t>()];
    CHECK(bounds["min"] == json::parse("[0.0, 0.125, 0.5]"));
    CHECK(bounds["max"] == json::parse("[9.0, 9.125, 0.5]"));
    const auto normals = scene.values<float>(scene.primitive()["attributes"]["NORMAL"], 5126, "VEC3");
    REQUIRE(normals.size() == positions.size());
    for (std::size_t i = 0; i < normals.size(); i += 3) CHECK(std::abs(normals[i + 2]) == doctest::Approx(1));
    const auto colors = scene.values<std::uint16_t>(scene.primitive()["attributes"]["COLOR_0"], 5123, "VEC4");
    REQUIRE(colors.size() == 4 * vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const double srgb = 25 * vertices[v][0] / 255;
      const double linear = srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
      CHECK(std::abs(colors[4 * v] - 65535 * linear) <= 0.5);
      CHECK(colors[4 * v + 1] == 14146);  // of 128
      CHECK(colors[4 * v + 2] == 65535);
      CHECK(colors[4 * v + 3] == 65535);
    }
  }

  TEST_CASE("map coordinates are moved to the middle of their box, to less than a millimeter") {
    const Folder folder("s.txt", sheet(4500000.1));
    REQUIRE(folder.rbpa("surface s.txt --radius 1 -o m.glb -o m.obj -q").code == 0);
    const Scene scene(folder.content("m.glb"));
    const json& moved = scene.tree["nodes"][0]["translation"];
    const auto vertices = rows(folder.content("m.obj"), "v");
    const std::vector<float> positions = scene.positions();
    REQUIRE(positions.size() == 3 * vertices.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
      CHECK(std::abs(positions[i]) <= 5);
      CHECK(std::abs(positions[i] + moved[i % 3].get<double>() - vertices[i / 3][i % 3]) < 1e-6);
    }
  }

  TEST_CASE("sheets that touch have vertices of their own in a scene, and unused points none") {
    const Folder folder("s.txt", "0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n9 9 9\n");
    REQUIRE(folder.rbpa("surface s.txt --radius 0.75 --normals none -o m.glb -o m.npy -q").code == 0);
    const Scene scene(folder.content("m.glb"));
    const std::vector<std::uint32_t> indices = scene.indices();
    REQUIRE(!indices.empty());
    std::set<std::array<std::uint32_t, 2>> sides;
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const std::uint32_t from = indices[i], to = indices[i % 3 == 2 ? i - 2 : i + 1];
      CHECK(sides.insert({from, to}).second);
      CHECK(to < scene.positions().size() / 3);
    }
    CHECK_FALSE(scene.has("NORMAL"));
    CHECK_FALSE(scene.has("COLOR_0"));
    for (const float x : scene.positions()) CHECK(x < 9);
  }

  TEST_CASE("without a triangle the scene is empty; a coordinate beyond floats is refused without a file") {
    const Folder folder("far.txt", "0 0 0\n9 0 0\n0 9 0\n");
    CHECK(folder.rbpa("surface far.txt --radius 1 --normals none -o m.glb -q").code == 0);
    const Scene scene(folder.content("m.glb"));
    CHECK(scene.tree["scenes"] == json::parse("[{}]"));
    CHECK(scene.numbers.empty());
    folder.file("huge.txt", "0 0 0\n1e300 0 0\n0 1e300 0\n");
    refuses(folder, "surface huge.txt --radius 1e300 --normals none -o huge.glb -q", 3,
            "huge.glb: found the coordinate 1e+300, expected at most 3.4e38 in size, as GLB is in single precision "
            "(.ply keeps doubles)");
    CHECK_FALSE(folder.has("huge.glb"));
  }

  TEST_CASE("a grid of VTK has doubles, normals, colors, and the input index of each vertex") {
    const Folder folder("s.txt", sheet(0.1));
    REQUIRE(folder.rbpa("surface s.txt --radius 1 -o m.vtu -o m.npy -q").code == 0);
    REQUIRE(folder.rbpa("surface s.txt --radius 1 -o split.vtu -o m.obj --manifold -q").code == 0);
    const std::string vtu = folder.content("m.vtu"), npy = folder.content("m.npy");
    const auto corners = array_of<std::uint32_t>(vtu, "connectivity");
    REQUIRE(corners.size() == 3 * 162);
    CHECK(std::memcmp(corners.data(), npy.data() + npy.find('\n') + 1, 4 * corners.size()) == 0);
    CHECK(array_behind<double>(vtu, "<Points>").size() == 300);
    CHECK(array_of<std::uint8_t>(vtu, "types") == std::vector<std::uint8_t>(162, 5));
    CHECK(array_of<double>(vtu, "Normals").size() == 300);
    const auto colors = array_of<std::uint8_t>(vtu, "RGB");
    REQUIRE(colors.size() == 300);
    CHECK(colors[3 * 99] == 225);
    CHECK(array_of<std::uint32_t>(vtu, "point").empty());  // the vertices are the points
    const std::string split = folder.content("split.vtu");
    const auto vertices = rows(folder.content("m.obj"), "v");
    const auto positions = array_behind<double>(split, "<Points>");
    const auto points = array_of<std::uint32_t>(split, "point");
    REQUIRE(positions.size() == 3 * vertices.size());
    CHECK(points.size() == vertices.size());
    for (std::size_t i = 0; i < positions.size(); ++i) CHECK(positions[i] == vertices[i / 3][i % 3]);
  }
}
