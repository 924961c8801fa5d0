// COPC: a box and a resolution give the points that filtering gives, and read only their nodes; damaged hierarchies are
// refused. The same options on other formats.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "support/data_folder.h"
#include "support/las_file.h"
#include "support/laz_file.h"
#include "support/program.h"

using namespace apps_test;
using namespace rbpa::app;

namespace {

using Key = std::array<std::int32_t, 4>;  // level, x, y, z

template <typename T>
T at(const std::string& bytes, std::size_t place) {
  T value;
  std::memcpy(&value, &bytes.at(place + sizeof value - 1) - (sizeof value - 1), sizeof value);
  return value;
}

struct Entry {
  Key key;
  std::uint64_t begin;
  std::int32_t size, points;

  std::string bytes() const {
    std::string text;
    for (const std::int32_t part : key) text += little(static_cast<std::uint32_t>(part), 4);
    return text + little(begin, 8) + little(static_cast<std::uint32_t>(size), 4) +
           little(static_cast<std::uint32_t>(points), 4);
  }
};

/// A COPC file: points with coordinates from 0 to 800, scaled by 0.01, in three levels; the spacing of the root is 1.
struct Copc {
  std::string bytes;
  std::size_t info = 0;            // place of the data of the record "copc"
  std::size_t root = 0, page = 0;  // places of the root page, of 96 bytes and more, and of a page below
  std::vector<Entry> nodes = {};   // with points
};

Copc copc_file(std::size_t count) {
  std::mt19937 random(7);
  std::map<Key, std::vector<LasPoint>> nodes;
  for (std::size_t i = 0; i < count; ++i) {
    LasPoint p{.x = static_cast<std::int32_t>(random() % 80001),
               .y = static_cast<std::int32_t>(random() % 80001),
               .z = static_cast<std::int32_t>(random() % 80001),
               .return_number = 1 + static_cast<unsigned>(random() % 3),
               .number_of_returns = 3,
               .classification = static_cast<unsigned>(random() % 5),
               .time = static_cast<double>(i)};
    const auto level = static_cast<std::int32_t>(random() % 3);
    const auto part = [&](std::int32_t of) { return std::min(of / (80000 >> level), (1 << level) - 1); };
    nodes[{level, part(p.x), part(p.y), part(p.z)}].push_back(p);
  }
  LasFile las{.minor = 4, .format = 6, .records = {{"copc", 1, std::string(160, '\0')}}};
  LazOptions options{.compressor = 3, .items = {{10, 30, 3}}, .chunks = {}, .varies = true};
  for (const auto& [key, points] : nodes) {
    las.points.insert(las.points.end(), points.begin(), points.end());
    options.chunks.push_back(points.size());
  }
  Copc file{.bytes = laz_of(bytes_of(las), options)};
  file.info = file.bytes.find("copc") - 2 + 54;
  std::uint64_t place = at<std::uint32_t>(file.bytes, 96) + 8;
  std::string root, below;
  const Key parent = {1, 1, 0, 1};
  for (const auto& [key, points] : nodes) {
    std::uint64_t size = 30 + 4 + 9 * 4;  // the first record, the number of points, the sizes of layers
    for (std::size_t layer = 0; layer < 9; ++layer) size += at<std::uint32_t>(file.bytes, place + 34 + 4 * layer);
    file.nodes.push_back({key, place, static_cast<std::int32_t>(size), static_cast<std::int32_t>(points.size())});
    const bool is_below =
        key[0] == 2 && key[1] >> 1 == parent[1] && key[2] >> 1 == parent[2] && key[3] >> 1 == parent[3];
    (is_below || key == parent ? below : root) += file.nodes.back().bytes();
    place += size;
  }
  root += Entry{{2, 3, 3, 3}, 0, 0, 0}.bytes();  // a node without points
  file.page = file.bytes.size();
  root += Entry{parent, file.page, static_cast<std::int32_t>(below.size()), -1}.bytes();
  file.root = file.page + below.size();
  file.bytes += below + root;
  const std::string record = little(400.) + little(400.) + little(400.) + little(400.) + little(1.) +
                             little(file.root, 8) + little(root.size(), 8);
  file.bytes.replace(file.info, record.size(), record);
  return file;
}

struct Read {
  std::vector<std::array<double, 3>> points;
  std::vector<std::uint32_t> index;
  bool operator==(const Read&) const = default;
};

Read read(const std::string& path, const PointWindow& window, bool in_space) {
  Read result;
  if (in_space) {
    const SpacePoints file = read_space_points(path, Format::laz, {.window = window});
    for (const auto& p : file.points) result.points.push_back({p.x, p.y, p.z});
    result.index = file.index;
  } else {
    const PointFile file = read_points({.path = path, .format = Format::laz, .heights = true, .window = window});
    for (std::size_t i = 0; i < file.points.size(); ++i)
      result.points.push_back({file.points[i].x, file.points[i].y, file.z[i]});
    result.index = file.index;
  }
  if (result.index.empty())
    for (std::uint32_t i = 0; i < result.points.size(); ++i) result.index.push_back(i);
  return result;
}

Read filtered(const Read& all, const PointBox& box) {
  Read result;
  for (std::size_t i = 0; i < all.points.size(); ++i) {
    bool inside = true;
    for (std::size_t k = 0; k < (std::isfinite(box.least[2]) ? 3 : 2); ++k)
      inside = inside && box.least[k] <= all.points[i][k] && all.points[i][k] <= box.greatest[k];
    if (!inside) continue;
    result.points.push_back(all.points[i]);
    result.index.push_back(all.index[i]);
  }
  return result;
}

/// The bytes that this process has read.
std::uint64_t bytes_read() {
  std::ifstream file("/proc/self/io");
  std::string label;
  std::uint64_t count = 0;
  file >> label >> count;
  return label == "rchar:" ? count : 0;
}

std::string refusal(const Folder& folder, const std::string& bytes, const PointWindow& window) {
  try {
    read(folder.file("d.laz", bytes), window, true);
    return "none";
  } catch (const BadInput& error) {
    return error.what();
  }
}

const std::string without = " (without --bounds and --resolution the hierarchy is not read)";

}  // namespace

