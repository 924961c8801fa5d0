// What: the whole content of a file or of standard input in memory.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "io/bytes/claim.h"

namespace rbpa::app {

/// The bytes of a file. They are read, not mapped: shortening a mapped file kills the processes that read it.
class InputBytes {
 public:
  /// Reads `name`, a path or "-" for standard input, and decompresses a gzip file unless the claim excludes that. The
  /// claim of the header and the memory limit the decompressed size. In messages, `expected` says what the file should
  /// hold, and `way_out` follows the message that memory does not suffice. Throws BadInput if there is no such file or
  /// if a regular file changes while it is read; Failure if reading fails; Cancelled.
  InputBytes(const std::string& name, const std::string& expected, const Claim& claim = {},
             const std::string& way_out = "");

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
  void decompress(const Claim& claim, const std::string& way_out);

  std::string name_;
  std::unique_ptr<char, Free> data_;
  std::size_t room_ = 0;
  std::size_t size_ = 0;
};

}  // namespace rbpa::app
