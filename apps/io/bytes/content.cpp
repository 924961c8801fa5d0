#include "io/bytes/content.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include "io/bytes/descriptor.h"
#include "io/bytes/gunzip.h"
#include "io/bytes/unpack_limit.h"
#include "io/failure.h"
#include "io/interrupt.h"

namespace rbpa::app {
namespace {

constexpr std::size_t at_once = std::size_t{1} << 20U;  // so that a signal is noticed between two of them

}  // namespace

/// A file that is read from its beginning to its end.
class Content::File {
 public:
  File(const std::string& path, bool unpacks);
  ~File() { close(descriptor_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// Puts the next bytes at `to`; fewer than `size` at the end only.
  std::size_t read(char* to, std::size_t size);
  /// Passes over so many bytes, or to the end.
  void skip(std::uint64_t size);

  const std::string& path() const { return name_; }
  bool unpacks() const { return unpacks_; }
  bool is_packed() const { return unpacking_ != nullptr; }
  std::uint64_t file_size() const { return file_size_; }
  std::uint64_t bytes_read() const { return bytes_read_; }

 private:
  struct Unpacking;

  std::size_t read_file(char* to, std::size_t size);
  std::size_t unpack(char* to, std::size_t size);
  bool refill();
  void require_unchanged() const;

  std::string name_;
  bool unpacks_;
  int descriptor_;
  std::uint64_t file_size_ = 0, bytes_read_ = 0;
  long long changed_seconds_ = 0, changed_nanoseconds_ = 0;
  std::unique_ptr<Unpacking> unpacking_;
};

struct Content::File::Unpacking {
  Unpacking() : packed(at_once) {
    constexpr int widest_window = 15, gzip_only = 16;
    if (inflateInit2(&state, widest_window + gzip_only) != Z_OK) throw std::bad_alloc();
  }
  ~Unpacking() { inflateEnd(&state); }
  Unpacking(const Unpacking&) = delete;
  Unpacking& operator=(const Unpacking&) = delete;

  z_stream state{};
  std::vector<char> packed;
  bool between_members = false;
};

Content::File::File(const std::string& path, bool unpacks)
    // A pipe that nobody writes to would keep a blocking open waiting for ever.
    : name_(path), unpacks_(unpacks), descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
  const std::string expected = "a file of points";
  if (descriptor_ < 0 && errno == ENXIO) bad_input(path, "a socket or a device", "a file, which can be read twice");
  if (descriptor_ < 0) bad_input(path, errno == ENOENT ? "no such file" : std::strerror(errno), expected);
  try {
    const struct stat status = status_of(descriptor_, name_);
    if (S_ISDIR(status.st_mode)) bad_input(name_, "a folder", expected);
    if (!S_ISREG(status.st_mode)) bad_input(name_, "a pipe or a device", "a file, which can be read twice");
    file_size_ = static_cast<std::uint64_t>(status.st_size);
    changed_seconds_ = status.st_mtim.tv_sec;
    changed_nanoseconds_ = status.st_mtim.tv_nsec;
    posix_fadvise(descriptor_, 0, 0, POSIX_FADV_SEQUENTIAL);
    char first[3];
    const ssize_t count = pread(descriptor_, first, sizeof first, 0);
    if (unpacks && count == sizeof first && is_gzip({first, sizeof first})) unpacking_ = std::make_unique<Unpacking>();
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

std::size_t Content::File::read(char* to, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    stop_if_interrupted();
    const std::size_t some = std::min(size - done, at_once);
    const std::size_t count = unpacking_ ? unpack(to + done, some) : read_file(to + done, some);
    if (count == 0) break;
    done += count;
  }
  return done;
}

void Content::File::skip(std::uint64_t size) {
  if (!unpacking_) {
    bytes_read_ = std::min(file_size_, bytes_read_ + size);
    return;
  }
  std::vector<char> passed(std::min<std::uint64_t>(size, at_once));
  while (size > 0) {
    const std::size_t count = read(passed.data(), std::min<std::uint64_t>(size, passed.size()));
    if (count == 0) return;
    size -= count;
  }
}

/// At least a byte, unless the end has come.
std::size_t Content::File::read_file(char* to, std::size_t size) {
  while (true) {
    const ssize_t count = pread(descriptor_, to, size, static_cast<off_t>(bytes_read_));
    if (count > 0) {
      bytes_read_ += static_cast<std::uint64_t>(count);
      return static_cast<std::size_t>(count);
    }
    if (count == 0) {
      require_unchanged();
      return 0;
    }
    if (errno != EINTR) throw Failure(name_ + ": cannot read: " + std::strerror(errno));
    stop_if_interrupted();
  }
}

bool Content::File::refill() {
  z_stream& state = unpacking_->state;
  if (state.avail_in > 0) return true;
  const std::size_t count = read_file(unpacking_->packed.data(), unpacking_->packed.size());
  state.next_in = reinterpret_cast<Bytef*>(unpacking_->packed.data());
  state.avail_in = static_cast<uInt>(count);
  return count > 0;
}

std::size_t Content::File::unpack(char* to, std::size_t size) {
  z_stream& state = unpacking_->state;
  state.next_out = reinterpret_cast<Bytef*>(to);
  state.avail_out = static_cast<uInt>(size);
  while (state.avail_out == size) {
    if (!refill()) {
      if (unpacking_->between_members) return 0;
      bad_input(name_, "the end of the file inside compressed data", "a whole gzip file");
    }
    if (unpacking_->between_members) inflateReset(&state);
    const int code = inflate(&state, Z_NO_FLUSH);
    if (code != Z_OK && code != Z_STREAM_END) {
      const std::string why = state.msg == nullptr ? "" : " (" + std::string(state.msg) + ")";
      bad_input(name_, "damaged gzip data" + why, "a whole gzip file");
    }
    unpacking_->between_members = code == Z_STREAM_END;
  }
  return size - state.avail_out;
}

/// What somebody else writes meanwhile is half of the old and half of the new.
void Content::File::require_unchanged() const {
  const struct stat now = status_of(descriptor_, name_);
  if (static_cast<std::uint64_t>(now.st_size) == file_size_ && now.st_mtim.tv_sec == changed_seconds_ &&
      now.st_mtim.tv_nsec == changed_nanoseconds_)
    return;
  bad_input(name_, "a change while it was read", "a file that stays as it is while it is read");
}

Content::Content(std::string_view bytes, std::string name)
    : name_(std::move(name)), bytes_(bytes), all_(bytes), file_(nullptr) {}

Content::Content(Content&& other) noexcept = default;
Content& Content::operator=(Content&& other) noexcept = default;
Content::~Content() = default;

Content Content::of_file(const std::string& path, bool unpacks) {
  Content content({}, path);
  content.file_ = std::make_unique<File>(path, unpacks);
  content.ended_ = false;
  return content;
}

Content Content::again() const { return file_ ? of_file(file_->path(), file_->unpacks()) : Content(all_, name_); }

std::string_view Content::ahead(std::size_t size) {
  if (bytes_.size() >= size || ended_) return bytes_;
  buffer_.erase(buffer_.begin(), buffer_.end() - static_cast<std::ptrdiff_t>(bytes_.size()));
  while (buffer_.size() < size && !ended_) {  // a header may claim what is not there
    const std::size_t before = buffer_.size();
    buffer_.resize(before + at_once);
    const std::size_t count = file_->read(buffer_.data() + before, at_once);
    buffer_.resize(before + count);
    ended_ = count < at_once;
  }
  return bytes_ = {buffer_.data(), buffer_.size()};
}

void Content::skip(std::uint64_t size) {
  const std::size_t here = std::min<std::uint64_t>(size, bytes_.size());
  bytes_.remove_prefix(here);
  if (here < size && !ended_) file_->skip(size - here);
}

std::size_t Content::size() const {
  return !file_ ? all_.size() : file_->is_packed() ? unknown_size : file_->file_size();
}
bool Content::is_packed() const { return file_ && file_->is_packed(); }
std::uint64_t Content::bytes_read() const { return file_ ? file_->bytes_read() : all_.size() - bytes_.size(); }

}  // namespace rbpa::app
