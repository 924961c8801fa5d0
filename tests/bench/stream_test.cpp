#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bench/lidar_points.h"
#include "bench/program_output.h"

using rbpa_bench::Ground;
using rbpa_bench::LidarPoints;
using rbpa_bench::Report;
using rbpa_bench::run;

namespace fs = std::filesystem;

namespace {

/// Temporary folder, removed at the end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "bench_stream_XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string path() const { return path_.string(); }
  bool is_empty() const { return fs::is_empty(path_); }

 private:
  fs::path path_;
};

std::vector<rbpa::Point> points_of(Ground ground, std::uint64_t count, std::size_t at_once) {
  LidarPoints points(ground, count, 3);
  std::vector<rbpa::Point> all, block;
  while (points.next(block, at_once)) {
    CHECK(block.size() <= at_once);
    all.insert(all.end(), block.begin(), block.end());
  }
  return all;
}

}  // namespace

TEST_CASE("lidar points are as many as were requested, whatever the blocks, and whole hundredths") {
  for (const Ground ground : {Ground::jittered, Ground::uniform}) {
    const std::vector<rbpa::Point> all = points_of(ground, 20000, 20000);
    CHECK(all.size() == 20000);
    CHECK(all == points_of(ground, 20000, 37));
    CHECK(std::all_of(all.begin(), all.end(), [](const rbpa::Point& p) {
      return std::round(p.x * 100) / 100 == p.x && std::round(p.y * 100) / 100 == p.y;
    }));
  }
  CHECK(points_of(Ground::jittered, 1, 5).size() == 1);
}

TEST_CASE("a run in tiles finds the result of the run in memory, reports that, and leaves no file") {
  for (const char* options : {"--target=geojson --ground=uniform --input=npy", "--target=npy --threads=1"}) {
    CAPTURE(options);
    const Folder folder;
    const std::string trace = folder.path() + ".csv";
    const Report all = run(RBPA_BENCH_STREAM, "--points=20K --memory=64M --files=3 --trace=" + trace +
                                                  " --scratch=" + folder.path() + " " + options);
    CHECK(all.code == 0);
    CHECK(all.text.find("\nIn memory there are as many triangles, and the area is the same.\n") != std::string::npos);
    for (const char* row : {"| 1 count | ", "| 4 write | ", "| reading the input twice | ",
                            "| together; with warm memory | ", "| 1e+12 | 1000 | "})
      CHECK(all.text.find(row) != std::string::npos);
    CHECK(all.text.find("| resident, at most / --memory ≤ 1 | 0.") != std::string::npos);
    CHECK(folder.is_empty());
    std::ifstream file(trace);
    std::string line;
    for (int i = 0; i < 3; ++i) std::getline(file, line);
    CHECK(line == "seconds,resident,scratch,pass,memory");
    fs::remove(trace);
  }
}

TEST_CASE("a benchmark of streams reports a failure, and leaves no file") {
  const Folder folder;
  const Report failed = run(RBPA_BENCH_STREAM, "--points=1K --program=/bin/false --scratch=" + folder.path());
  CHECK(failed.code == 1);
  CHECK(failed.text.find("bench_stream: /bin/false shape: ended with 1, expected 0\n") != std::string::npos);
  CHECK(folder.is_empty());
  const Report full = run(RBPA_BENCH_STREAM, "--points=1000G --scratch=" + folder.path());
  CHECK(full.code == 1);
  CHECK(full.text.find(" GB free, expected ") != std::string::npos);
  CHECK(folder.is_empty());
  for (const char* argument : {"--points=1T", "--points=0", "--points=", "--target=ply", "--alpha=0", "--quick"}) {
    CAPTURE(argument);
    const Report refused = run(RBPA_BENCH_STREAM, argument);
    CHECK(refused.code == 2);
    CHECK(refused.text.find(std::string("found '") + argument + "'\nusage: ") != std::string::npos);
  }
}
