// What: open files of the system.
#pragma once

#include <sys/stat.h>
#include <unistd.h>

#include <string>

namespace rbpa::app {

/// Closes it at the end, unless it is one that every program is given.
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

/// Of the open file that messages call `name`. Throws Failure.
struct stat status_of(int descriptor, const std::string& name);

inline bool same_time(const timespec& a, const timespec& b) { return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec; }

/// Returns when `descriptor` can be read or written, or a signal has come: it may have been set not to wait by itself.
void wait_to_read(int descriptor);
void wait_to_write(int descriptor);

/// Standard input, output and error that the caller has closed are taken up by files that fail: else the next file that
/// is opened would get the number of, say, standard output, and what is printed would get into it. Call first.
void occupy_standard_streams();

}  // namespace rbpa::app
