#include "io/bytes/descriptor.h"

#include <fcntl.h>
#include <poll.h>

#include <cerrno>
#include <cstring>
#include <initializer_list>

#include "io/failure.h"

namespace rbpa::app {
namespace {

void wait_for(int descriptor, short event) {
  pollfd one{descriptor, event, 0};
  poll(&one, 1, -1);
}

}  // namespace

struct stat status_of(int descriptor, const std::string& name) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) throw Failure(name + ": cannot read: " + std::strerror(errno));
  return status;
}

void wait_to_read(int descriptor) { wait_for(descriptor, POLLIN); }
void wait_to_write(int descriptor) { wait_for(descriptor, POLLOUT); }

void occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1)  // open() takes the lowest free number, which is this one
      static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

}  // namespace rbpa::app
