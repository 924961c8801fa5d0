// What: recognizes the format of standard input by its first bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/formats.h"

namespace rbpa::app {

/// Returns the usual ending, such as "ply", of files that begin like `bytes`, the whole content; empty if no format is
/// recognized.
std::string_view ending_of_content(std::string_view bytes);

/// Returns the format of `bytes`, the content of standard input, for a use; `otherwise` if no format is recognized.
/// Throws BadInput that names `name` if the recognized format does not have the use or needs GDAL, or if no format is
/// recognized and `otherwise` is absent.
Format format_of_content(Use use, std::string_view bytes, const std::string& name, std::optional<Format> otherwise);

}  // namespace rbpa::app
