#include "io/same_file.h"

#include <filesystem>

#include "io/failure.h"

namespace rbpa::app {
namespace {

bool is_regular_file(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

/// Whether two paths are, or will be, the same file. Devices may be shared.
bool same_file(const std::string& a, const std::string& b) {
  if (a == "-" || b == "-") return a == b;
  std::error_code error;
  if (is_regular_file(a) && is_regular_file(b)) return std::filesystem::equivalent(a, b, error) && !error;
  if (std::filesystem::exists(a, error) || std::filesystem::exists(b, error)) return false;
  const auto full = [&](const std::string& path) {  // Made absolute first: what does not exist yet would stay relative.
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  return full(a) == full(b);
}

void require_place(const std::string& path) {
  if (path == "-") return;
  if (path.empty()) throw WrongUsage("found an empty name of a file to write, expected a path");
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw Failure(path + ": found a folder, expected a file to write");
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) return;
  const std::filesystem::file_type type = std::filesystem::status(folder, error).type();
  if (type == std::filesystem::file_type::not_found)
    throw Failure(path + ": found no folder " + in_quotes(folder.string()) + ", expected one to write to");
}

}  // namespace

void require_different(const std::vector<std::string>& outputs, const std::string& input, const std::string& content) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (input != "-" && same_file(outputs[i], input))
      throw WrongUsage(outputs[i] + ": found the file of " + content + ", expected another file to write to");
    for (std::size_t k = 0; k < i; ++k)
      if (same_file(outputs[i], outputs[k]))
        throw WrongUsage(outputs[i] + ": found twice among the files to write, expected once");
  }
  for (const std::string& output : outputs) require_place(output);
}

}  // namespace rbpa::app
