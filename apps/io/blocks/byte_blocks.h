// What: the bytes of a file from its beginning to its end, unpacked where it is a gzip file.
// Law:  the file is as long, and was changed last, when its end is reached as it was when it was opened.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace rbpa::app {

class ByteBlocks {
 public:
  /// `unpacks`: a file that begins as a gzip file does is one. Throws BadInput when there is no such file, or when it is
  /// none that can be read twice.
  ByteBlocks(const std::string& path, bool unpacks);
  ~ByteBlocks();
  ByteBlocks(const ByteBlocks&) = delete;
  ByteBlocks& operator=(const ByteBlocks&) = delete;

  /// Puts the next bytes at `to`; fewer than `size` at the end only. Throws BadInput, Failure, Cancelled.
  std::size_t read(char* to, std::size_t size);
  /// Passes over so many bytes, or to the end.
  void skip(std::uint64_t size);

  const std::string& name() const { return name_; }
  bool is_packed() const { return unpacking_ != nullptr; }
  std::uint64_t file_size() const { return file_size_; }
  std::uint64_t bytes_read() const { return bytes_read_; }  ///< of the file, packed as it is

 private:
  struct Unpacking;

  std::size_t read_file(char* to, std::size_t size);
  std::size_t unpack(char* to, std::size_t size);
  bool refill();
  void require_unchanged() const;

  std::string name_;
  int descriptor_;
  std::uint64_t file_size_ = 0, bytes_read_ = 0;
  long long changed_seconds_ = 0, changed_nanoseconds_ = 0;
  std::unique_ptr<Unpacking> unpacking_;
};

/// The first `size` bytes, or all where there are fewer.
std::string first_bytes(ByteBlocks& bytes, std::size_t size);

}  // namespace rbpa::app
