// What: parses options that choose components of a surface: --keep-largest and --drop-small of rbpa and meshtopo,
//       --shell of rbpa surface.
#pragma once

#include <cstddef>
#include <string>

#include "rbpa/space/surface/surface_components.h"

namespace rbpa::app {

/// Parse --shell (outer, largest or all) and --keep-largest (a number of components, at least 1). Throw WrongUsage that
/// names the option.
ShellChoice parse_shell(const std::string& text);
std::size_t parse_keep_largest(const std::string& text);
/// Parses --drop-small. "50" sets choice.min_triangles, at least 1; "area=2.5" sets choice.min_area, above 0. Throws
/// WrongUsage and leaves `choice` unchanged for any other text.
void parse_drop_small(const std::string& text, ComponentChoice& choice);

}  // namespace rbpa::app
