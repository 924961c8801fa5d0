// What: writes and reads a file of scratch with one record after another, and computes the checksum of its bytes.
// Law:  reading returns the bytes of the file, or throws BadInput if the file is too short; callers compare checksums.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "stream/scratch_file.h"

namespace rbpa::app {

/// The state of a file, from which writing can be continued: the size and the checksum of the written bytes.
struct RecordState {
  std::uint64_t bytes = 0;
  std::uint32_t checksum = 0;
};

/// Appends to the file at `path`. The file is open only while bytes are written.
class RecordLog {
 public:
  explicit RecordLog(std::string path) : path_(std::move(path)) {}

  /// Continues the file from a state that flush() returned: cuts off bytes that were written later. Throws BadInput if
  /// the file is shorter than the state tells; Failure.
  void resume(const RecordState& state);
  template <typename T>
  void append(const T& value) {
    append(std::string_view(reinterpret_cast<const char*>(&value), sizeof value));
  }
  void append(std::string_view bytes);
  /// Writes all appended bytes to the file, and returns the state of the file. Throws Failure, Cancelled.
  RecordState flush();

  const std::string& path() const { return path_; }
  const RecordState& state() const { return state_; }  ///< state of the written part of the file

 private:
  std::string path_;
  RecordState state_ = {};
  std::string waiting_ = {};
};

/// Reads the bytes of a file from offset `at` on, at least `ahead` bytes at a time except at the end.
class RecordReader {
 public:
  RecordReader(const ScratchFile& file, const std::string& path, std::uint64_t at, std::size_t ahead)
      : file_(file), path_(path), at_(at), end_(file.size()), ahead_(ahead) {}

  bool at_end() const { return at_ == end_ && used_ == buffer_.size(); }
  /// Returns the next `size` bytes; valid until the next call. Throws BadInput if the file has fewer left; Failure,
  /// Cancelled.
  std::string_view take(std::uint64_t size);
  template <typename T>
  T take() {
    T value;
    std::memcpy(static_cast<void*>(&value), take(sizeof value).data(), sizeof value);
    return value;
  }
  std::uint32_t checksum() const { return checksum_; }  ///< checksum of all bytes that take() has returned

 private:
  const ScratchFile& file_;
  const std::string& path_;
  std::uint64_t at_, end_;  // offset of the byte after the buffer; size of the file
  std::size_t ahead_, used_ = 0;
  std::string buffer_ = {};
  std::uint32_t checksum_ = 0;
};

/// Size in bytes above which sorting does not keep a record in memory, but reads it again when it is needed.
constexpr std::uint64_t long_record = std::uint64_t{1} << 16U;

}  // namespace rbpa::app
