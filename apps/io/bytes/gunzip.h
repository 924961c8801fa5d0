// What: decompresses gzip files.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace rbpa::app {

/// Returns whether the bytes begin like a gzip file.
bool is_gzip(std::string_view bytes);

/// Decompresses the members of a gzip file, one after another.
class Gunzip {
 public:
  /// Messages call the file `name`, which must outlive this object.
  explicit Gunzip(const std::string& name);
  ~Gunzip() { inflateEnd(&state_); }
  Gunzip(const Gunzip&) = delete;
  Gunzip& operator=(const Gunzip&) = delete;

  /// Decompresses bytes from the front of `compressed`, removes them from it, and writes at most `size` bytes to `to`.
  /// Returns how many were written, perhaps none. An empty `compressed` stands for the end of the file. Throws BadInput
  /// that names the fault.
  std::size_t inflate(std::string_view& compressed, char* to, std::size_t size);
  /// Returns whether the bytes decompressed until now end with a whole member, after which the file may end.
  bool is_between_members() const { return between_members_; }

 private:
  const std::string& name_;
  z_stream state_{};
  bool between_members_ = false;
};

}  // namespace rbpa::app
