// What: whether a run would write what it reads, one file twice, or where there is no place for a file.
#pragma once

#include <string>
#include <vector>

namespace rbpa::app {

/// Throws WrongUsage when two of `outputs` are, or will be, the same file, or one is `input`, the file of `content`.
/// Devices may be shared; "-" among the outputs is standard output, and as input standard input, both taken for the
/// file that they were redirected to.
/// Throws WrongUsage when a name is empty, and Failure when it has no folder or is one, or is a loop of symbolic links:
/// before a long run, not after it.
void require_different(const std::vector<std::string>& outputs, const std::string& input, const std::string& content);

}  // namespace rbpa::app
