// What: which components of a surface are kept: --keep-largest and --drop-small of both programs, --shell of `rbpa
//       surface`.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rbpa/surface_components.h"

namespace rbpa::app {

enum class ShellChoice { all, outer, largest };

/// All of them, by default.
struct ComponentChoice {
  ShellChoice shell = ShellChoice::all;     ///< where triangles are closed shells
  std::optional<std::size_t> largest = {};  ///< so many, by area
  std::size_t least_triangles = 0;
  double least_area = 0;

  bool keeps_all() const { return shell == ShellChoice::all && !largest && least_triangles == 0 && !(least_area > 0); }
};

/// Throws WrongUsage that names the option.
ShellChoice parse_shell(const std::string& text);
std::size_t parse_keep_largest(const std::string& text);
/// "50": triangles; "area=2.5": an area.
void parse_drop_small(const std::string& text, ComponentChoice& choice);

/// Of each component, whether it is kept: first those of the shells that are wanted, then those that are not too small,
/// then of these the largest. `outer`: of each component, as outer_shells() has it, where the choice is not all shells.
std::vector<bool> kept_components(const SurfaceComponents& components, const std::vector<bool>& outer,
                                  const ComponentChoice& choice);

}  // namespace rbpa::app
