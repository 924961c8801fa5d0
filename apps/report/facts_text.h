// What: escapes JSON for a page, so that no text in it can end its element.
#pragma once

#include <string>

namespace rbpa::app {

std::string facts_text(std::string json);

}  // namespace rbpa::app
