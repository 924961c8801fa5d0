// What: draws figures of the pages by running what they show.
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

#include "drawings/figures.h"

namespace {

/// Files without their ending, and what draws them.
constexpr std::pair<const char*, std::string (*)()> all[] = {
    {"handle_glue_join", figures::glue_join},     {"handle_glue_split_curve", figures::glue_split_curve},
    {"handle_glue_handle", figures::glue_handle}, {"handle_glue_zip", figures::glue_zip},
    {"handle_glue_close", figures::glue_close},   {"handle_remove_triangle", figures::remove_triangle},
    {"stellar_split_edge", figures::split_edge},  {"stellar_collapse", figures::collapse},
    {"front_events", figures::front_events},      {"front_refusals", figures::front_refusals},
    {"paper_2_pivoting", figures::pivoting},      {"tile", figures::tile}};

}  // namespace

int main(int count, char** arguments) {
  const std::string folder = count == 2 ? arguments[1] : "";
  const bool asks_for_help = folder == "--help" || folder == "-h";
  if (folder.empty() || folder.starts_with('-')) {
    (asks_for_help ? std::cout : std::cerr) << "usage: draw_figures OUTPUT_FOLDER\n";
    return asks_for_help ? 0 : 2;
  }
  try {
    std::filesystem::create_directories(folder);
    for (const auto& [name, svg] : all) {
      const std::string file = folder + "/" + name + ".svg", text = svg();
      std::ofstream out(file, std::ios::binary);
      out << text;
      out.close();
      if (!out) throw std::runtime_error(file + ": cannot be written");
    }
  } catch (const std::exception& error) {
    std::cerr << "draw_figures: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
