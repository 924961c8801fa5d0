#include "io/bytes/input_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <new>
#include <utility>

#include "io/bytes/available_memory.h"
#include "io/bytes/descriptor.h"
#include "io/bytes/gunzip.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "meshops/core/large_pages.h"

namespace rbpa::app {
namespace {

int open_for_reading(const std::string& name, const std::string& expected) {
  const int descriptor = open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) return descriptor;
  if (errno == EINTR) stop_if_interrupted();
  refuse_to_open(name, expected);
}

/// Bytes of memory that reading needs for each byte of text: four bytes ("0 0" and a line end) remain in memory, and
/// become a point of 16 bytes.
constexpr double bytes_for_each = 5;

/// Throws BadInput if `text` has a zero byte. Accepts UTF-16, as plain_text() refuses it with a better message.
void require_text(std::string_view text, const std::string& name) {
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos && !text.starts_with("\xFF\xFE") && !text.starts_with("\xFE\xFF"))
    bad_input(name, "a zero byte after " + counted(zero, "byte") + " of decompressed text",
              "text (--format names another format)");
}

}  // namespace

InputBytes::InputBytes(const std::string& name, const std::string& expected, const Decompression& how)
    : name_(name == "-" ? "standard input" : name) {
  const Descriptor file(name == "-" ? STDIN_FILENO : open_for_reading(name, expected));
  const struct stat status = status_of(file.number(), name_);
  if (S_ISDIR(status.st_mode)) bad_input(name_, "a folder", expected);
  if (S_ISREG(status.st_mode)) {
    read_file(file.number());
  } else {
    read_all(file.number());
  }
  if (is_gzip(bytes()) && how.is_wanted) decompress(how);
}

void InputBytes::decompress(const Decompression& how) {
  constexpr std::size_t at_once = std::size_t{1} << 20U;  // bytes of a step; a signal is noticed after it
  constexpr std::size_t always = 64 * at_once, greatest_ratio = 500;
  const double available = available_memory().value_or(std::numeric_limits<double>::infinity());
  const std::unique_ptr<char, Free> all = std::move(data_);
  std::string_view compressed(all.get(), size_);
  room_ = size_ = 0;
  const std::size_t compressed_size = compressed.size();
  bool is_checked = !how.is_of_text;
  Gunzip gunzip(name_);
  while (!compressed.empty() || !gunzip.is_between_members()) {
    stop_if_interrupted();
    if (gunzip.is_between_members() && !is_gzip(compressed))
      bad_input(name_, counted(compressed.size(), "byte") + " after the compressed data", "the end of the file");
    if (room_ - size_ < at_once) make_room(std::max(2 * room_, size_ + at_once));
    size_ += gunzip.inflate(compressed, data_.get() + size_, at_once);
    if (bytes_for_each * static_cast<double>(size_) > available)
      bad_input(name_, "more than " + bytes_text(available / bytes_for_each) + " of decompressed data",
                "at most a fifth of the " + bytes_text(available) +
                    " of available memory, as reading needs five times the size" + how.way_out);
    if (size_ > always && size_ / greatest_ratio > compressed_size - compressed.size())
      bad_input(name_,
                counted(compressed_size - compressed.size(), "byte") + " that decompress to more than " +
                    bytes_text(static_cast<double>(size_)),
                "at most " + std::to_string(greatest_ratio) +
                    " times their size (decompress the file by gunzip if its content is right)");
    if (!is_checked && size_ > at_once) require_text(bytes(), name_), is_checked = true;
  }
}

void InputBytes::make_room(std::size_t size) {
  void* larger = std::realloc(data_.get(), size);  // remaps large blocks instead of copying them
  if (larger == nullptr) throw std::bad_alloc();
  static_cast<void>(data_.release());
  data_.reset(static_cast<char*>(larger));
  room_ = size;
}

/// Reads at least one byte and returns true; returns false at the end.
bool InputBytes::read_some(int descriptor) {
  constexpr std::size_t at_once = std::size_t{4} << 20U;  // so that a signal is noticed between two reads
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

/// Reads a regular file. Throws BadInput if its length or the time of its last change differs afterwards: the bytes
/// would be partly old and partly new.
void InputBytes::read_file(int descriptor) {
  const struct stat before = status_of(descriptor, name_);
  // Begin at the current position: another program may have read the beginning of standard input.
  const off_t start = std::max<off_t>(lseek(descriptor, 0, SEEK_CUR), 0);
  const auto left = static_cast<std::size_t>(std::max<off_t>(before.st_size - start, 0));
  if (left == 0) return read_all(descriptor);  // empty, or generated as it is read, like the files of /proc
  make_room(left + 1);                         // one byte more shows whether the file has grown
  meshops::prefer_large_pages(data_.get(), room_);
  posix_fadvise(descriptor, 0, 0, POSIX_FADV_SEQUENTIAL);
  while (size_ < room_ && read_some(descriptor)) continue;
  const std::string expected = "a file that does not change while it is read (start again)";
  if (size_ < left) bad_input(name_, counted(size_, "byte") + " where there were " + std::to_string(left), expected);
  if (size_ > left) bad_input(name_, "more than the " + counted(left, "byte") + " there were", expected);
  if (!same_time(before.st_mtim, status_of(descriptor, name_).st_mtim))
    bad_input(name_, "a change while it was read", expected);
}

}  // namespace rbpa::app
