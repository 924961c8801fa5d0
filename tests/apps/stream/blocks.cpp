// Files read block by block: the same points as read at once, and the same refusals.
#include <doctest/doctest.h>

#include <cstring>

#include "io/cloud/las_fields.h"
#include "io/cloud/point_blocks.h"
#include "io/failure.h"
#include "support/gzip.h"
#include "support/las_file.h"
#include "support/npy_file.h"
#include "support/program.h"
#include "support/random.h"

using apps_test::contains;
using apps_test::Folder;
using rbpa::Point;
using namespace rbpa::app;

namespace {

std::vector<Point> by_blocks(const PointSource& source, PointFile* about = nullptr) {
  const auto blocks = open_point_blocks(source);
  std::vector<Point> points, block;
  while (blocks->next(block)) points.insert(points.end(), block.begin(), block.end());
  if (about != nullptr) *about = blocks->about();
  return points;
}

bool same_bits(const std::vector<Point>& a, const std::vector<Point>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0);
}

void check_same(const PointSource& source) {
  CAPTURE(source.path);
  const PointFile whole = read_points(source);
  PointFile about;
  CHECK(same_bits(by_blocks(source, &about), whole.points));
  CHECK(about.warnings == whole.warnings);
  CHECK(about.degrees == whole.degrees);
}

/// Returns the message for a refused file.
std::string refusal(const PointSource& source) {
  try {
    by_blocks(source);
    return "";
  } catch (const BadInput& error) {
    return error.what();
  }
}

std::string npy(const std::string& descr, bool columns_first, std::size_t rows, const std::string& data) {
  return apps_test::npy_file("{'descr': '" + descr + "', 'fortran_order': " + (columns_first ? "True" : "False") +
                                 ", 'shape': (" + std::to_string(rows) + ", 2), }",
                             data);
}

// Number of points: more than a block has, and, written as text, more than one piece of a file.
constexpr std::size_t many = 150'000;

std::string doubles(std::size_t count) {
  rbpa_test::Random random(1);
  std::vector<double> values(2 * count);
  for (double& value : values) value = double(random.below(1U << 20U)) / 7;
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)};
}

}  // namespace

