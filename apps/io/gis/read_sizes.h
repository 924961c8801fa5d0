// What: sizes at points, from lines of text.
#pragma once

#include <string>
#include <vector>

#include "rbpa/fill.h"

namespace rbpa::app {

/// Three numbers a line, x, y and size, with blanks, commas, semicolons or tabs between them; blank lines and those that
/// begin with # are passed over, and so is a first line of names. `path` may be "-". Throws BadInput naming the line;
/// Failure; Cancelled.
std::vector<SizeAt> read_sizes(const std::string& path);

}  // namespace rbpa::app
