// Points without a return, whose coordinates are NaN, and normals without a direction: refused, left out, or not used.
#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "support/program.h"

using namespace apps_test;
using rbpa::app::BadInput;
using rbpa::app::CloudRequest;
using rbpa::app::Format;
using rbpa::app::SpacePoints;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

template <typename Number>
std::string bytes(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    const auto number = static_cast<Number>(value);
    text.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  return text;
}

std::string npy(std::size_t rows, std::size_t columns, const std::vector<double>& values) {
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(rows) + ", " +
                       std::to_string(columns) + "), }";
  header.resize(117, ' ');
  header += '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + std::string("\x76\x00", 2) + header + bytes<double>(values);
}

const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
    "property double z\nend_header\n";
const std::string pcd = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 2\nPOINTS 4\n";
const std::string text = "1 2 3\nnan nan nan\n4 5 6\n7 8 inf\n";
const std::vector<double> numbers = {1, 2, 3, no_number, no_number, no_number,
                                     4, 5, 6, 7,         8,         std::numeric_limits<double>::infinity()};

SpacePoints read(const std::string& content, Format format, const CloudRequest& request) {
  return rbpa::app::space_points_in(content, "p", format, request);
}

}  // namespace

TEST_SUITE("points with NaN") {
  TEST_CASE("points with NaN are refused in each format, and left out on request, with their indices") {
    struct Row {
      const char* name;
      Format format;
      std::string content, at;
      bool has_fields = true;
    };
    for (const Row& row : {
             Row{"ply", Format::ply, ply + text, "p:9"},
             {"pcd", Format::pcd, pcd + "DATA ascii\n" + text, "p:11"},
             {"pcd", Format::pcd, pcd + "DATA binary\n" + bytes<float>(numbers), "p: point 1"},
             {"off", Format::off, "OFF\n4 0 0\n" + text, "p:4", false},
             {"npy", Format::npy, npy(4, 3, numbers), "p: point 1", false},
         }) {
      CAPTURE(std::string(row.name));
      CHECK_THROWS_WITH_AS(
          read(row.content, row.format, {}),
          (row.at + ": found 'nan', expected a finite number (--skip-invalid leaves out such points)").c_str(),
          BadInput);
      const SpacePoints skipped = read(row.content, row.format, {.skip_invalid = true});
      CHECK(skipped.points == std::vector<rbpa::Point3>{{1, 2, 3}, {4, 5, 6}});
      CHECK(skipped.index == std::vector<std::uint32_t>{0, 2});
      CHECK(skipped.all_points == 4);
      CHECK(skipped.warnings ==
            std::vector<std::string>{
                "2 points are left out: the first is p: point 1: found 'nan', expected a finite number"});
      if (!row.has_fields) continue;
      const CloudRequest where{.where = rbpa::app::Condition("x < 5", *rbpa::app::fields_of(row.format))};
      CHECK(read(row.content, row.format, where).points == skipped.points);
    }
    const std::string none = "OFF\n1 0 0\nnan 0 0\n";
    CHECK_THROWS_WITH_AS(read(none, Format::off, {.skip_invalid = true}),
                         doctest::Contains("p: found 1 point and none that is valid, expected one (p: point 0: "),
                         BadInput);
    // In the plane, z need not be finite.
    const rbpa::app::PointSource plane{.format = Format::npy, .skip_invalid = true};
    CHECK(rbpa::app::points_in(npy(4, 3, numbers), "p", plane).points ==
          std::vector<rbpa::Point>{{1, 2}, {4, 5}, {7, 8}});
  }

  TEST_CASE("normals of length 0 or NaN are refused only where they are used") {
    const std::string lines = "0 0 0 0 0 1\n1 0 0 0 0 0\n0 1 0 0 0 1\n0 0 1 nan 0 1\n";
    std::vector<double> values = {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, no_number, 0, 1};
    struct Row {
      const char* name;
      Format format;
      std::string content;
    };
    for (const Row& row :
         {Row{"noff", Format::off, "NOFF\n4 0 0\n" + lines}, {"npy", Format::npy, npy(4, 6, values)}}) {
      CAPTURE(std::string(row.name));
      CHECK_THROWS_AS(read(row.content, row.format, {}), BadInput);
      CHECK(read(row.content, row.format, {.needs_normals = false}).points.size() == 4);
      CHECK(read(row.content, row.format, {.skip_invalid = true}).index == std::vector<std::uint32_t>{0, 2});
    }
    const Folder folder("n.xyz", "0 0 0 0 0 1\n1 0 0 0 0 0\n0 1 0 0 0 1\n1 1 0 0 0 1\n");
    const std::string run = "surface n.xyz --radius 2 -o o.off --normals ";
    CHECK(contains(folder.rbpa(run + "file", 3).err, "n.xyz:2: found a normal of length 0"));
    for (const std::string source : {"none", "estimate"}) CHECK(folder.rbpa(run + source).code == 0);
  }
}
