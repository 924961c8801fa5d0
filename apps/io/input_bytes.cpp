#include "io/input_bytes.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>

#include "io/failure.h"
#include "io/interrupt.h"

namespace rbpa::app {
namespace {

struct Descriptor {
  int number;
  bool owned;
  ~Descriptor() {
    if (owned) close(number);
  }
};

int open_for_reading(const std::string& name, const std::string& expected) {
  const int descriptor = open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) return descriptor;
  if (errno == EINTR) stop_if_interrupted();
  const std::string reason = errno == ENOENT ? "no such file" : std::strerror(errno);
  bad_input(name, reason, expected);
}

}  // namespace

InputBytes::InputBytes(const std::string& name, const std::string& expected)
    : name_(name == "-" ? "standard input" : name) {
  const bool is_path = name != "-";
  const Descriptor file{is_path ? open_for_reading(name, expected) : STDIN_FILENO, is_path};
  struct stat status {};
  if (fstat(file.number, &status) != 0) throw Failure(name_ + ": cannot read: " + std::strerror(errno));
  if (S_ISDIR(status.st_mode)) bad_input(name_, "a folder", expected);
  if (is_path && S_ISREG(status.st_mode) && status.st_size > 0) {
    const auto size = static_cast<std::size_t>(status.st_size);
    void* memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.number, 0);
    if (memory != MAP_FAILED) {
      madvise(memory, size, MADV_SEQUENTIAL);
      data_ = static_cast<char*>(memory);
      size_ = size;
      mapped_ = true;
      return;
    }
  }
  try {
    read_to_end(file.number);
  } catch (...) {
    std::free(data_);
    throw;
  }
}

InputBytes::~InputBytes() {
  if (mapped_) {
    munmap(data_, size_);
  } else {
    std::free(data_);
  }
}

void InputBytes::read_to_end(int descriptor) {
  std::size_t room = 0;
  while (true) {
    stop_if_interrupted();
    if (size_ == room) {
      room = room == 0 ? std::size_t{1} << 20U : room * 2;
      void* larger = std::realloc(data_, room);  // remaps large blocks instead of copying them
      if (larger == nullptr) throw std::bad_alloc();
      data_ = static_cast<char*>(larger);
    }
    const ssize_t count = read(descriptor, data_ + size_, room - size_);
    if (count == 0) return;
    if (count > 0) {
      size_ += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      throw Failure(name_ + ": cannot read: " + std::strerror(errno));
    }
  }
}

}  // namespace rbpa::app
