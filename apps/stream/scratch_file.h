// What: reads and writes files of scratch. The message of each failure is one line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rbpa::app {

/// An open file of scratch. All members throw Failure, such as "FILE: cannot write: No space left on device"; the
/// constructor throws BadInput if a folder, a pipe or a device is at the path.
class ScratchFile {
 public:
  enum class Mode { read, write, append, update };  // write empties the file; update overwrites its beginning
  ScratchFile(const std::string& path, Mode mode);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  /// Writes at the position after the last written byte. Writing and reading throw Cancelled after a signal.
  void write(std::string_view bytes);
  /// Read at most `size` bytes to `to`, and return the number of bytes, which is below `size` only at the end of the
  /// file. read() continues after the last byte that read() returned; read_at() begins at `offset`.
  std::size_t read(char* to, std::size_t size);
  std::size_t read_at(std::uint64_t offset, char* to, std::size_t size) const;
  std::uint64_t size() const;
  void cut(std::uint64_t size);

 private:
  [[noreturn]] void fail(const char* doing) const;

  std::string path_;
  int descriptor_;
  std::uint64_t position_ = 0;  // offset of the next byte for read()
};

/// Returns the content of the file at `path`, or "" if there is no file. Throws as ScratchFile does.
std::string scratch_content(const std::string& path);

/// Replaces the content of the file at `path` by `bytes`, atomically. Throws as ScratchFile does.
void replace_content(const std::string& path, std::string_view bytes);

/// Replaces the content of a file, atomically, by `text`, a line end and their checksum. checked_content() returns text
/// and line end, or "" if there is no file; it throws BadInput that names the file if the checksum is wrong.
void replace_checked(const std::string& path, std::string_view text);
std::string checked_content(const std::string& path);

/// Throws BadInput with the message "PATH: found FOUND (remove FOLDER and start again)".
[[noreturn]] void begin_anew(const std::string& path, const std::string& found, const std::string& folder);

/// Convert any bytes to text that is valid in JSON, and back: '%' and bytes beyond ASCII become %XX.
/// bytes_of_json_text() throws BadInput for a % without two digits.
std::string json_text_of_bytes(std::string_view bytes);
std::string bytes_of_json_text(std::string_view text);

/// Returns a number as text with at least six digits: "000012" for 12.
std::string file_number(std::uint64_t number);

/// Renames a file; a file that has the new name is replaced. Throws Failure.
void rename_scratch(const std::string& from, const std::string& to);

/// Returns the CRC-32 (zlib) of a sequence of bytes: first bytes whose checksum is `before`, then `bytes`.
std::uint32_t checksum_of(std::string_view bytes, std::uint32_t before = 0);

}  // namespace rbpa::app
