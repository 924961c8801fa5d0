// What: reading and writing files of scratch, whose failures are reported in one line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rbpa::app {

/// A file of scratch that is open. Throws Failure "FILE: cannot write: No space left on device", here as below;
/// BadInput where there is something else of that name.
class ScratchFile {
 public:
  enum class Mode { read, write, append, update };  // write begins anew; update writes over what is there
  ScratchFile(const std::string& path, Mode mode);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  /// Behind what was written before. Throws Cancelled after a signal, here as below.
  void write(std::string_view bytes);
  /// How many bytes came; fewer than `size` at the end of the file only.
  std::size_t read(char* to, std::size_t size);
  std::size_t read_at(std::uint64_t offset, char* to, std::size_t size) const;
  std::uint64_t size() const;
  void cut(std::uint64_t size);

 private:
  [[noreturn]] void fail(const char* doing) const;

  std::string path_;
  int descriptor_;
  std::uint64_t position_ = 0;  // of the next that read() returns
};

/// The whole content of a file; empty when there is none.
std::string scratch_content(const std::string& path);

/// The content of the file becomes `bytes`, all at once.
void replace_content(const std::string& path, std::string_view bytes);

/// The same with a checksum behind, which checked_content() verifies and removes. Throws BadInput naming the file when
/// it is wrong; empty when there is no file.
void replace_checked(const std::string& path, std::string_view text);
std::string checked_content(const std::string& path);

/// Throws BadInput: what was found in a file of a run, which has to be begun anew without the folder.
[[noreturn]] void begin_anew(const std::string& path, const std::string& found, const std::string& folder);

/// Bytes as text that is valid in JSON, whatever they are, and back: '%' and what is not ASCII as %XX.
std::string json_text(std::string_view bytes);
std::string bytes_of_json_text(std::string_view text);

/// "000012" of 12: at least six digits.
std::string file_number(std::uint64_t number);

/// A file gets the name of another, which is gone.
void rename_scratch(const std::string& from, const std::string& to);

/// CRC-32, of zlib.
std::uint32_t checksum_of(std::string_view bytes, std::uint32_t before = 0);

}  // namespace rbpa::app
