// What: reads a whole file, or standard input, into memory.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace rbpa::app {

/// The way to read a file that begins like a gzip file.
struct Decompression {
  bool is_wanted = true;     ///< false: the file is read unchanged
  bool is_of_text = false;   ///< true: zero bytes are refused, as a few kilobytes can decompress to gigabytes of them
  std::string way_out = {};  ///< end of the message for a file that exceeds the limit
};

/// The bytes of a file. They are read, not mapped: shortening a mapped file kills the processes that read it.
class InputBytes {
 public:
  /// Reads `name`, a path or "-" for standard input. Decompresses a gzip file: at most to a fifth of the available
  /// memory, and beyond 64 MiB at most to 500 times its compressed size, which only long runs of one byte exceed. In
  /// messages `expected` is the noun for the expected content. Throws BadInput if there is no such file, if the file
  /// decompresses to more, or if a regular file changes while it is read; Failure if reading fails; Cancelled.
  InputBytes(const std::string& name, const std::string& expected, const Decompression& how = {});

  std::string_view bytes() const { return {data_.get(), size_}; }
  /// Returns the name for messages.
  const std::string& name() const { return name_; }

 private:
  struct Free {
    void operator()(char* data) const { std::free(data); }
  };

  void make_room(std::size_t size);
  bool read_some(int descriptor);
  void read_all(int descriptor);
  void read_file(int descriptor);
  void decompress(const Decompression& how);

  std::string name_;
  std::unique_ptr<char, Free> data_;
  std::size_t room_ = 0;
  std::size_t size_ = 0;
};

}  // namespace rbpa::app
