// What: whether a run would write what it reads, or one file twice.
#pragma once

#include <string>
#include <vector>

namespace rbpa::app {

/// Throws WrongUsage when two of `outputs` are, or will be, the same file, or one is `input`, the file of `content`.
/// Devices may be shared; "-" among the outputs is standard output, and as input standard input.
void require_different(const std::vector<std::string>& outputs, const std::string& input, const std::string& content);

}  // namespace rbpa::app
