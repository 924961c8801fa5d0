#include "stream/scratch_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "io/failure.h"
#include "io/interrupt.h"

namespace rbpa::app {
namespace {

constexpr std::size_t at_once = std::size_t{4} << 20U;  // so that a signal is noticed between two of them

int flags_of(ScratchFile::Mode mode) {
  switch (mode) {
    case ScratchFile::Mode::read:
      return O_RDONLY;
    case ScratchFile::Mode::write:
      return O_WRONLY | O_CREAT | O_TRUNC;
    case ScratchFile::Mode::append:
      return O_WRONLY | O_CREAT | O_APPEND;
    case ScratchFile::Mode::update:
      break;
  }
  return O_RDWR;
}

}  // namespace

ScratchFile::ScratchFile(const std::string& path, Mode mode)
    : path_(path), descriptor_(open(path.c_str(), flags_of(mode) | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) fail("cannot open");
}

ScratchFile::~ScratchFile() { close(descriptor_); }

void ScratchFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    stop_if_interrupted();
    const ssize_t count = ::write(descriptor_, bytes.data(), std::min(bytes.size(), at_once));
    if (count < 0 && errno != EINTR) fail("cannot write");
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void ScratchFile::write_at(std::uint64_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno != EINTR) fail("cannot write");
    if (count <= 0) continue;
    bytes.remove_prefix(static_cast<std::size_t>(count));
    offset += static_cast<std::uint64_t>(count);
  }
}

std::size_t ScratchFile::read(char* to, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    stop_if_interrupted();
    const ssize_t count = ::read(descriptor_, to + done, std::min(size - done, at_once));
    if (count < 0 && errno != EINTR) fail("cannot read");
    if (count == 0) break;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  return done;
}

std::size_t ScratchFile::read_at(std::uint64_t offset, char* to, std::size_t size) const {
  std::size_t done = 0;
  while (done < size) {
    stop_if_interrupted();
    const ssize_t count =
        pread(descriptor_, to + done, std::min(size - done, at_once), static_cast<off_t>(offset + done));
    if (count < 0 && errno != EINTR) fail("cannot read");
    if (count == 0) break;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  return done;
}

std::uint64_t ScratchFile::size() const {
  struct stat status {};
  if (fstat(descriptor_, &status) != 0) fail("cannot read");
  return static_cast<std::uint64_t>(status.st_size);
}

void ScratchFile::cut(std::uint64_t size) {
  if (ftruncate(descriptor_, static_cast<off_t>(size)) != 0) fail("cannot write");
}

void ScratchFile::fail(const char* doing) const {
  const int reason = errno;
  if (reason == EINTR) stop_if_interrupted();
  throw Failure(path_ + ": " + doing + ": " + std::strerror(reason));
}

std::string scratch_content(const std::string& path) {
  if (access(path.c_str(), F_OK) != 0) return "";
  ScratchFile file(path, ScratchFile::Mode::read);
  std::string bytes(file.size(), '\0');
  bytes.resize(file.read(bytes.data(), bytes.size()));
  return bytes;
}

void replace_content(const std::string& path, std::string_view bytes) {
  const std::string beside = path + ".new";
  ScratchFile(beside, ScratchFile::Mode::write).write(bytes);
  rename_scratch(beside, path);
}

void rename_scratch(const std::string& from, const std::string& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) throw Failure(to + ": cannot write: " + std::strerror(errno));
}

std::uint32_t checksum_of(std::string_view bytes, std::uint32_t before) {
  uLong sum = before;
  constexpr std::size_t part = std::size_t{1} << 30U;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(part, bytes.size())))
    sum = crc32(sum, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(std::min(part, bytes.size())));
  return static_cast<std::uint32_t>(sum);
}

}  // namespace rbpa::app
