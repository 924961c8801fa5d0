#include "io/bytes/temporary_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "io/bytes/descriptor.h"

namespace rbpa::app {
namespace {

constexpr std::string_view beginning = ".rbpa-", ending = ".tmp";

std::string name_beside(const std::string& path, int attempt) {
  const std::string folder = path.substr(0, path.rfind('/') + 1);
  return folder + std::string(beginning) + std::to_string(getpid()) + "-" + std::to_string(attempt) +
         std::string(ending);
}

/// Returns whether `name` is of the form ".rbpa-NUMBER-NUMBER.tmp".
bool is_temporary(std::string_view name) {
  if (!name.starts_with(beginning) || !name.ends_with(ending)) return false;
  name.remove_prefix(beginning.size());
  name.remove_suffix(std::min(ending.size(), name.size()));
  const auto dash = std::find(name.begin(), name.end(), '-');
  const auto is_number = [](auto first, auto last) {
    return first != last && std::all_of(first, last, [](char c) { return c >= '0' && c <= '9'; });
  };
  return dash != name.end() && is_number(name.begin(), dash) && is_number(dash + 1, name.end());
}

/// Returns whether the file that `descriptor` has open is still called `name`.
bool names(const std::string& name, int descriptor) {
  struct stat named {
  }, opened{};
  return lstat(name.c_str(), &named) == 0 && fstat(descriptor, &opened) == 0 && named.st_dev == opened.st_dev &&
         named.st_ino == opened.st_ino;
}

[[noreturn]] void fail(const char* doing) { throw std::system_error(errno, std::generic_category(), doing); }

}  // namespace

TemporaryFile::TemporaryFile(const std::string& path) : path_(path) {
  for (int attempt = 0; !create(name_beside(path, attempt)); ++attempt) continue;
}

/// Creates and locks a file called `name`. Returns false if the name exists, or if another process has removed or
/// locked the new file before.
bool TemporaryFile::create(const std::string& name) {
  const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0 && errno == EEXIST) return false;
  if (descriptor < 0) fail("cannot create");
  // Check the lock: before this process had the lock, another process may have removed the file as abandoned, or may be
  // about to do so.
  const bool taken = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  struct stat status {};
  if (taken || fstat(descriptor, &status) != 0 || status.st_nlink == 0) {
    close(descriptor);
    return false;
  }
  descriptor_ = descriptor;
  name_ = name;
  return true;
}

TemporaryFile::~TemporaryFile() {
  if (!name_.empty()) unlink(name_.c_str());
  close(descriptor_);  // also releases the lock
}

void TemporaryFile::take_place() {
  if (std::rename(name_.c_str(), path_.c_str()) != 0) fail("cannot rename the finished file");
  name_.clear();
}

void clear_abandoned(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  std::error_code error;
  std::filesystem::directory_iterator entry(slash == std::string::npos ? "." : path.substr(0, slash + 1), error);
  for (const std::filesystem::directory_iterator end; !error && entry != end; entry.increment(error)) {
    if (!is_temporary(entry->path().filename().native())) continue;
    const std::string name = entry->path().string();
    // Open for writing, as some file systems lock only such files, and without blocking, in case the file is a pipe.
    const Descriptor file(open(name.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    if (file.number() < 0 || flock(file.number(), LOCK_EX | LOCK_NB) != 0) continue;
    // Check the name: if the writer has finished since open(), the file is now the target.
    struct stat status {};
    if (fstat(file.number(), &status) == 0 && S_ISREG(status.st_mode) && names(name, file.number()))
      unlink(name.c_str());
  }
}

}  // namespace rbpa::app
