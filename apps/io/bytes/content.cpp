#include "io/bytes/content.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "io/bytes/descriptor.h"
#include "io/bytes/gunzip.h"
#include "io/failure.h"
#include "io/interrupt.h"

namespace rbpa::app {
namespace {

constexpr std::size_t at_once = std::size_t{1} << 20U;  // bytes of a read; a signal is noticed after it

}  // namespace

/// A file that is read once, from its beginning to its end.
struct Content::File {
  File(const std::string& path, bool may_decompress);

  /// Copies the next `size` bytes to `to`, fewer only at the end. Returns the number of copied bytes.
  std::size_t read(char* to, std::size_t size);
  /// Skips `size` bytes, or fewer at the end.
  void skip(std::uint64_t size);

  std::size_t read_file(char* to, std::size_t size);
  std::size_t decompress(char* to, std::size_t size);
  void require_unchanged() const;

  struct Decompressing {
    explicit Decompressing(const std::string& path) : gunzip(path), buffer(at_once) {}

    Gunzip gunzip;
    std::vector<char> buffer;
    std::string_view compressed = {};  // the bytes of `buffer` that are not decompressed yet
  };

  std::string name;
  bool decompresses;
  Descriptor file;
  struct stat status {};
  std::uint64_t bytes_read = 0;
  std::optional<Decompressing> decompressing = std::nullopt;  // present if the file is compressed
};

Content::File::File(const std::string& path, bool may_decompress)
    // Open without blocking: an open() of a pipe that has no writer would wait forever.
    : name(path), decompresses(may_decompress), file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
  const std::string expected = "a file of points";
  if (file.number() < 0 && errno == ENXIO)
    bad_input(path, "a socket or a device", "a regular file, as it is read twice");
  if (file.number() < 0) refuse_to_open(path, expected);
  status = status_of(file.number(), name);
  if (S_ISDIR(status.st_mode)) bad_input(name, "a folder", expected);
  if (!S_ISREG(status.st_mode)) bad_input(name, "a pipe or a device", "a regular file, as it is read twice");
  posix_fadvise(file.number(), 0, 0, POSIX_FADV_SEQUENTIAL);
  char first[3];
  const ssize_t count = pread(file.number(), first, sizeof first, 0);
  if (decompresses && count == sizeof first && is_gzip({first, sizeof first})) decompressing.emplace(name);
}

std::size_t Content::File::read(char* to, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    stop_if_interrupted();
    const std::size_t some = std::min(size - done, at_once);
    const std::size_t count = decompressing ? decompress(to + done, some) : read_file(to + done, some);
    if (count == 0) break;
    done += count;
  }
  return done;
}

void Content::File::skip(std::uint64_t size) {
  if (!decompressing) {
    bytes_read = std::min(static_cast<std::uint64_t>(status.st_size), bytes_read + size);
    return;
  }
  std::vector<char> passed(std::min<std::uint64_t>(size, at_once));
  while (size > 0) {
    const std::size_t count = read(passed.data(), std::min<std::uint64_t>(size, passed.size()));
    if (count == 0) return;
    size -= count;
  }
}

/// Reads at most `size` bytes, and at least one unless the end is reached. Returns the number of read bytes.
std::size_t Content::File::read_file(char* to, std::size_t size) {
  while (true) {
    const ssize_t count = pread(file.number(), to, size, static_cast<off_t>(bytes_read));
    if (count > 0) {
      bytes_read += static_cast<std::uint64_t>(count);
      return static_cast<std::size_t>(count);
    }
    if (count == 0) {
      require_unchanged();
      return 0;
    }
    if (errno != EINTR) throw Failure(name + ": cannot read: " + std::strerror(errno));
    stop_if_interrupted();
  }
}

std::size_t Content::File::decompress(char* to, std::size_t size) {
  auto& [gunzip, buffer, compressed] = *decompressing;
  std::size_t count = 0;
  while (count == 0) {
    if (compressed.empty()) compressed = {buffer.data(), read_file(buffer.data(), buffer.size())};
    if (compressed.empty() && gunzip.is_between_members()) break;
    count = gunzip.inflate(compressed, to, size);
  }
  return count;
}

/// Throws BadInput if the file has changed since it was opened: the bytes would be partly old and partly new.
void Content::File::require_unchanged() const {
  const struct stat now = status_of(file.number(), name);
  if (now.st_size == status.st_size && same_time(now.st_mtim, status.st_mtim)) return;
  bad_input(name, "a change while it was read", "a file that does not change while it is read (start again)");
}

Content::Content(std::string_view bytes, std::string name)
    : name_(std::move(name)), bytes_(bytes), all_(bytes), file_(nullptr) {}

Content::Content(Content&& other) noexcept = default;
Content& Content::operator=(Content&& other) noexcept = default;
Content::~Content() = default;

Content Content::of_file(const std::string& path, bool decompresses) {
  Content content({}, path);
  content.file_ = std::make_unique<File>(path, decompresses);
  content.ended_ = false;
  return content;
}

Content Content::again() const { return file_ ? of_file(file_->name, file_->decompresses) : Content(all_, name_); }

std::string_view Content::ahead(std::size_t size) {
  if (bytes_.size() >= size || ended_) return bytes_;
  buffer_.erase(buffer_.begin(), buffer_.end() - static_cast<std::ptrdiff_t>(bytes_.size()));
  while (buffer_.size() < size && !ended_) {  // grow step by step: a header may claim a larger `size` than there is
    constexpr std::size_t first = std::size_t{1} << 16U;  // enough for a header
    const std::size_t before = buffer_.size(), passed = std::min<std::uint64_t>(bytes_read(), at_once);
    const std::size_t wanted = is_sparse_ ? std::min(size - before, at_once) : std::max(passed, first);
    buffer_.resize(before + wanted);
    const std::size_t count = file_->read(buffer_.data() + before, wanted);
    buffer_.resize(before + count);
    ended_ = count < wanted;
  }
  return bytes_ = {buffer_.data(), buffer_.size()};
}

void Content::skip(std::uint64_t size) {
  const std::size_t here = std::min<std::uint64_t>(size, bytes_.size());
  bytes_.remove_prefix(here);
  if (here == size || ended_) return;
  file_->skip(size - here);
  is_sparse_ = !is_compressed();
}

std::size_t Content::size() const {
  return !file_ ? all_.size() : is_compressed() ? unknown_size : static_cast<std::size_t>(file_->status.st_size);
}
bool Content::is_compressed() const { return file_ && file_->decompressing.has_value(); }
std::uint64_t Content::bytes_read() const { return file_ ? file_->bytes_read : all_.size() - bytes_.size(); }

}  // namespace rbpa::app
