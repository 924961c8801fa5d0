// What: the figures of the pages that only C++ can draw, each by running the operator on a mesh or the method on
//       points.
#pragma once

#include <string>

namespace figures {

std::string glue_join();
std::string glue_split_curve();
std::string glue_handle();
std::string glue_zip();
std::string glue_close();
std::string remove_triangle();
std::string split_edge();
std::string collapse();
std::string front_events();
std::string front_refusals();
std::string pivoting();
std::string tile();

}  // namespace figures
