// What: everything a file or standard input holds, in memory.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rbpa::app {

/// A regular file is mapped, so that its bytes are neither copied nor counted twice; anything else is read to its end.
class InputBytes {
 public:
  /// `name` is a path, or "-" for standard input; `expected` is what it should hold. Throws BadInput when there is no
  /// such file, Failure when reading breaks off, Cancelled.
  InputBytes(const std::string& name, const std::string& expected);
  ~InputBytes();
  InputBytes(const InputBytes&) = delete;
  InputBytes& operator=(const InputBytes&) = delete;

  std::string_view bytes() const { return {data_, size_}; }
  /// What messages call it.
  const std::string& name() const { return name_; }

 private:
  void read_to_end(int descriptor);

  std::string name_;
  char* data_ = nullptr;
  std::size_t size_ = 0;
  bool mapped_ = false;
};

}  // namespace rbpa::app
