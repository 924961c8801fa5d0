// What: a file that appears whole or not at all.
// Law:  until publish() nothing is seen under its name; without publish() nothing is left behind (temporary_file.h).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/descriptor.h"
#include "io/bytes/temporary_file.h"

namespace rbpa::app {

/// Bytes go to a temporary file in the folder of the file, or of the one that a symbolic link leads to, and publish()
/// renames it. What exists and is not a regular file (a device, a pipe), and "-", standard output, is written directly.
class OutputFile {
 public:
  /// Throws Failure when it cannot be written; here as below ClosedPipe when nobody reads it, Cancelled.
  explicit OutputFile(const std::string& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes) {
    if (bytes.size() > buffer_size - used_) return write_far(bytes);
    used_ += bytes.copy(buffer_.get() + used_, bytes.size());
  }
  void write_number(double value);         ///< shortest text that reads back to it
  void write_number(std::uint64_t value);  ///< decimal text

  /// Values as they lie in memory of a little-endian machine.
  template <typename T>
  void write_binary(std::span<const T> values) {
    const char* at = reinterpret_cast<const char*>(values.data());
    if constexpr (std::endian::native == std::endian::little) return write({at, values.size_bytes()});
    for (std::size_t i = 0; i < values.size(); ++i, at += sizeof(T))
      for (std::size_t byte = sizeof(T); byte > 0; --byte) write({at + byte - 1, 1});
  }

  /// Where the next bytes belong, with room for `size` of them, at most max_room; written() takes those before `end`.
  /// For what is put together from pieces so small that a call for each is most of the work.
  char* room(std::size_t size) {
    if (buffer_size - used_ < size) flush();
    return buffer_.get() + used_;
  }
  void written(const char* end) { used_ = static_cast<std::size_t>(end - buffer_.get()); }
  static constexpr std::size_t max_room = 4096;

  /// Everything written is on its way to the disk, and no error came up. Call once, before publish().
  void finish();
  /// The file takes its name.
  void publish();

  /// What messages call it.
  const std::string& name() const { return name_; }

 private:
  static constexpr std::size_t buffer_size = std::size_t{1} << 20U;

  void open_beside(const std::string& path);
  void flush();
  void write_far(std::string_view bytes);
  void write_through(std::string_view bytes);
  void reach_disk();
  [[noreturn]] void fail(const std::string& doing) const;

  std::string name_;
  std::optional<TemporaryFile> temporary_ = std::nullopt;  // one of these two
  std::optional<Descriptor> direct_ = std::nullopt;
  int descriptor_ = -1;  // of that
  std::size_t size_ = 0;
  std::unique_ptr<char[]> buffer_;
  std::size_t used_ = 0;
};

/// The files of one run: all are complete before the first takes its name.
class OutputSet {
 public:
  /// Throws as OutputFile() does.
  OutputFile& add(const std::string& path);
  void publish() {
    for (const auto& file : files_) file->publish();
  }

 private:
  std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace rbpa::app
