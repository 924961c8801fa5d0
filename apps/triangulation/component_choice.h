// What: parses the components of a surface to keep: --keep-largest and --drop-small (both programs), --shell (rbpa
//       surface).
#pragma once

#include <cstddef>
#include <string>

#include "rbpa/space/surface/surface_components.h"

namespace rbpa::app {

/// Parse --shell: outer, largest or all; and --keep-largest: a number of components, at least 1. Throw WrongUsage that
/// names the option.
ShellChoice parse_shell(const std::string& text);
std::size_t parse_keep_largest(const std::string& text);
/// Parses --drop-small: "50", at least 1, sets choice.min_triangles; "area=2.5", above 0, sets choice.min_area. Throws
/// WrongUsage, and leaves `choice` unchanged.
void parse_drop_small(const std::string& text, ComponentChoice& choice);

}  // namespace rbpa::app
