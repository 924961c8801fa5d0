// What: writes a file that appears whole or not at all.
// Law:  the file under the name of the target is unchanged before publish(); without publish() nothing is left behind
//       (temporary_file.h).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "io/bytes/descriptor.h"
#include "io/bytes/temporary_file.h"

namespace rbpa::app {

/// Writes to a temporary file in the folder of the target, which publish() renames to the target. A symbolic link is
/// followed, not replaced. Devices, pipes and "-", standard output, are written directly.
class OutputFile {
 public:
  /// Creates the temporary file, or opens a target that is written directly. All members throw Failure if the file
  /// cannot be written, ClosedPipe if the reader of a pipe is gone, and Cancelled.
  explicit OutputFile(const std::string& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes) {
    if (bytes.size() > buffer_size - used_) return write_far(bytes);
    used_ += bytes.copy(buffer_.get() + used_, bytes.size());
  }
  void write_number(double value);         ///< writes the shortest decimal text that reads back to the value
  void write_number(std::uint64_t value);  ///< writes decimal text
  /// Writes texts unchanged, and numbers as write_number() does.
  template <typename... Parts>
  void write_all(const Parts&... parts) {
    (write_part(parts), ...);
  }

  /// Writes values in binary, little-endian.
  template <typename T>
  void write_binary(std::span<const T> values) {
    const char* at = reinterpret_cast<const char*>(values.data());
    if constexpr (std::endian::native == std::endian::little) return write({at, values.size_bytes()});
    for (std::size_t i = 0; i < values.size(); ++i, at += sizeof(T))
      for (std::size_t byte = sizeof(T); byte > 0; --byte) write({at + byte - 1, 1});
  }
  template <typename T, std::size_t count>
  void write_binary(const std::array<T, count>& values) {
    write_binary(std::span<const T>(values));
  }
  template <typename T>
  requires std::is_arithmetic_v<T>
  void write_binary(T value) { write_binary(std::span<const T>(&value, 1)); }

  /// Returns the place for the next `size` bytes or fewer. written(end) then adds the bytes from this place to `end`.
  /// Saves calls for data that consist of very small pieces. Requires: size ≤ max_room; no other call before written().
  char* room(std::size_t size) {
    if (buffer_size - used_ < size) flush();
    return buffer_.get() + used_;
  }
  void written(const char* end) { used_ = static_cast<std::size_t>(end - buffer_.get()); }
  static constexpr std::size_t max_room = 4096;

  /// Writes all remaining bytes, a temporary file to the disk, so that finish() throws any error. Call once, before
  /// publish(); write nothing afterwards.
  void finish();
  /// Renames the temporary file, if there is one, to the target.
  void publish();

  /// Returns the name for messages.
  const std::string& name() const { return name_; }

 private:
  static constexpr std::size_t buffer_size = std::size_t{1} << 20U;

  template <typename Part>
  void write_part(const Part& part) {
    if constexpr (std::is_convertible_v<const Part&, std::string_view>)
      write(part);
    else if constexpr (std::is_floating_point_v<Part>)
      write_number(part);
    else
      write_number(std::uint64_t{part});
  }

  void open_beside(const std::string& path);
  void flush();
  void write_far(std::string_view bytes);
  void write_through(std::string_view bytes);
  void reach_disk();
  [[noreturn]] void fail(const std::string& doing) const;

  std::string name_;
  std::optional<TemporaryFile> temporary_ = std::nullopt;  // one of these two is present
  std::optional<Descriptor> direct_ = std::nullopt;
  int descriptor_ = -1;  // the descriptor of the one that is present
  std::size_t size_ = 0;
  std::unique_ptr<char[]> buffer_;
  std::size_t used_ = 0;
};

/// The output files of one run. Requires: every file is finished before publish(), so that all are complete before the
/// first takes its name.
class OutputSet {
 public:
  /// Adds a file, which belongs to this set. Throws as the constructor of OutputFile.
  OutputFile& add(const std::string& path);
  void publish() {
    for (const auto& file : files_) file->publish();
  }

 private:
  std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace rbpa::app
