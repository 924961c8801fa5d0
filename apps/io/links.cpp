#include "io/links.h"

#include <filesystem>

#include "io/failure.h"

namespace rbpa::app {

std::string behind_links(const std::string& path) {
  std::filesystem::path at = path;
  for (int links = 0; links <= 40; ++links) {  // as many as Linux follows
    std::error_code error;
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(at, error))) return at.string();
    const std::filesystem::path target = std::filesystem::read_symlink(at, error);
    if (error) return at.string();
    at = at.parent_path() / target;  // the target alone when it is absolute
  }
  throw Failure(path + ": found a loop of symbolic links, expected a file to write");
}

}  // namespace rbpa::app
