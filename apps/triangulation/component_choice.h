// What: the components of a surface to keep: --keep-largest and --drop-small (both programs), --shell (rbpa surface).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rbpa/space/surface/surface_components.h"

namespace rbpa::app {

enum class ShellChoice { all, outer, largest };

/// The components to keep; by default all.
struct ComponentChoice {
  ShellChoice shell = ShellChoice::all;     ///< for triangles that form closed shells
  std::optional<std::size_t> largest = {};  ///< maximum number of components: those of largest area are kept
  std::size_t least_triangles = 0;
  double least_area = 0;

  bool keeps_all() const { return shell == ShellChoice::all && !largest && least_triangles == 0 && !(least_area > 0); }
};

/// Parse the values of the options. Throw WrongUsage that names the option.
ShellChoice parse_shell(const std::string& text);
std::size_t parse_keep_largest(const std::string& text);
/// Parses --drop-small: "50" is a number of triangles, "area=2.5" an area.
void parse_drop_small(const std::string& text, ComponentChoice& choice);

/// Returns for each component whether it is kept: it is one of the wanted shells, is not too small, and is among the
/// largest of these. `outer` is the result of outer_shells(); it is not used if the choice is all shells.
std::vector<bool> kept_components(const SurfaceComponents& components, const std::vector<bool>& outer,
                                  const ComponentChoice& choice);

}  // namespace rbpa::app