TEST_CASE("raw numbers, arrays and LAS are the same by blocks and at once") {
  const Folder folder;
  const std::string numbers = doubles(many);
  check_same({.path = folder.file("p.f64xy", numbers), .format = Format::raw});
  check_same({.path = folder.file("a.npy", npy("<f8", false, many, numbers)), .format = Format::npy});
  check_same({.path = folder.file("b.npy", npy("<f8", true, many, numbers)), .format = Format::npy});
  check_same({.path = folder.file("c.npy", npy(">i4", false, 2 * many, numbers)), .format = Format::npy});
  apps_test::LasFile las{.minor = 4, .format = 6};
  rbpa_test::Random random(2);
  for (std::size_t i = 0; i < 70'000; ++i)
    las.points.push_back({.x = int(random.below(1000)),
                          .y = int(random.below(1000)),
                          .classification = unsigned(random.below(3)),
                          .withheld = i % 7 == 0});
  las.extended = {{"LASF_Projection", 2112, "PROJCS[\"x\",AUTHORITY[\"EPSG\",\"28992\"]]"}};
  const std::string path = folder.file("p.las", apps_test::bytes_of(las));
  check_same({.path = path, .format = Format::las});
  check_same({.path = path, .format = Format::las, .where = Condition("classification == 2", names_of_las_fields())});
  std::string table = "x,class,y\n";
  for (int i = 0; i < 90000; ++i)
    table += std::to_string(i) + ',' + std::to_string(i % 3) + ',' + std::to_string(-i) + '\n';
  const std::string csv = folder.file("p.csv", table);
  check_same({.path = csv, .format = Format::text, .where = Condition("class == 2", names_of_columns())});
  PointFile about;
  by_blocks({.path = path, .format = Format::las}, &about);
  REQUIRE(about.crs);
  CHECK(about.crs->text() == "EPSG:28992");
}

TEST_CASE("text is the same by pieces and at once, compressed or not") {
  const Folder folder;
  rbpa_test::Random random(3);
  std::string text = "\xEF\xBB\xBF# many\n\nid,lon,lat,name\n";
  for (std::size_t i = 0; i < many; ++i)
    text += std::to_string(i) + "," + std::to_string(double(random.below(360)) - 180.5) + "," +
            std::to_string(random.below(90)) + ",\"a, b\"\n";
  text += "5,1,2,no end of line";
  const PointSource source{.path = folder.file("p.csv", text)};
  PointFile about;
  CHECK(same_bits(by_blocks(source, &about), read_points(source).points));
  CHECK(about.degrees);
  REQUIRE(folder.run("/bin/gzip", "-k p.csv").code == 0);
  CHECK(same_bits(by_blocks({.path = folder.path("p.csv.gz")}), read_points(source).points));
  // Two members, one after another.
  const std::string compressed = folder.content("p.csv.gz");
  folder.file("q.xy", "1 2\n3 4\n");
  REQUIRE(folder.run("/bin/gzip", "q.xy").code == 0);
  const std::string twice = folder.content("q.xy.gz") + folder.content("q.xy.gz");
  CHECK(by_blocks({.path = folder.file("r.xy.gz", twice)}).size() == 4);

  std::string commas = "x;y\n";
  for (std::size_t i = 0; i < many; ++i) commas += "1234567;7654321\n";
  check_same({.path = folder.file("commas.csv", commas + "1,5;2,5\n")});
  check_same({.path = folder.file("skipped.csv", commas + "a;b\n3;4\n"), .skip_invalid = true});
  check_same({.path = folder.file("comments.xy", "# nothing\n\n")});
}

TEST_CASE("an error in a file is named by its line or point, as when it is read at once") {
  const Folder folder;
  std::string text;
  for (std::size_t i = 0; i < many; ++i) text += "1234.5 7654.25\n";
  const auto check = [&](const PointSource& source) {
    CAPTURE(source.path);
    std::string expected;
    try {
      read_points(source);
    } catch (const BadInput& error) {
      expected = error.what();
    }
    CHECK(refusal(source) == expected);
    CHECK_FALSE(expected.empty());
  };
  check({.path = folder.file("word.xy", text + "1 x\n")});
  check({.path = folder.file("columns.xy", text + "1 2 3\n")});
  check({.path = folder.file("comma.xy", text + "1,5 2\n")});
  check({.path = folder.file("empty.xy", "")});
  check({.path = folder.file("name.csv", "# x\n"), .columns = parse_columns("a,b")});
  check({.path = folder.path("none.xy")});
  std::string numbers = doubles(many);
  check({.path = folder.file("odd.f64xy", numbers + "x"), .format = Format::raw});
  check({.path = folder.file("short.npy", npy("<f8", false, many + 1, numbers)), .format = Format::npy});
  const double infinite = INFINITY;
  std::memcpy(numbers.data() + 16 * 100'000, &infinite, 8);
  check({.path = folder.file("inf.f64xy", numbers), .format = Format::raw});
  check({.path = folder.file("inf.npy", npy("<f8", false, many, numbers)), .format = Format::npy});
  check({.path = folder.file("no.las", std::string(300, 'x')), .format = Format::las});
  apps_test::LasFile las;
  las.points.resize(1000);
  std::string bytes = apps_test::bytes_of(las);
  check({.path = folder.file("cut.las", bytes.substr(0, bytes.size() - 5)), .format = Format::las});
  CHECK(refusal({.path = "/dev/null"}) ==
        "/dev/null: found a pipe or a device, expected a regular file, as it is read twice");
  CHECK(contains(refusal({.path = folder.path("")}), "found a folder"));
}

// The shadow memory of a sanitizer exceeds any limit.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE("an endless line, and points that begin after the file, take no memory") {
  const Folder folder;
  constexpr std::size_t mebibyte = std::size_t{1} << 20U;
  folder.file("p.xy.gz", apps_test::bomb("0 0\n1 0\n", std::string(1, '\0'), 256 * mebibyte));
  apps_test::LasFile las;
  las.points.resize(3);
  folder.file("p.las.gz", apps_test::compressed(apps_test::bytes_of(las).replace(96, 4, "\xFF\xFF\xFF\xFF")));
  const auto refused = [&](const std::string& name) {
    const auto outcome = folder.run(
        "/bin/sh", "-c 'ulimit -v 200000; " RBPA_PROGRAM " stream " + name + " --alpha 1 --memory 64M -o t.npy'", 3);
    return outcome.err;
  };
  const std::string said = refused("p.xy.gz");
  CHECK(said.starts_with("rbpa: p.xy.gz: found a line of more than "));
  CHECK(said.ends_with(" MB, expected at most a fifth of the available memory (a table has a line for each point)\n"));
  CHECK(contains(refused("p.las.gz"), "p.las.gz: found 0 whole records of "));
}
#endif
