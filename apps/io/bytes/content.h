// What: gives the bytes of a file in their order, either from memory or by reading the file piece by piece.
// Law:  content in memory and content of a file have one interface. A file that is read piece by piece up to its end is
//       refused if its length or the time of its last change is then not what it was when the file was opened.
// Cost: of a file that is read piece by piece, at most the requested bytes and a mebibyte are in memory. After a skip
//       beyond the bytes in memory of a file that is not compressed, only requested bytes are read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rbpa::app {

/// The size() of a compressed file, which is unknown before the end of the file is decompressed.
constexpr std::size_t unknown_size = std::numeric_limits<std::size_t>::max() / 2;

class Content {
 public:
  /// Views bytes in memory, which must outlive this object and each result of again(). Messages call the bytes `name`.
  Content(std::string_view bytes, std::string name);
  /// Opens the file at `path`. With `decompresses`, decompresses a file that begins like a gzip file. Throws BadInput
  /// unless the file is a regular file, which can be read twice; Failure.
  static Content of_file(const std::string& path, bool decompresses);
  Content(Content&&) noexcept;
  Content& operator=(Content&&) noexcept;
  ~Content();

  /// Returns another reader of this content, at its beginning. Throws as of_file().
  Content again() const;

  /// Returns at least the next `size` bytes, fewer only at the end, and does not skip them. The view is valid until the
  /// next call of ahead(). Throws BadInput, Failure, Cancelled.
  std::string_view ahead(std::size_t size);
  /// Returns the next bytes, as many as are in memory: at least one, unless the end is reached. Throws as ahead(size).
  std::string_view ahead() { return ahead(1); }
  /// Skips `size` bytes, or fewer at the end. Throws as ahead(size).
  void skip(std::uint64_t size);

  const std::string& name() const { return name_; }
  /// Returns the size of the whole content in bytes, or unknown_size if is_compressed().
  std::size_t size() const;
  /// Returns whether the content is decompressed as it is read.
  bool is_compressed() const;
  bool is_in_memory() const { return file_ == nullptr; }
  /// Returns how many bytes of the file were read or skipped so far. In a compressed file, counts compressed bytes.
  std::uint64_t bytes_read() const;

 private:
  struct File;

  std::string name_;
  std::string_view bytes_;         // the next bytes, as far as they are in memory
  std::string_view all_ = {};      // the whole content, if it is in memory
  std::vector<char> buffer_ = {};  // holds bytes_ if a file is read
  bool ended_ = true;              // no bytes of the content follow bytes_
  bool is_sparse_ = false;         // bytes were skipped that were not in memory
  std::unique_ptr<File> file_;     // null if the content is in memory
};

}  // namespace rbpa::app
