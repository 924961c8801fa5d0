// What: a file that is written in the folder of its target, and replaces the target at the end.
// Law:  without take_place() nothing is left of the file. The file of a killed process is removed by the next process
//       that writes into the folder; the file of a living process never is.
//
// The writer holds an advisory lock (flock) on the file, which the system releases when the process ends in any way. A
// process that gets the lock knows that the writer is dead. The process number in the name would not show that: numbers
// are reused, each container and each host counts its own, and another host may write into the folder over the network,
// where Linux passes the lock on to the server. Without locks nothing is removed. Where locks do not reach other hosts,
// a writer there may find its file gone at the end, and reports a failure. (A file without a name, O_TMPFILE, would
// vanish by itself, but it cannot replace an existing file, and many network file systems do not support it.)
#pragma once

#include <string>

namespace rbpa::app {

class TemporaryFile {
 public:
  /// Creates the file in the folder of `path`, the target, under a name that begins with a dot. Throws
  /// std::system_error.
  explicit TemporaryFile(const std::string& path);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  int descriptor() const { return descriptor_; }

  /// Renames the file to `path` of the constructor, atomically. Throws std::system_error. Call at most once.
  void take_place();

 private:
  bool create(const std::string& name);

  std::string path_;
  std::string name_ = {};  // empty when the file is renamed or removed
  int descriptor_ = -1;
};

/// Removes the temporary files of dead processes from the folder of `path`. Ignores every error.
void clear_abandoned(const std::string& path);

}  // namespace rbpa::app
