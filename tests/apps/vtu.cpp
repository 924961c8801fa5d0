// VTU: the appended data are the mesh, to the last bit.
#include <doctest/doctest.h>

#include <cstring>
#include <string>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/number.h"
#include "support/generate.h"
#include "support/npy_file.h"
#include "support/program.h"

using namespace apps_test;

namespace {

std::string between(const std::string& text, const std::string& before, const std::string& behind) {
  const std::size_t at = text.find(before);
  REQUIRE(at != std::string::npos);
  const std::size_t first = at + before.size();
  return text.substr(first, text.find(behind, first) - first);
}

/// A file as a reader sees it, by the offsets in its XML.
struct Vtu {
  explicit Vtu(const std::string& file) {
    const std::string mark = "<AppendedData encoding=\"raw\">\n_";
    const std::size_t begin = file.find(mark) + mark.size();
    points = std::stoul(between(file, "NumberOfPoints=\"", "\""));
    cells = std::stoul(between(file, "NumberOfCells=\"", "\""));
    positions = array<double>(file, begin, "\"Float64\" NumberOfComponents=\"3\"");
    connectivity = array<std::uint32_t>(file, begin, "\"UInt32\" Name=\"connectivity\"");
    types = array<std::uint8_t>(file, begin, "\"UInt8\" Name=\"types\"");
    ends = array<std::uint64_t>(file, begin, "\"UInt64\" Name=\"offsets\"");
    CHECK(file.substr(end) == "\n</AppendedData>\n</VTKFile>\n");
  }

  template <typename T>
  std::vector<T> array(const std::string& file, std::size_t begin, const std::string& name) {
    const std::size_t offset =
        std::stoul(between(file, "<DataArray type=" + name + " format=\"appended\" offset=\"", "\""));
    std::uint64_t bytes = 0;
    REQUIRE(begin + offset + sizeof bytes <= file.size());
    std::memcpy(&bytes, file.data() + begin + offset, sizeof bytes);
    end = begin + offset + sizeof bytes + bytes;
    REQUIRE(end <= file.size());
    std::vector<T> values(bytes / sizeof(T));
    if (bytes > 0) std::memcpy(values.data(), file.data() + end - bytes, bytes);
    return values;
  }

  std::size_t points = 0, cells = 0, end = 0;
  std::vector<double> positions;
  std::vector<std::uint32_t> connectivity;
  std::vector<std::uint64_t> ends;
  std::vector<std::uint8_t> types;
};

}  // namespace

TEST_SUITE("vtu") {
  TEST_CASE("points, triangles, edges and isolated points are those of the other formats") {
    const Folder folder;
    std::string text;
    for (const rbpa::Point& p : rbpa_test::uniform(500, 3))
      text += rbpa::app::text_of(p.x) + " " + rbpa::app::text_of(p.y / 3) + "\n";
    folder.file("p.xy", text);
    const auto points = rbpa::app::read_points({.path = folder.path("p.xy")}).points;
    for (const std::string complex : {"solid", "full"}) {
      CAPTURE(complex);
      REQUIRE(folder.rbpa("mesh p.xy --alpha 0.2 --complex " + complex + " -o m.vtu -o m.npy -q").code == 0);
      const Vtu vtu(folder.content("m.vtu"));
      REQUIRE(vtu.positions.size() == 3 * points.size());
      CHECK(vtu.points == points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        CHECK(vtu.positions[3 * i] == points[i].x);
        CHECK(vtu.positions[3 * i + 1] == points[i].y);
        CHECK(vtu.positions[3 * i + 2] == 0);
      }
      std::vector<std::uint32_t> corners = npy_rows(folder.content("m.npy"));
      std::vector<std::uint8_t> types(corners.size() / 3, 5);
      if (complex == "full") {
        const auto edges = npy_rows(folder.content("m.edges.npy")), isolated = npy_rows(folder.content("m.points.npy"));
        REQUIRE(!edges.empty());
        REQUIRE(!isolated.empty());
        corners.insert(corners.end(), edges.begin(), edges.end());
        corners.insert(corners.end(), isolated.begin(), isolated.end());
        types.insert(types.end(), edges.size() / 2, 3);
        types.insert(types.end(), isolated.size(), 1);
      }
      CHECK(vtu.connectivity == corners);
      CHECK(vtu.types == types);
      CHECK(vtu.cells == types.size());
      std::vector<std::uint64_t> ends;
      for (const std::uint8_t type : types)
        ends.push_back((ends.empty() ? 0 : ends.back()) + (type == 5 ? 3 : type == 3 ? 2 : 1));
      CHECK(vtu.ends == ends);
    }
  }

  TEST_CASE("an empty complex, and one without the points that nothing uses") {
    const Folder folder("p.xy", "0 0\n1 0\n0 1\n9 9\n");
    REQUIRE(folder.rbpa("mesh p.xy --alpha 0.1 -o m.vtu -q").code == 0);
    const Vtu empty(folder.content("m.vtu"));
    CHECK(empty.points == 4);
    CHECK(empty.cells == 0);
    REQUIRE(folder.rbpa("mesh p.xy --alpha 1 --compact -o m.vtu -q").code == 0);
    const Vtu compact(folder.content("m.vtu"));
    CHECK(compact.positions == std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0});
    CHECK(compact.connectivity == std::vector<std::uint32_t>{0, 1, 2});
  }
}
