// What: measures a single run in a fresh process, including page faults: the cost for the user of a program.
// Why:  memory that a process gets for the first time is provided page by page, and cleared. Repeated runs in one
//       process do not pay that.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/contest.h"
#include "support/triangle.h"

namespace rbpa_bench {

/// Returns the contestants: the meshes and arrays of one thread and two, and CGAL.
const std::vector<Contestant>& cold_contestants();

/// Temporary file of points, for run_cold().
class PointsFile {
 public:
  /// Writes the file. Throws std::runtime_error when it cannot be written.
  explicit PointsFile(const rbpa_test::Points& points);
  ~PointsFile();
  PointsFile(const PointsFile&) = delete;
  PointsFile& operator=(const PointsFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Result of one run in a process of its own.
struct ColdRun {
  double seconds, processor_seconds;
  std::size_t triangles;
  double bytes;  ///< peak rise of resident memory over the state with the points loaded
};

/// Starts `program` again as `program --one=NUMBER FILE`, which must call one(). Throws std::runtime_error when that
/// fails.
ColdRun run_cold(const std::string& program, std::size_t contestant, const std::string& points_file);

/// Runs in the child process: reads the points, runs the contestant and reports on standard output. Returns: the exit
/// code.
int one(std::size_t contestant, const std::string& points_file);

}  // namespace rbpa_bench
