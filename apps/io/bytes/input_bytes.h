// What: everything a file or standard input holds, in memory.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "io/bytes/claim.h"

namespace rbpa::app {

/// The bytes are read, not mapped: a mapped file that somebody shortens kills whoever looks at it. What the difference
/// costs is in docs/io.md.
class InputBytes {
 public:
  /// `name` is a path, or "-" for standard input; `expected` is what it should hold. Of a gzip file the bytes are those that
  /// were compressed, unless the claim excludes it: its header and memory limit how many those are, and `way_out` ends the
  /// message that memory does not suffice. Throws BadInput when there is no such file, or when a regular file
  /// changes while it is read; Failure when reading breaks off; Cancelled.
  InputBytes(const std::string& name, const std::string& expected, const Claim& claim = {},
             const std::string& way_out = "");

  std::string_view bytes() const { return {data_.get(), size_}; }
  /// What messages call it.
  const std::string& name() const { return name_; }

 private:
  struct Free {
    void operator()(char* data) const { std::free(data); }
  };

  void make_room(std::size_t size);
  bool read_some(int descriptor);
  void read_all(int descriptor);
  void read_file(int descriptor);
  void unpack(const Claim& claim, const std::string& way_out);

  std::string name_;
  std::unique_ptr<char, Free> data_;
  std::size_t room_ = 0;
  std::size_t size_ = 0;
};

}  // namespace rbpa::app
