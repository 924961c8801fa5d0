// What: what a single run in a fresh process costs, page faults included: what the user of a program pays.
// Why:  memory that a process has for the first time is given page by page, and cleared. Runs that are repeated in one
//       process do not pay that.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/contest.h"
#include "support/triangle.h"

namespace rbpa_bench {

/// The contestants: the meshes and arrays of one thread and two, and CGAL.
const std::vector<Contestant>& cold_contestants();

/// A temporary file of points, for run_cold().
class PointsFile {
 public:
  /// Throws std::runtime_error when it cannot be written.
  explicit PointsFile(const rbpa_test::Points& points);
  ~PointsFile();
  PointsFile(const PointsFile&) = delete;
  PointsFile& operator=(const PointsFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// One run, in a process of its own.
struct ColdRun {
  double seconds, processor_seconds;
  std::size_t triangles;
  double bytes;  ///< by how much resident memory rose at most; the points were there before
};

/// Starts `program` once more as `program --one=NUMBER FILE`, which is to run one(). Throws std::runtime_error when that
/// fails.
ColdRun run_cold(const std::string& program, std::size_t contestant, const std::string& points_file);

/// The child: reads the points, runs the contestant and reports on standard output. Returns: the code to end with.
int one(std::size_t contestant, const std::string& points_file);

}  // namespace rbpa_bench
