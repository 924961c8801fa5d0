// What: a file under construction, beside the one whose place it takes at the end.
// Law:  without take_place() nothing is left of it; what a process that was killed has left, the next one that writes
//       into the folder removes, and never what a living one is writing.
//
// Its writer holds an advisory lock (flock) on it as long as it lives, and the system lets go of the lock when the
// process ends in whatever way. So whoever gets the lock knows that the writer is dead. The number of the process in the
// name does not show that: numbers are used again, each container and each host counts its own, and another host may be
// writing into the folder over the network, where Linux passes the lock on to the server. Where there are no locks
// nothing is removed; where they do not reach other hosts, the worst is that a writer there finds its file gone at the
// end, and says so. (A file without a name, O_TMPFILE, would vanish by itself, but it cannot take the place of a file
// that exists, and many network disks know none.)
#pragma once

#include <string>

namespace rbpa::app {

class TemporaryFile {
 public:
  /// In the folder of `path`, under a name that begins with a dot. Throws std::system_error.
  explicit TemporaryFile(const std::string& path);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  int descriptor() const { return descriptor_; }

  /// It becomes the file at `path`, at once. Throws std::system_error. Call at most once.
  void take_place();

 private:
  bool create(const std::string& name);

  std::string path_;
  std::string name_ = {};  // empty when it is gone
  int descriptor_ = -1;
};

/// Removes what writers that are dead have left in the folder of `path`. Nothing that fails here matters.
void clear_abandoned(const std::string& path);

}  // namespace rbpa::app
