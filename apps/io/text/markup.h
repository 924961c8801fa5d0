// What: text for XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace rbpa::app {

/// Returns the text with & < > " as entities, for elements and attributes. Control characters, which XML forbids,
/// become spaces.
std::string markup_escaped(std::string_view text);

}  // namespace rbpa::app
