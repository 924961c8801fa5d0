#include "io/bytes/input_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <utility>

#include "io/bytes/descriptor.h"
#include "io/bytes/gunzip.h"
#include "io/bytes/unpack_limit.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "meshops/core/large_pages.h"

namespace rbpa::app {
namespace {

int open_for_reading(const std::string& name, const std::string& expected) {
  const int descriptor = open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) return descriptor;
  if (errno == EINTR) stop_if_interrupted();
  const std::string reason = errno == ENOENT ? "no such file" : std::strerror(errno);
  bad_input(name, reason, expected);
}

bool same_time(const timespec& a, const timespec& b) { return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec; }

}  // namespace

void InputBytes::gunzip(const Claim& claim, const std::string& way_out) {
  const std::unique_ptr<char, Free> packed = std::move(data_);
  const std::string_view bytes(packed.get(), size_);
  room_ = size_ = 0;
  UnpackLimit limit(name_, claim, way_out);
  app::gunzip(
      bytes, name_,
      [this](std::size_t size) {
        if (room_ - size_ < size) make_room(std::max(2 * room_, size_ + size));
        return data_.get() + size_;
      },
      [&](std::size_t size) {
        size_ += size;
        limit.require(this->bytes());
      });
}

InputBytes::InputBytes(const std::string& name, const std::string& expected)
    : name_(name == "-" ? "standard input" : name) {
  const Descriptor file(name == "-" ? STDIN_FILENO : open_for_reading(name, expected));
  const struct stat status = status_of(file.number(), name_);
  if (S_ISDIR(status.st_mode)) bad_input(name_, "a folder", expected);
  if (S_ISREG(status.st_mode)) {
    read_file(file.number());
  } else {
    read_all(file.number());
  }
}

void InputBytes::make_room(std::size_t size) {
  void* larger = std::realloc(data_.get(), size);  // remaps large blocks instead of copying them
  if (larger == nullptr) throw std::bad_alloc();
  static_cast<void>(data_.release());
  data_.reset(static_cast<char*>(larger));
  room_ = size;
}

/// At least a byte, unless the end has come: then false.
bool InputBytes::read_some(int descriptor) {
  constexpr std::size_t at_once = std::size_t{4} << 20U;  // so that a signal is noticed between two of them
  while (true) {
    stop_if_interrupted();
    const ssize_t count = read(descriptor, data_.get() + size_, std::min(room_ - size_, at_once));
    if (count >= 0) {
      size_ += static_cast<std::size_t>(count);
      return count > 0;
    }
    if (errno == EAGAIN) {
      wait_to_read(descriptor);
    } else if (errno != EINTR) {
      throw Failure(name_ + ": cannot read: " + std::strerror(errno));
    }
  }
}

void InputBytes::read_all(int descriptor) {
  do {
    if (size_ == room_) make_room(std::max(std::size_t{1} << 20U, room_ * 2));
  } while (read_some(descriptor));
}

/// A regular file says how long it is. That must be so at the end as well: what somebody else writes meanwhile is half
/// of the old and half of the new.
void InputBytes::read_file(int descriptor) {
  const struct stat before = status_of(descriptor, name_);
  // Standard input may have been read in part.
  const off_t start = std::max<off_t>(lseek(descriptor, 0, SEEK_CUR), 0);
  const auto left = static_cast<std::size_t>(std::max<off_t>(before.st_size - start, 0));
  if (left == 0) return read_all(descriptor);  // empty, or made as it is read, as the files of /proc are
  make_room(left + 1);                         // a byte more shows that it has grown
  meshops::prefer_large_pages(data_.get(), room_);
  posix_fadvise(descriptor, 0, 0, POSIX_FADV_SEQUENTIAL);
  while (size_ < room_ && read_some(descriptor)) continue;
  const std::string expected = "a file that stays as it is while it is read";
  if (size_ < left) bad_input(name_, counted(size_, "byte") + " where there were " + std::to_string(left), expected);
  if (size_ > left) bad_input(name_, "more than the " + counted(left, "byte") + " there were", expected);
  if (!same_time(before.st_mtim, status_of(descriptor, name_).st_mtim))
    bad_input(name_, "a change while it was read", expected);
}

}  // namespace rbpa::app
