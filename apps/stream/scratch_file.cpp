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

constexpr std::size_t at_once = std::size_t{4} << 20U;  // bytes of one system call; signals are noticed between calls

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
    // Open without blocking: opening a pipe in place of a file would otherwise block forever.
    : path_(path), descriptor_(open(path.c_str(), flags_of(mode) | O_CLOEXEC | O_NONBLOCK | O_NOCTTY, 0666)) {
  if (descriptor_ < 0) fail("cannot open");
  struct stat status {};
  if (fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)) return;
  close(descriptor_);
  bad_input(path_, "a folder, a pipe or a device", "a file");
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

std::size_t ScratchFile::read(char* to, std::size_t size) {
  const std::size_t count = read_at(position_, to, size);
  position_ += count;
  return count;
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

namespace {

constexpr std::size_t checksum_digits = 8;
constexpr char hex[] = "0123456789ABCDEF";

/// Returns the last line of a checked file, the checksum of `text`; `text` is all that precedes the line.
std::string last_line(std::string_view text) {
  const std::uint32_t sum = checksum_of(text);
  std::string line;
  for (std::size_t digit = checksum_digits; digit-- > 0;) line += hex[sum >> 4 * digit & 15U];
  return line += '\n';
}

}  // namespace

void replace_checked(const std::string& path, std::string_view text) {
  std::string bytes(text);
  bytes += '\n';
  replace_content(path, bytes + last_line(bytes));
}

std::string checked_content(const std::string& path) {
  std::string bytes = scratch_content(path);
  if (bytes.empty() && access(path.c_str(), F_OK) != 0) return bytes;
  const std::size_t size = bytes.size() - std::min(bytes.size(), checksum_digits + 1);
  if (std::string_view(bytes).substr(size) != last_line(std::string_view(bytes).substr(0, size)))
    begin_anew(path, "a file that was truncated or changed, expected an unchanged one",
               path.substr(0, path.rfind('/')));
  bytes.resize(size);
  return bytes;
}

std::string json_text_of_bytes(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80 && byte != '%')
      text += c;
    else
      (text += '%') += {hex[byte >> 4U], hex[byte & 15U]};
  }
  return text;
}

std::string bytes_of_json_text(std::string_view text) {
  const auto digit = [](char c) {
    const char* const at = c == '\0' ? nullptr : std::strchr(hex, c);
    if (at == nullptr) throw BadInput("a name with a % without two hexadecimal digits after it");
    return static_cast<unsigned>(at - hex);
  };
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      bytes += text[i];
      continue;
    }
    if (text.size() - i < 3) throw BadInput("a name with a % without two hexadecimal digits after it");
    bytes += static_cast<char>(digit(text[i + 1]) << 4U | digit(text[i + 2]));
    i += 2;
  }
  return bytes;
}

void begin_anew(const std::string& path, const std::string& found, const std::string& folder) {
  throw BadInput(path + ": found " + found + " (remove " + (folder == path ? "it" : folder) + " and start again)");
}

std::string file_number(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  return std::string(6 - std::min<std::size_t>(digits.size(), 6), '0') + digits;
}

void rename_scratch(const std::string& from, const std::string& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0)
    throw Failure(from + ": cannot rename to " + to + ": " + std::strerror(errno));
}

std::uint32_t checksum_of(std::string_view bytes, std::uint32_t before) {
  uLong sum = before;
  constexpr std::size_t part = std::size_t{1} << 30U;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(part, bytes.size())))
    sum = crc32(sum, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(std::min(part, bytes.size())));
  return static_cast<std::uint32_t>(sum);
}

}  // namespace rbpa::app
