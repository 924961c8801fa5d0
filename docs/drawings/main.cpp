// What: draws the figures of the pages by running what they show.
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "drawings/figures.h"

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace

int main(int count, char** arguments) {
  const std::string first = count == 2 ? arguments[1] : "";
  const bool asks_for_help = first == "--help" || first == "-h";
  if (first.empty() || first.starts_with('-')) {
    (asks_for_help ? std::cout : std::cerr) << "usage: draw_figures OUTPUT_FOLDER\n";
    return asks_for_help ? 0 : 2;
  }
  try {
    const std::filesystem::path folder = first;
    std::filesystem::create_directories(folder);
    for (const auto group :
         {figures::handle_figures, figures::stellar_figures, figures::front_figures, figures::topology_figures,
          figures::defect_figures, figures::pivoting_figures, figures::candidate_figures, figures::shape_figures,
          figures::hierarchy_figures, figures::filtration_figures, figures::tile_figures, figures::timing_figures,
          figures::cookbook_figures, figures::free_region_figures})
      for (const figures::Figure& figure : group()) write(folder / (std::string(figure.name) + ".svg"), figure.svg());
  } catch (const std::exception& error) {
    std::cerr << "draw_figures: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
