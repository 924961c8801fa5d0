// What: escapes JSON for a <script> element of a page, so that no text in the JSON can end the element.
#pragma once

#include <string>

namespace rbpa::app {

std::string facts_text(std::string json);

}  // namespace rbpa::app
