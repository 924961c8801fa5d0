// What: reads and writes files of scratch. The message of each failure is one line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rbpa::app {

/// An open file of scratch. All members throw Failure, such as "FILE: cannot write: No space left on device"; the
/// constructor throws BadInput if there is something other than a file at the path.
class ScratchFile {
 public:
  enum class Mode { read, write, append, update };  // write: empties the file; update: keeps the rest of it
  ScratchFile(const std::string& path, Mode mode);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  /// Writes after the last written bytes. Throws Cancelled after a signal, as reading does.
  void write(std::string_view bytes);
  /// Read at most `size` bytes to `to`, and return how many: fewer than `size` only at the end of the file. read()
  /// continues after its last byte, read_at() begins at `offset`.
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

/// Returns the whole content of the file at `path`; empty if there is no file. Throws as ScratchFile.
std::string scratch_content(const std::string& path);

/// Replaces the content of the file at `path` by `bytes`, atomically. Throws as ScratchFile.
void replace_content(const std::string& path, std::string_view bytes);

/// Replaces the content, atomically, by `text` and a checksum of it. checked_content() returns the text; it throws
/// BadInput that names the file if the checksum is wrong, and returns an empty text if there is no file.
void replace_checked(const std::string& path, std::string_view text);
std::string checked_content(const std::string& path);

/// Throws BadInput "PATH: found FOUND (remove FOLDER and start again)".
[[noreturn]] void begin_anew(const std::string& path, const std::string& found, const std::string& folder);

/// Convert any bytes to text that is valid in JSON, and back: '%' and bytes beyond ASCII are written as %XX.
std::string json_text_of_bytes(std::string_view bytes);
std::string bytes_of_json_text(std::string_view text);

/// Returns a number with at least six digits: "000012" for 12.
std::string file_number(std::uint64_t number);

/// Renames a file, and replaces a file of the new name. Throws Failure.
void rename_scratch(const std::string& from, const std::string& to);

/// Returns the CRC-32 (zlib) of bytes with the checksum `before`, followed by `bytes`.
std::uint32_t checksum_of(std::string_view bytes, std::uint32_t before = 0);

}  // namespace rbpa::app
