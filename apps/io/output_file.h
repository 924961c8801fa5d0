// What: a file that appears whole or not at all.
// Law:  until publish() nothing is seen under its name; without publish() nothing is left behind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rbpa::app {

/// Bytes go to a temporary file in the same folder, which publish() renames. What exists and is not a regular file (a
/// device, a pipe), and "-", standard output, is written directly.
class OutputFile {
 public:
  /// Throws Failure when it cannot be written; Cancelled.
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  void write_number(double value);         ///< shortest text that reads back to it
  void write_number(std::uint64_t value);  ///< decimal text
  /// The value as it lies in memory of a little-endian machine.
  void write_binary(std::uint32_t value);
  void write_binary(double value);

  /// Everything written is on its way to the disk, and no error came up. Call once, before publish().
  void finish();
  /// The file takes its name.
  void publish();

  /// What messages call it.
  const std::string& name() const { return name_; }

 private:
  char* room(std::size_t size);
  void flush();
  [[noreturn]] void fail(const std::string& doing) const;

  std::string name_;
  std::string path_;
  std::string temporary_ = {};  // empty when written directly
  int descriptor_ = -1;
  std::unique_ptr<char[]> buffer_;
  std::size_t used_ = 0;
};

/// The files of one run: all are complete before the first takes its name.
class OutputSet {
 public:
  OutputFile& add(const std::string& path) {
    files_.push_back(std::make_unique<OutputFile>(path));
    return *files_.back();
  }
  void publish() {
    for (const auto& file : files_) file->publish();
  }

 private:
  std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace rbpa::app