TEST_SUITE("COPC") {
  TEST_CASE("a box gives the points of a filter, in their order and with their numbers, in the plane and in space") {
    const Folder folder;
    const std::string path = folder.file("p.laz", copc_file(20'000).bytes);
    const Read all = read(path, {}, true);
    REQUIRE(all.points.size() == 20'000);
    std::mt19937 random(1);
    const auto side = [&] { return static_cast<double>(random() % 1000) - 100; };
    for (int i = 0; i < 60; ++i) {
      std::vector<double> numbers(i % 2 == 0 ? 4 : 6);
      for (std::size_t k = 0; k < numbers.size(); ++k)
        numbers[k] = i % 5 == 0 ? 100. * static_cast<double>(random() % 9) : side();
      for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>(0, 2), {1, 3}, {4, 5}})
        if (b < numbers.size() && numbers[a] > numbers[b]) std::swap(numbers[a], numbers[b]);
      const PointBox box = box_of("--bounds", numbers);
      for (const bool in_space : {false, true}) CHECK(read(path, {.bounds = box}, in_space) == filtered(all, box));
    }
  }

  TEST_CASE("only the nodes that meet the box are read, and of the hierarchy only their pages") {
    const Folder folder;
    const Copc copc = copc_file(200'000);
    const std::string path = folder.file("p.laz", copc.bytes);
    for (const PointBox& box : {PointBox{{10, 10, 10}, {90, 90, 90}}, PointBox{{610, 10, 410}, {790, 190, 590}}}) {
      std::uint64_t wanted = 0, all = 0;
      for (const Entry& node : copc.nodes) {
        const double width = 800. / (1 << node.key[0]);
        bool meets = true;
        for (std::size_t k = 0; k < 3; ++k)
          meets = meets && node.key[k + 1] * width <= box.greatest[k] && (node.key[k + 1] + 1) * width >= box.least[k];
        (meets ? wanted : all) += static_cast<std::uint64_t>(node.size);
      }
      const std::uint64_t before = bytes_read();
      const Read some = read(path, {.bounds = box}, true);
      const std::uint64_t after = bytes_read();
      CHECK(some.points.size() > 0);
      REQUIRE(all > wanted);
      constexpr std::uint64_t header = 65536, slack = 8192;  // table and pages
      if (after > 0) CHECK(after - before < wanted + header + slack);
      if (after > 0) CHECK(after - before >= wanted);
    }
  }

  TEST_CASE("a resolution reads the levels down to the first that is as fine") {
    const Folder folder;
    const Copc copc = copc_file(5'000);
    const std::string path = folder.file("p.laz", copc.bytes);
    for (const auto& [resolution, levels] :
         {std::pair(5., 1), {1., 1}, {0.99, 2}, {0.5, 2}, {0.49, 3}, {0.25, 3}, {1e-300, 3}}) {
      const auto& shown_resolution = resolution;
      CAPTURE(shown_resolution);
      std::size_t points = 0;
      for (const Entry& node : copc.nodes)
        if (node.key[0] < levels) points += static_cast<std::size_t>(node.points);
      CHECK(read(path, {.resolution = resolution}, true).points.size() == points);
    }
  }

  TEST_CASE("further COPC, of another program, gives the same by any box") {
    if (!rbpa_test::has_further_data()) return;
    const std::string path = (rbpa_test::further_data() / "laz" / "lone-star.copc.laz").string();
    if (!std::filesystem::exists(path)) return;
    const Read all = read(path, {}, true);
    REQUIRE(all.points.size() == 518'862);
    for (const PointBox& box :
         {PointBox{{515385, 4918341, -INFINITY}, {515390, 4918345, INFINITY}},
          PointBox{{515390, 4918350, 2330}, {515400, 4918360, 2334}}, PointBox{{0, 0, -INFINITY}, {1, 1, INFINITY}}})
      CHECK(read(path, {.bounds = box}, true) == filtered(all, box));
    CHECK(read(path, {.resolution = 0.32}, true).points.size() == 58'393);
    CHECK(read(path, {.resolution = 0.3}, true).points.size() == 58'393 + 105'600);
  }

  TEST_CASE("damaged hierarchies are refused in one sentence with the byte, whatever they say") {
    const Folder folder;
    const Copc copc = copc_file(3'000);
    const PointWindow window{.resolution = 0.1};
    const auto with = [&](std::size_t place, const std::string& bytes) {
      std::string changed = copc.bytes;
      return refusal(folder, changed.replace(place, bytes.size(), bytes), window);
    };
    const std::string path = folder.path("d.laz"), entry = path + ": byte " + std::to_string(copc.root) + ": found ";
    REQUIRE(refusal(folder, copc.bytes, window) == "none");
    const std::size_t last = copc.bytes.size() - 32, end = copc.bytes.size();
    const auto node = at<std::uint64_t>(copc.bytes, copc.root + 16);
    // A node that is no chunk, a page that is itself, a page beyond the end, a key elsewhere, negative numbers.
    CHECK(with(copc.root + 16, little(node + 1, 8)).starts_with(entry + "a node of "));
    CHECK(contains(with(copc.root + 32 + 16, copc.bytes.substr(copc.root + 16, 16)), "once" + without));
    CHECK(with(last + 16, little(copc.root, 8)) ==
          path + ": byte " + std::to_string(last) + ": found a page of the hierarchy of " +
              std::to_string(at<std::uint32_t>(copc.bytes, last + 24)) + " bytes from byte " +
              std::to_string(copc.root) + " on, expected a page that is not in another" + without);
    CHECK(contains(with(last + 16, little(end, 8)), "expected one of entries of 32 bytes that ends within the file"));
    CHECK(contains(with(last + 16, little(~std::uint64_t{0}, 8)), "ends within the file"));
    CHECK(contains(with(last + 24, little(33, 4)), "entries of 32 bytes"));
    CHECK(contains(with(copc.info + 40, little(end - 31, 8)), "ends within the file"));
    CHECK(contains(with(copc.info + 48, little(0, 8)), "ends within the file"));
    CHECK(with(copc.root, little(31, 4)).starts_with(entry + "a node 31-"));
    CHECK(contains(with(copc.root + 4, little(7, 4)), "expected one in the cube 0-0-0-0 of its page"));
    CHECK(contains(with(copc.page + 4, little(0, 4)), "expected one in the cube 1-1-0-1 of its page"));
    CHECK(contains(with(copc.root + 28, little(0xFFFFFFFE, 4)), "or -1 points for a page"));
    CHECK(contains(with(copc.info + 24, little(0.)), "finite numbers above 0"));
    CHECK(contains(with(copc.info + 32, little(std::nan(""))), "finite numbers above 0"));
    CHECK(refusal(folder, copc.bytes, {}) == "none");
  }

  TEST_CASE("bytes of the hierarchy that change at random give a refusal or points, and end") {
    const Folder folder;
    const Copc copc = copc_file(2'000);
    std::mt19937 random(5);
    for (int i = 0; i < 400; ++i) {
      std::string damaged = copc.bytes;
      for (unsigned k = 0; k <= random() % 4; ++k)
        damaged[copc.page + random() % (damaged.size() - copc.page)] =
            static_cast<char>(random() % 5 == 0 ? random() : random() % 3);
      const std::string why = refusal(folder, damaged, {.bounds = PointBox{{0, 0, 0}, {500, 500, 500}}});
      CHECK((why == "none" || why.starts_with(folder.path("d.laz") + ": byte ")));
    }
  }

  TEST_CASE("a box filters every other format, and a resolution takes the first point of a cell") {
    const Folder folder;
    folder.file("p.xyz", "0 0 0\n1 1 5\n1.2 1.1 9\n2 2 7\n-1 3 5\n");
    folder.file("p.geojson", R"({"type":"MultiPoint","coordinates":[[0,0],[1,1],[1.2,1.1],[2,2],[-1,3]]})");
    const auto info = [&](const std::string& arguments) {
      const Outcome outcome = folder.rbpa("info " + arguments + " --json", 0);
      return outcome.err + outcome.out.substr(0, outcome.out.find("distinct"));
    };
    for (const std::string name : {"p.xyz", "p.geojson", "- <p.xyz"}) {
      CAPTURE(name);
      CHECK(contains(info(name + " --bounds 1,1,2,2"), "\"points\": 3,"));
      CHECK(contains(info(name + " --bounds=-1,0,0,3"), "\"points\": 2,"));
      CHECK(contains(info(name + " --resolution 1"), "\"points\": 4,"));
      CHECK(contains(info(name + " --bounds 1,1,2,2 --resolution 9"), "\"points\": 1,"));
    }
    CHECK(contains(info("p.xyz --bounds 0,0,3,3,4,6"), "\"points\": 1,"));
    CHECK(info("p.xyz --bounds 1,1,2,2").starts_with("rbpa: p.xyz: --bounds selects 3 of 5 points\n"));
    folder.file("flat.xy", "0 0\n1 1\n");
    CHECK(folder.rbpa("info flat.xy --bounds 0,0,3,3,4,6").err ==
          "rbpa: flat.xy: found points without z, expected points with z, as --bounds of six numbers requires (four "
          "bound x and y)\n");
    CHECK(folder.rbpa("mesh p.xyz --bounds 1,1,2,2 --alpha inf -o m.npy").code == 0);
    CHECK(folder.content("m.npy").ends_with(little(1, 4) + little(2, 4) + little(3, 4)));  // numbers of input points
    CHECK(contains(folder.rbpa("solid p.xyz --bounds 0,0,2,2,0,6 --alpha inf -o s.vtu --json").out, "\"points\": 2"));
    CHECK(folder.rbpa("stream flat.xy --bounds 0,0,1,1 --alpha 1 -o o.wkt").code == 0);
    CHECK(folder.rbpa("stream flat.xy --resolution 1 --alpha 1 -o o.wkt").err ==
          "rbpa: --resolution cannot be combined with rbpa stream, whose memory would grow with the number of cells\n");
  }

  TEST_CASE("boxes and resolutions that are none are refused before anything is read") {
    const Folder folder;
    const std::string expected = ", expected x0,y0,x1,y1 or x0,y0,x1,y1,z0,z1 with x0 <= x1, y0 <= y1 and z0 <= z1\n";
    const auto err = [&](const std::string& arguments) {
      const Outcome outcome = folder.rbpa("info none.xy " + arguments, 2);
      return outcome.err;
    };
    CHECK(err("--bounds 1,2,3") == "rbpa: --bounds: found 3 numbers" + expected);
    CHECK(err("--bounds 1,2,3,1") == "rbpa: --bounds: found 2 above 1" + expected);
    CHECK(err("--bounds 1,2,3,4,5,4") == "rbpa: --bounds: found 5 above 4" + expected);
    CHECK(err("--bounds 1,2,3,a").starts_with("rbpa: --bounds: found 'a', expected numbers"));
    CHECK(err("--bounds 1,2,3,inf").starts_with("rbpa: --bounds: found 'inf'"));
    for (const std::string wrong : {"0", "-1", "nan", "x"})
      CHECK(err("--resolution=" + wrong) == "rbpa: --resolution: found '" + wrong + "', expected a length above 0\n");
  }
}
