#include "io/bytes/input_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
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
  const std::string reason = errno == ENOENT ? "no such file" : std::strerror(errno);
  bad_input(name, reason, expected);
}

/// The greatest length of a header, and of bytes after the data, which readers of uncompressed files ignore.
constexpr std::size_t slack = std::size_t{1} << 20U;

/// Memory that reading needs for each byte: four bytes of text ("0 0" and a line end) become a point of 16, and stay.
constexpr double bytes_for_each = 5;

/// Limits the decompressed size to what the header claims and to what fits into memory.
class DecompressionLimit {
 public:
  DecompressionLimit(const std::string& name, const Claim& claim, const std::string& way_out)
      : name_(name), claim_(claim), way_out_(way_out), next_(claim.size == nullptr ? any_size : slack) {}

  /// Checks the bytes that are decompressed so far. Throws BadInput if they are more than their header claims, or if
  /// memory would not suffice for them and for the points read from them.
  void require(std::string_view decompressed) {
    const auto size = static_cast<double>(decompressed.size());
    if (size > most_)
      bad_input(name_, "more than " + bytes_text(most_) + " decompressed",
                "at most a fifth of the " + bytes_text(bytes_for_each * most_) +
                    " of available memory, as reading takes several times as much" + way_out_);
    if (size <= next_) return;
    const double claimed = claimed_by(decompressed);
    if (size > claimed + slack)
      bad_input(name_, "more than " + counted(static_cast<std::size_t>(claimed) + slack, "byte") + " decompressed",
                counted(static_cast<std::size_t>(claimed), "byte") + " as the header claims, or at most " +
                    std::to_string(slack) + " more" + std::string(claim_.hint));
    next_ = std::max(claimed + slack, 2 * size);
  }

 private:
  /// Returns the size that the header claims. Adds to the message about a faulty header how much was decompressed,
  /// since more of the file may follow.
  double claimed_by(std::string_view decompressed) const {
    try {
      return claim_.size(decompressed, name_);
    } catch (const BadInput& refusal) {
      throw BadInput(std::string(refusal.what()) + " (in the first " + counted(decompressed.size(), "byte") +
                     " decompressed)");
    }
  }

  const std::string& name_;
  const Claim& claim_;
  const std::string& way_out_;
  double most_ = available_memory().value_or(any_size) / bytes_for_each;  // the greatest size that fits into memory
  double next_;                                                           // the size at which the claim is computed
};

}  // namespace

InputBytes::InputBytes(const std::string& name, const std::string& expected, const Claim& claim,
                       const std::string& way_out)
    : name_(name == "-" ? "standard input" : name) {
  const Descriptor file(name == "-" ? STDIN_FILENO : open_for_reading(name, expected));
  const struct stat status = status_of(file.number(), name_);
  if (S_ISDIR(status.st_mode)) bad_input(name_, "a folder", expected);
  if (S_ISREG(status.st_mode)) {
    read_file(file.number());
  } else {
    read_all(file.number());
  }
  if (is_gzip(bytes()) && claim.may_be_compressed) decompress(claim, way_out);
}

void InputBytes::decompress(const Claim& claim, const std::string& way_out) {
  constexpr std::size_t at_once = std::size_t{1} << 20U;  // so that a signal is noticed between two of them
  const std::unique_ptr<char, Free> all = std::move(data_);
  std::string_view compressed(all.get(), size_);
  room_ = size_ = 0;
  DecompressionLimit limit(name_, claim, way_out);
  Gunzip gunzip(name_);
  while (!compressed.empty() || !gunzip.is_between_members()) {
    stop_if_interrupted();
    if (gunzip.is_between_members() && !is_gzip(compressed))
      bad_input(name_, counted(compressed.size(), "byte") + " behind the compressed data", "the end of the file");
    if (room_ - size_ < at_once) make_room(std::max(2 * room_, size_ + at_once));
    size_ += gunzip.inflate(compressed, data_.get() + size_, at_once);
    limit.require(bytes());
  }
}

void InputBytes::make_room(std::size_t size) {
  void* larger = std::realloc(data_.get(), size);  // remaps large blocks instead of copying them
  if (larger == nullptr) throw std::bad_alloc();
  static_cast<void>(data_.release());
  data_.reset(static_cast<char*>(larger));
  room_ = size;
}

/// Reads at least one byte. Returns false if the end was reached instead.
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

/// Reads a regular file. Refuses it if its length or the time of its last change differs afterwards: the bytes would be
/// half old and half new.
void InputBytes::read_file(int descriptor) {
  const struct stat before = status_of(descriptor, name_);
  // Standard input may have been read in part by the program before.
  const off_t start = std::max<off_t>(lseek(descriptor, 0, SEEK_CUR), 0);
  const auto left = static_cast<std::size_t>(std::max<off_t>(before.st_size - start, 0));
  if (left == 0) return read_all(descriptor);  // empty, or generated as it is read, like the files of /proc
  make_room(left + 1);                         // one byte more shows whether the file has grown
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
