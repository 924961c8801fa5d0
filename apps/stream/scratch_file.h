// What: reads and writes files of scratch. Failures are reported in one line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rbpa::app {

/// An open file of scratch. All members throw Failure "FILE: cannot write: No space left on device"; the constructor
/// throws BadInput if the path names something other than a file.
class ScratchFile {
 public:
  enum class Mode { read, write, append, update };  // write truncates; update overwrites
  ScratchFile(const std::string& path, Mode mode);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  /// Writes after the bytes written before. Throws Cancelled after a signal, as reading does.
  void write(std::string_view bytes);
  /// Return the number of bytes read, fewer than `size` only at the end of the file.
  std::size_t read(char* to, std::size_t size);
  std::size_t read_at(std::uint64_t offset, char* to, std::size_t size) const;
  std::uint64_t size() const;
  void cut(std::uint64_t size);

 private:
  [[noreturn]] void fail(const char* doing) const;

  std::string path_;
  int descriptor_;
  std::uint64_t position_ = 0;  // of the next byte that read() returns
};

/// Returns the whole content of a file; empty if there is no file.
std::string scratch_content(const std::string& path);

/// Replaces the content of the file by `bytes`, atomically.
void replace_content(const std::string& path, std::string_view bytes);

/// Replaces the content by `text` and its checksum. checked_content() verifies and removes the checksum; it throws
/// BadInput that names the file if it is wrong, and returns an empty text if there is no file.
void replace_checked(const std::string& path, std::string_view text);
std::string checked_content(const std::string& path);

/// Throws BadInput "PATH: found FOUND (remove FOLDER and start again)".
[[noreturn]] void begin_anew(const std::string& path, const std::string& found, const std::string& folder);

/// Convert any bytes to text that is valid in JSON, and back: '%' and bytes beyond ASCII become %XX.
std::string json_text(std::string_view bytes);
std::string bytes_of_json_text(std::string_view text);

/// Returns "000012" for 12: at least six digits.
std::string file_number(std::uint64_t number);

/// Renames a file, replacing any file of the new name.
void rename_scratch(const std::string& from, const std::string& to);

/// Returns the CRC-32 of zlib.
std::uint32_t checksum_of(std::string_view bytes, std::uint32_t before = 0);

}  // namespace rbpa::app
