#include "io/bytes/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"

namespace rbpa::app {

OutputFile::OutputFile(const std::string& path)
    : name_(path == "-" ? "standard output" : path), buffer_(new char[buffer_size]) {
  struct stat status {};
  if (path == "-") {
    direct_.emplace(STDOUT_FILENO);
  } else if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    direct_.emplace(open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (direct_->number() < 0) fail("cannot open");
  } else {
    open_beside(behind_links(path));
  }
  descriptor_ = direct_ ? direct_->number() : temporary_->descriptor();
}

void OutputFile::open_beside(const std::string& path) {
  struct stat status {};
  const bool exists = stat(path.c_str(), &status) == 0;
  if (exists && access(path.c_str(), W_OK) != 0) fail("cannot write");
  try {
    temporary_.emplace(path);
  } catch (const std::system_error& error) {
    errno = error.code().value();
    fail("cannot create a file in this folder");
  }
  if (exists) (void)fchmod(temporary_->descriptor(), status.st_mode & 07777U);  // keep the permissions if possible
}

void OutputFile::write_far(std::string_view bytes) {
  flush();
  if (bytes.size() >= buffer_size) return write_through(bytes);
  write(bytes);
}

void OutputFile::write_number(double value) { written(put_number(room(number_room), value)); }

void OutputFile::write_number(std::uint64_t value) { written(put_number(room(number_room), value)); }

void OutputFile::flush() {
  write_through({buffer_.get(), used_});
  used_ = 0;
}

void OutputFile::write_through(std::string_view bytes) {
  while (!bytes.empty()) {
    stop_if_interrupted();
    const ssize_t count = ::write(descriptor_, bytes.data(), std::min(bytes.size(), buffer_size));
    if (count >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
      size_ += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN) {
      wait_to_write(descriptor_);
    } else if (errno != EINTR) {
      fail("cannot write");
    }
  }
}

/// Writes the file to the disk part by part, so that a signal is noticed between two parts: fsync() of a large file may
/// take seconds.
void OutputFile::reach_disk() {
  constexpr std::size_t part = std::size_t{8} << 20U;
  for (std::size_t at = 0; at < size_; at += part) {
    stop_if_interrupted();
    constexpr unsigned wait_for_it = SYNC_FILE_RANGE_WAIT_BEFORE | SYNC_FILE_RANGE_WRITE | SYNC_FILE_RANGE_WAIT_AFTER;
    // Ignore a failure: fsync() writes everything.
    (void)sync_file_range(descriptor_, static_cast<off_t>(at), static_cast<off_t>(part), wait_for_it);
  }
  if (fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) fail("cannot write");
}

void OutputFile::finish() {
  flush();
  if (temporary_) reach_disk();
  // Close a duplicate of the descriptor: a network disk or a full disk may report an error only on close().
  const int second = fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
  if (second >= 0 && close(second) != 0 && errno != EINTR) fail("cannot write");
  stop_if_interrupted();
}

void OutputFile::publish() {
  if (!temporary_) return;
  try {
    temporary_->take_place();
  } catch (const std::system_error& error) {
    errno = error.code().value();
    fail("cannot rename the finished file to this name");
  }
  temporary_.reset();
}

void OutputFile::fail(const std::string& doing) const {
  const int reason = errno;
  if (reason == EINTR) stop_if_interrupted();
  if (reason == EPIPE) throw ClosedPipe();
  throw Failure(name_ + ": " + doing + ": " + std::strerror(reason));
}

OutputFile& OutputSet::add(const std::string& path) {
  files_.push_back(std::make_unique<OutputFile>(path));
  if (path != "-") clear_abandoned(behind_links(path));
  return *files_.back();
}

}  // namespace rbpa::app
