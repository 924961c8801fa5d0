// Scans of KITTI (.bin): rows of x, y, z and reflectance in float32, without a header.
#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "support/gzip.h"
#include "support/program.h"

using namespace apps_test;
using namespace rbpa::app;
using rbpa::Point;
using rbpa::Point3;

namespace {

std::string scan(const std::vector<float>& numbers) {
  std::string bytes(sizeof(float) * numbers.size(), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

const std::string four = scan({0, 0, 0, 0.25F, 1.5F, -2, 7, 0.5F, 1e-40F, 3, -1, 0, 4, 0.1F, 2, 1});
const std::vector<Point3> all = {
    {0, 0, 0}, {1.5, -2, 7}, {static_cast<double>(1e-40F), 3, -1}, {4, static_cast<double>(0.1F), 2}};

SpacePoints read(const std::string& bytes, const std::string& where = "") {
  CloudRequest request;
  if (!where.empty()) request.where = Condition(where, *fields_of(Format::kitti));
  return space_points_in(bytes, "p", Format::kitti, request);
}

}  // namespace

TEST_SUITE("kitti") {
  TEST_CASE("each float is read as the same double") {
    CHECK(read(four).points == all);
    CHECK(read(four).normals.empty());
    CHECK(read(four).colors.empty());
    CHECK(read(four).warnings.empty());
    std::string many;
    for (int i = 0; i < 5000; ++i) many += four;  // more than a block
    CHECK(read(many).points.size() == 20000);
    CHECK(read(many).points.back() == all.back());
  }

  TEST_CASE("reflectance and coordinates select points") {
    CHECK(read(four, "reflectance > 0.3").points == std::vector<Point3>{all[1], all[3]});
    CHECK(read(four, "Reflectance == 0.25 or z < 0").points == std::vector<Point3>{all[0], all[2]});
    CHECK(read(four, "reflectance > 0.3").index == std::vector<std::uint32_t>{1, 3});
    CHECK_THROWS_AS(read(four, "intensity > 1"), WrongUsage);
    const float none = std::numeric_limits<float>::quiet_NaN();
    const std::string hole = four + scan({none, none, none, -1});
    CHECK(read(hole, "reflectance >= 0").points == all);
    CHECK_THROWS_WITH_AS(read(hole),
                         "p: point 4: found 'nan', expected a finite number (--skip-invalid leaves out such points)",
                         BadInput);
  }

  TEST_CASE("the plane has x and y, and heights if they are requested") {
    PointSource source{.path = "", .format = Format::kitti};
    const std::vector<Point> flat = {
        {0, 0}, {1.5, -2}, {static_cast<double>(1e-40F), 3}, {4, static_cast<double>(0.1F)}};
    CHECK(points_in(four, "p", source).points == flat);
    CHECK(points_in(four, "p", source).z.empty());
    source.heights = true;
    CHECK(points_in(four, "p", source).z == std::vector<double>{0, 7, -1, 2});
  }

  TEST_CASE("a file that is cut off is refused") {
    for (std::size_t size = 1; size < four.size(); ++size) {
      if (size % 16 == 0) continue;
      CHECK_THROWS_WITH_AS(
          read(four.substr(0, size)),
          ("p: found " + counted(size, "byte") + ", expected a multiple of 16 (x, y, z and reflectance in float32)")
              .c_str(),
          BadInput);
    }
    CHECK(read(four.substr(0, 32)).points.size() == 2);
  }

  TEST_CASE("a scan is decompressed if its name ends in .gz, whatever its first bytes are") {
    const Folder folder({{"p.bin", four}, {"p.bin.gz", compressed(four)}});
    CHECK(read_space_points(folder.path("p.bin.gz"), Format::kitti).points == all);
    const std::string odd = std::string("\x1F\x8B\x08\x00", 4) + four.substr(4);
    CHECK(read_space_points(folder.file("odd.bin", odd), Format::kitti).points.size() == 4);
    CHECK(contains(folder.rbpa("solid p.bin --alpha inf --json -q").out, "\"points\": 4,"));
    CHECK(folder.rbpa("solid p.bin.gz --where \"reflectance < 2\" --alpha inf --json -q").code == 0);
    CHECK(folder.rbpa("shape p.bin --alpha inf -o s.wkt -q").code == 0);
  }
}
