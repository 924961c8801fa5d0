// What: the file behind symbolic links.
#pragma once

#include <string>

namespace rbpa::app {

/// Where `path` leads: its own file, or through one symbolic link after the other to the last, which need not exist. So a
/// file that takes its name by being renamed does not replace a link. Throws Failure naming a loop.
std::string behind_links(const std::string& path);

}  // namespace rbpa::app
