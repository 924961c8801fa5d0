// What: the format of standard input by its first bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/formats.h"

namespace rbpa::app {

/// Returns the usual ending of files with the signature that `bytes` begin with; empty if the signature is unknown.
std::string_view ending_of_content(std::string_view bytes);

/// Returns the format of the content of standard input for a use; `otherwise` if it has no known signature. Throws
/// BadInput if the format has not this use, or if it is unknown and `otherwise` is absent.
Format format_of_content(Use use, std::string_view bytes, const std::string& name, std::optional<Format> otherwise);

}  // namespace rbpa::app
