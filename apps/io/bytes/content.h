// What: the bytes of a file from its beginning to its end: all of them in memory, or some at a time as they are read.
// Law:  who reads asks for what comes next, and does not know which of the two it is. A file that is read has the length and
//       the time of its last change at its end that it had when it was opened.
// Cost: of a file that is read the requested bytes and a mebibyte are in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rbpa::app {

class Content {
 public:
  /// Bytes in memory, which have to stay there; messages call them `name`.
  Content(std::string_view bytes, std::string name);
  /// The file at `path`, which has to be one that can be read twice. `unpacks`: where it begins as a gzip file does, what it
  /// holds. Throws BadInput.
  static Content of_file(const std::string& path, bool unpacks);
  Content(Content&&) noexcept;
  Content& operator=(Content&&) noexcept;
  ~Content();

  /// The same from its beginning.
  Content again() const;

  /// What comes next: `size` bytes or more, fewer at the end only. It is there until the next call. Throws BadInput, Failure,
  /// Cancelled.
  std::string_view ahead(std::size_t size);
  /// All that is in memory of what comes next, at least a byte unless the end has come.
  std::string_view ahead() { return ahead(1); }
  /// Passes over so many bytes, or to the end.
  void skip(std::uint64_t size);

  const std::string& name() const { return name_; }
  /// Of the whole, or unknown_size where it is being unpacked.
  std::size_t size() const;
  /// Whether it is a file that was packed, of which only its end shows how long it is.
  bool is_packed() const;
  bool is_in_memory() const { return file_ == nullptr; }
  /// Of the file, packed as it is, so far.
  std::uint64_t bytes_read() const;

 private:
  struct File;

  std::string name_;
  std::string_view bytes_;         // ahead, of those in memory
  std::string_view all_ = {};      // where no file is read
  std::vector<char> buffer_ = {};  // what bytes_ are of, where one is
  bool ended_ = true;              // nothing follows bytes_
  std::unique_ptr<File> file_;     // null: all is in memory
};

}  // namespace rbpa::app
