// What: what a gzip file holds.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace rbpa::app {

/// Whether the bytes begin as a gzip file does.
bool is_gzip(std::string_view bytes);

/// Inflates all members of a gzip file, one behind the other.
class Gunzip {
 public:
  /// Messages call the file `name`.
  explicit Gunzip(const std::string& name);
  ~Gunzip() { inflateEnd(&state_); }
  Gunzip(const Gunzip&) = delete;
  Gunzip& operator=(const Gunzip&) = delete;

  /// Inflates from the front of `packed`, of which it takes what it needs; none mean the end of the file. Returns how many
  /// bytes it put at `to`, at most `size` and perhaps none. Throws BadInput naming what is wrong.
  std::size_t inflate(std::string_view& packed, char* to, std::size_t size);
  /// What was inflated so far ends with a member: the file may end here.
  bool is_between_members() const { return between_members_; }

 private:
  const std::string& name_;
  z_stream state_{};
  bool between_members_ = false;
};

}  // namespace rbpa::app
