// What: records in a file of scratch, one behind the other, with a checksum of them all.
// Law:  what is read is what was written, or BadInput.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "stream/scratch_file.h"

namespace rbpa::app {

/// How far a file has come.
struct RecordState {
  std::uint64_t bytes = 0;
  std::uint32_t checksum = 0;
};

/// Appends to the file at `path`, which is open only while that is done.
class RecordLog {
 public:
  explicit RecordLog(std::string path) : path_(std::move(path)) {}

  /// Goes on where the file had come to. Throws BadInput when there is less.
  void resume(const RecordState& state);
  template <typename T>
  void append(const T& value) {
    append(std::string_view(reinterpret_cast<const char*>(&value), sizeof value));
  }
  void append(std::string_view bytes);
  /// All that was appended is in the file.
  RecordState flush();

  const std::string& path() const { return path_; }
  const RecordState& state() const { return state_; }  ///< of what is in the file

 private:
  std::string path_;
  RecordState state_ = {};
  std::string waiting_ = {};
};

/// The bytes of a file from somewhere on, with some of them ahead.
class RecordReader {
 public:
  RecordReader(const ScratchFile& file, const std::string& path, std::uint64_t at, std::size_t ahead)
      : file_(file), path_(path), at_(at), end_(file.size()), ahead_(ahead) {}

  bool at_end() const { return at_ == end_ && used_ == buffer_.size(); }
  /// The next bytes, until the next call. Throws BadInput when the file has fewer.
  std::string_view take(std::uint64_t size);
  template <typename T>
  T take() {
    T value;
    std::memcpy(static_cast<void*>(&value), take(sizeof value).data(), sizeof value);
    return value;
  }
  std::uint32_t checksum() const { return checksum_; }  ///< of everything read so far

 private:
  const ScratchFile& file_;
  const std::string& path_;
  std::uint64_t at_, end_;  // of the file, behind the buffer
  std::size_t ahead_, used_ = 0;
  std::string buffer_ = {};
  std::uint32_t checksum_ = 0;
};

/// A record that is read part by part when it is its turn, as there is no room for it among others.
constexpr std::uint64_t long_record = std::uint64_t{1} << 16U;

}  // namespace rbpa::app
