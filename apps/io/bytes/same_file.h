// What: the file behind a path; refuses runs that would overwrite their input, write one file twice, or write into a
//       folder that does not exist.
#pragma once

#include <string>
#include <vector>

namespace rbpa::app {

/// Follows symbolic links and returns the path of the file behind them, which need not exist. Renaming a file to that
/// path replaces the file and not a link. Throws Failure for a loop of links.
std::string behind_links(const std::string& path);

/// Checks the names of output files before a long run. Throws WrongUsage if a name is empty, if two of `outputs` are,
/// or will be, the same file, or if one is `input`, the file of `content`; Failure if a name is a folder, its folder
/// does not exist, or it is a loop of symbolic links. Devices may be shared. "-" is standard output among `outputs` and
/// standard input as `input`; both stand for the file that they are redirected to.
void require_different(const std::vector<std::string>& outputs, const std::string& input, const std::string& content);

}  // namespace rbpa::app
