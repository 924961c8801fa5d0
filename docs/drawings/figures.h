// What: the figures of the pages, each drawn after running the operator on a mesh or the method on points.
#pragma once

#include <span>
#include <string>

namespace figures {

struct Figure {
  const char* name;  ///< name of the file, without its ending
  std::string (*svg)();
};

std::span<const Figure> handle_figures();
std::span<const Figure> stellar_figures();
std::span<const Figure> front_figures();
std::span<const Figure> topology_figures();
std::span<const Figure> defect_figures();
std::span<const Figure> pivoting_figures();
std::span<const Figure> candidate_figures();
std::span<const Figure> shape_figures();
std::span<const Figure> hierarchy_figures();
std::span<const Figure> filtration_figures();
std::span<const Figure> tile_figures();
std::span<const Figure> free_region_figures();
std::span<const Figure> timing_figures();
std::span<const Figure> cookbook_figures();

}  // namespace figures
