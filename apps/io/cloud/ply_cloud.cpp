#include <algorithm>
#include <utility>

#include "io/cloud/element_cloud.h"

namespace rbpa::app {
namespace {

/// Returns the layout of points: the properties of a vertex that are columns.
PointLayout lay_out(const PlyHeader& header, const CloudRequest& request, const std::string& name) {
  const PlyElement& vertex = vertices_of(header, name);
  PointLayout layout{.element = static_cast<std::size_t>(&vertex - header.elements.data())};
  constexpr std::string_view axes[] = {"x", "y", "z"}, channels[] = {"red", "green", "blue"};
  for (std::size_t k = 0; k < (request.in_space ? 3 : 2); ++k)
    layout.columns.emplace_back(k, find_number(vertex, axes[k], request.in_space ? "x, y and z" : "x and y", name));
  if (request.in_space) {
    lay_out_normal(vertex, {"nx", "ny", "nz"}, layout);
    const std::vector<std::size_t> color = number_places(vertex, channels);
    const bool bytes = std::all_of(color.begin(), color.end(),
                                   [&](std::size_t place) { return vertex.properties[place].type == Scalar::uint8; });
    if (color.size() == 3 && bytes) {
      layout.facts.colors = Channels::bytes;
      for (std::size_t k = 0; k < 3; ++k) layout.columns.emplace_back(CloudBlock::color + k, color[k]);
    } else if (!color.empty()) {
      layout.facts.file.warnings.emplace_back(
          "colors are left out, as red, green and blue are not three of type uchar");
    }
  } else {
    layout.height = number_place(vertex, "z");
  }
  return layout;
}

std::unique_ptr<Cloud> open_ply(Content content, const CloudRequest& request) {
  PlyHeader header = read_ply_header(content.ahead(), content.name());
  PointLayout layout = lay_out(header, request, content.name());
  return open_elements(std::move(content), std::move(header), std::move(layout), request);
}

}  // namespace

/// Reads the element "vertex" of PLY: x, y, z; nx, ny, nz if all three are there; and red, green, blue (of type uchar)
/// if all three are there. Ignores everything else, but checks that a binary file has it, so that a truncated file is
/// refused.
const CloudFormat ply_reader = {.open = open_ply, .fields = names_of_properties, .skips_invalid = true};

}  // namespace rbpa::app
