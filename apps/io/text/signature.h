// What: the format of a file by its first bytes, where no name says it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/formats.h"

namespace rbpa::app {

/// The ending that files of its kind have; empty where `bytes` have no signature that is known.
std::string_view ending_of_content(std::string_view bytes);

/// The format of the content of standard input for a use, `otherwise` where it has no signature. Throws BadInput where
/// the format is none of `known`, or nothing is known.
Format format_of_content(Use use, std::string_view bytes, const std::string& name, std::string_view known,
                         std::optional<Format> otherwise);

}  // namespace rbpa::app
