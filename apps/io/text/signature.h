// What: recognizes the format of standard input, and of a file that cannot be read as its name says, by its first
//       bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/failure.h"
#include "io/formats.h"
#include "io/text/odd_fields.h"

namespace rbpa::app {

/// Returns the usual ending, such as "ply", of files that begin like `bytes`, the whole content; empty if no format is
/// recognized.
std::string_view ending_of_content(std::string_view bytes);

/// Returns the format of `bytes`, the content of standard input, for a use; `otherwise` if no format is recognized.
/// Throws BadInput that names `name` if the recognized format does not have the use or needs GDAL, or if no format is
/// recognized and `otherwise` is absent.
Format format_of_content(Use use, std::string_view bytes, const std::string& name, std::optional<Format> otherwise);

/// Returns "the content is that of a file .ply: --format ply" if `bytes`, read as `format`, are recognized as those of
/// another format with the use; otherwise an empty text.
std::string way_by_content(Use use, Format format, std::string_view bytes);

/// Returns read(). Throws what read() throws, a BadInput with way_by_content() unless it names a format already.
template <typename Read>
auto reading_as(Use use, Format format, std::string_view bytes, Read read) {
  try {
    return read();
  } catch (const BadInput& refusal) {
    const std::string_view message = refusal.what();
    const std::string way = way_by_content(use, format, bytes);
    if (way.empty() || message.find("--format") != std::string_view::npos) throw;
    throw BadInput(with_way(std::string(message), way));
  }
}

}  // namespace rbpa::app
