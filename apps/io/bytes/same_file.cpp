#include "io/bytes/same_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <optional>

#include "io/failure.h"
#include "io/formats.h"
#include "io/words.h"

namespace rbpa::app {

std::string behind_links(const std::string& path) {
  std::filesystem::path at = path;
  for (int links = 0; links <= 40; ++links) {  // Linux follows at most 40
    std::error_code error;
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(at, error))) return at.string();
    const std::filesystem::path target = std::filesystem::read_symlink(at, error);
    if (error) return at.string();
    at = at.parent_path() / target;  // the target alone when it is absolute
  }
  throw Failure(path + ": found a loop or more than 40 symbolic links, expected a file to write");
}

namespace {

namespace fs = std::filesystem;

/// A file that a run reads or writes: a path, or "-" for the standard stream number `stream`.
struct Place {
  const std::string& path;
  int stream;

  bool is_stream() const { return path == "-"; }
  std::string name() const {
    return !is_stream() ? path : stream == STDIN_FILENO ? "standard input" : "standard output";
  }
  /// Returns the status of the file; nothing if it does not exist yet.
  std::optional<struct stat> status() const {
    struct stat found {};
    const int failed = is_stream() ? fstat(stream, &found) : stat(path.c_str(), &found);
    return failed == 0 ? std::optional(found) : std::nullopt;
  }
  /// Returns the path of the file in one canonical form, also if the file does not exist yet.
  fs::path full() const {
    std::error_code error;  // Make it absolute first: the path of a file that does not exist yet would remain relative.
    return fs::weakly_canonical(fs::absolute(behind_links(path), error), error);
  }
};

/// Returns whether two places are, or will be, the same regular file or the same stream.
bool same_file(const Place& a, const Place& b) {
  if (a.is_stream() && b.is_stream() && a.stream == b.stream) return true;
  const auto one = a.status(), other = b.status();
  if (one && other) return S_ISREG(one->st_mode) && one->st_dev == other->st_dev && one->st_ino == other->st_ino;
  return !one && !other && !a.is_stream() && !b.is_stream() && a.full() == b.full();
}

void require_place(const std::string& path) {
  if (path == "-") return;
  std::error_code error;
  if (fs::is_directory(path, error)) throw Failure(path + ": found a folder, expected a file to write");
  if (fs::exists(path, error)) return;
  const fs::path folder = fs::path(behind_links(path)).parent_path();
  if (folder.empty()) return;
  if (fs::status(folder, error).type() == fs::file_type::not_found)
    throw Failure(path + ": found no folder " + in_quotes(folder.string()) + ", expected one to write to");
}

}  // namespace

std::optional<std::string> world_file_of(const std::string& path) {
  if (!same_letters(ending(path), "png")) return std::nullopt;
  return path.substr(0, path.size() - 2) + (path.ends_with('G') ? "GW" : "gw");
}

void require_different(const std::vector<std::string>& outputs, const std::string& input, const std::string& content) {
  for (const std::string& output : outputs)
    if (output.empty()) bad_usage("-o, or another option with a file to write", "an empty name", "a path");
  std::vector<std::string> all = outputs;
  for (const std::string& output : outputs)
    if (const auto world = world_file_of(output)) all.push_back(*world);
  const Place read{input, STDIN_FILENO};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Place written{all[i], STDOUT_FILENO};
    if (same_file(written, read)) bad_usage(written.name(), "the file of " + content, "another file to write to");
    for (std::size_t k = 0; k < i; ++k)
      if (same_file(written, {all[k], STDOUT_FILENO}))
        bad_usage(written.name(), "twice among the files to write", "once");
  }
  for (const std::string& output : all) require_place(output);
}

}  // namespace rbpa::app
