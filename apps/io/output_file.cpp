#include "io/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

/// The file behind symbolic links, so that renaming does not replace a link.
std::string behind_links(const std::string& path) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(path, error);
  return error ? path : real.string();
}

std::string temporary_beside(const std::string& path, int attempt) {
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash + 1);
  return folder + ".rbpa-" + std::to_string(getpid()) + "-" + std::to_string(attempt) + ".tmp";
}

}  // namespace

OutputFile::OutputFile(const std::string& path)
    : name_(path == "-" ? "standard output" : path), path_(path), buffer_(new char[buffer_size]) {
  if (path == "-") {
    descriptor_ = STDOUT_FILENO;
    return;
  }
  struct stat status {};
  const bool exists = stat(path.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("cannot open");
    return;
  }
  if (exists && access(path.c_str(), W_OK) != 0) fail("cannot write");
  path_ = behind_links(path);
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    temporary_ = temporary_beside(path_, attempt);
    descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0 || errno == EEXIST) continue;
    temporary_.clear();
    fail("cannot create");
  }
  if (exists) (void)fchmod(descriptor_, status.st_mode & 07777U);  // best effort: the permissions it had
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0 && path_ != "-") close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
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

void OutputFile::write_through(std::string_view bytes) const {
  while (!bytes.empty()) {
    stop_if_interrupted();
    const ssize_t count = ::write(descriptor_, bytes.data(), std::min(bytes.size(), buffer_size));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("cannot write");
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void OutputFile::finish() {
  flush();
  if (path_ == "-") return;
  // A network or a full disk may refuse only now.
  if (!temporary_.empty() && fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) fail("cannot write");
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (close(descriptor) != 0 && errno != EINTR) fail("cannot write");
  stop_if_interrupted();
}

void OutputFile::publish() {
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot rename the finished file");
  temporary_.clear();
}

void OutputFile::fail(const std::string& doing) const {
  const int reason = errno;
  if (reason == EINTR) stop_if_interrupted();
  throw Failure(name_ + ": " + doing + ": " + std::strerror(reason));
}

}  // namespace rbpa::app
