// What: writes an array of numbers as an element of a page, in base64: little-endian doubles, or whole numbers with
//       seven bits in each byte, the lowest bits first, and 128 added to each byte but the last.
// Law:  the bytes depend on the numbers alone.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "io/bytes/output_file.h"

namespace rbpa::app {

class Blob {
 public:
  /// Writes <script type="application/base64" id="data-NAME">. Keeps a reference to `file`. All members throw as
  /// OutputFile::write() does; Cancelled.
  Blob(OutputFile& file, std::string_view name);
  Blob(const Blob&) = delete;
  Blob& operator=(const Blob&) = delete;

  void put(double value);
  void put_whole(std::uint64_t value);
  /// Adds a signed number: 0, −1, 1, −2, … become 0, 1, 2, 3, …
  void put_signed(std::int64_t value) {
    put_whole(static_cast<std::uint64_t>(value) << 1U ^ static_cast<std::uint64_t>(value >> 63U));
  }
  /// Writes the waiting bytes and the end of the element. Requires: the last call, and the only one.
  void end();

 private:
  void put_byte(std::uint8_t byte);
  void flush();

  OutputFile& file_;
  std::string bytes_;
};

/// Returns the bytes in the base64 of RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace rbpa::app
