// What: file descriptors that close themselves, and waiting for them.
#pragma once

#include <sys/stat.h>
#include <unistd.h>

#include <string>

namespace rbpa::app {

/// Owns a file descriptor and closes it, unless it is standard input, output or error.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ > STDERR_FILENO) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }

 private:
  int number_;
};

/// Returns the status of an open file; `name` stands for it in messages. Throws Failure.
struct stat status_of(int descriptor, const std::string& name);

inline bool same_time(const timespec& a, const timespec& b) { return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec; }

/// Wait until `descriptor`, which may be non-blocking, can be read or written, or until a signal arrives.
void wait_to_read(int descriptor);
void wait_to_write(int descriptor);

/// Occupies those of standard input, output and error that the caller has closed by files that fail. Otherwise the next
/// opened file would get the number of, say, standard output, and text that is printed would be written into it.
/// Requires: called before any file is opened.
void occupy_standard_streams();

}  // namespace rbpa::app
