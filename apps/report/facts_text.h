// What: escapes JSON for a <script> element of a page.
#pragma once

#include <string>

namespace rbpa::app {

/// Returns the JSON with \u003c in place of each '<', so that no text in it can end the element.
std::string facts_text(std::string json);

}  // namespace rbpa::app
