// What: the figures of the operator pages, each drawn from a mesh on which the operator was run.
#pragma once

#include <span>
#include <string>

namespace figures {

struct Figure {
  const char* name;  ///< of the file, without ending
  std::string (*svg)();
};

std::span<const Figure> handle_figures();
std::span<const Figure> stellar_figures();
std::span<const Figure> front_figures();
std::span<const Figure> topology_figures();
std::span<const Figure> defect_figures();

}  // namespace figures
