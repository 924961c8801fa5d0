// What: the file behind a path; whether a run would write what it reads, one file twice, or where there is no place.
#pragma once

#include <string>
#include <vector>

namespace rbpa::app {

/// Where `path` leads: its own file, or through one symbolic link after the other to the last, which need not exist. So a
/// file that takes its name by being renamed does not replace a link. Throws Failure naming a loop.
std::string behind_links(const std::string& path);

/// Throws WrongUsage when two of `outputs` are, or will be, the same file, or one is `input`, the file of `content`.
/// Devices may be shared; "-" among the outputs is standard output, and as input standard input, both taken for the
/// file that they were redirected to.
/// Throws WrongUsage when a name is empty, and Failure when it has no folder or is one, or is a loop of symbolic links:
/// before a long run, not after it.
void require_different(const std::vector<std::string>& outputs, const std::string& input, const std::string& content);

}  // namespace rbpa::app
