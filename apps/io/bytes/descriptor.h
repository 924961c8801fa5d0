// What: owns file descriptors, and waits until they can be read or written.
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

/// Returns the status of an open file. Messages call the file `name`. Throws Failure.
struct stat status_of(int descriptor, const std::string& name);

inline bool same_time(const timespec& a, const timespec& b) { return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec; }

/// Wait until `descriptor`, which may be non-blocking, can be read or can be written, or until a signal arrives.
void wait_to_read(int descriptor);
void wait_to_write(int descriptor);

/// Opens /dev/null for each of standard input, output and error that the calling program has closed, such that reading
/// or writing the stream fails. Otherwise the next opened file could get the number of standard output, and printed
/// text would be written into that file. Requires: no file was opened before.
void occupy_standard_streams();

}  // namespace rbpa::app
