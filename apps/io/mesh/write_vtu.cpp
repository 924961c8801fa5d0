#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/write_triangles.h"
#include "io/text/markup.h"

namespace rbpa::app {
namespace {

constexpr std::uint8_t vtk_vertex = 1, vtk_line = 3, vtk_triangle = 5;

/// An array of the appended data: so many bytes at an offset, with their number before them.
struct Block {
  std::uint64_t offset, bytes;

  std::uint64_t end() const { return offset + sizeof(std::uint64_t) + bytes; }
};

void write_array(OutputFile& file, std::string_view type, std::string_view rest, const Block& block) {
  file.write("<DataArray type=\"");
  file.write(type);
  file.write("\" ");
  file.write(rest);
  file.write(" format=\"appended\" offset=\"");
  file.write_number(block.offset);
  file.write("\"/>\n");
}

void write_size(OutputFile& file, const Block& block) {
  file.write_binary(std::span<const std::uint64_t>(&block.bytes, 1));
}

template <typename T>
void write_repeated(OutputFile& file, T value, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) file.write_binary(std::span<const T>(&value, 1));
}

/// Where each of `count` cells of so many corners ends among all corners.
void write_ends(OutputFile& file, std::uint64_t& end, std::uint64_t corners, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    end += corners;
    file.write_binary(std::span<const std::uint64_t>(&end, 1));
  }
}

/// What of features is written.
class CellData {
 public:
  CellData(const TriangleMesh& mesh, std::uint64_t offset) : features_(mesh.features), cells_(mesh.triangles.size()) {
    if (features_ == nullptr) return;
    blocks_.push_back({offset, cells_ * sizeof(std::uint32_t)});
    names_.emplace_back("feature");
    for (const FeatureNumbers& numbers : features_->numbers) {
      const std::string name = markup_escaped(numbers.name);
      std::string unique = name;
      for (int i = 2; std::find(names_.begin(), names_.end(), unique) != names_.end(); ++i)
        unique = name + "_" + std::to_string(i);
      names_.push_back(unique);
      blocks_.push_back({blocks_.back().end(), cells_ * sizeof(double)});
    }
  }

  void declare(OutputFile& file) const {
    if (features_ == nullptr) return;
    file.write("<CellData Scalars=\"feature\">\n");
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      write_array(file, i == 0 ? "UInt32" : "Float64", "Name=\"" + names_[i] + "\"", blocks_[i]);
    file.write("</CellData>\n");
  }

  void append(OutputFile& file) const {
    if (features_ == nullptr) return;
    write_size(file, blocks_[0]);
    file.write_binary(std::span<const std::uint32_t>(features_->of_triangle));
    for (std::size_t i = 1; i < blocks_.size(); ++i) {
      write_size(file, blocks_[i]);
      for (const std::uint32_t feature : features_->of_triangle)
        file.write_binary(features_->numbers[i - 1].values.subspan(feature, 1));
    }
  }

 private:
  const TriangleFeatures* features_;
  std::uint64_t cells_;
  std::vector<Block> blocks_ = {};
  std::vector<std::string> names_ = {};
};

}  // namespace

void write_vtu(OutputFile& file, const TriangleMesh& mesh) {
  const std::uint64_t points = mesh.vertices.size();
  const std::uint64_t cells = mesh.triangles.size() + mesh.edges.size() + mesh.points.size();
  const std::uint64_t corners = 3 * mesh.triangles.size() + 2 * mesh.edges.size() + mesh.points.size();
  const Block positions{0, points * 3 * sizeof(double)};
  const Block connectivity{positions.end(), corners * sizeof(std::uint32_t)};
  const Block ends{connectivity.end(), cells * sizeof(std::uint64_t)};
  const Block types{ends.end(), cells};
  const CellData cell_data(mesh, types.end());

  file.write(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"");
  file.write_number(points);
  file.write("\" NumberOfCells=\"");
  file.write_number(cells);
  file.write("\">\n<Points>\n");
  write_array(file, "Float64", "NumberOfComponents=\"3\"", positions);
  file.write("</Points>\n<Cells>\n");
  write_array(file, "UInt32", "Name=\"connectivity\"", connectivity);
  write_array(file, "UInt64", "Name=\"offsets\"", ends);
  write_array(file, "UInt8", "Name=\"types\"", types);
  file.write("</Cells>\n");
  cell_data.declare(file);
  file.write("</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");

  write_size(file, positions);
  for (const Point& p : mesh.vertices) {
    const std::array<double, 3> position = {p.x, p.y, 0};
    file.write_binary(std::span<const double>(position));
  }
  write_size(file, connectivity);
  for (const Triangle& triangle : mesh.triangles) file.write_binary(std::span<const std::uint32_t>(triangle));
  for (const Edge& edge : mesh.edges) file.write_binary(std::span<const std::uint32_t>(edge));
  file.write_binary(mesh.points);
  write_size(file, ends);
  std::uint64_t end = 0;
  write_ends(file, end, 3, mesh.triangles.size());
  write_ends(file, end, 2, mesh.edges.size());
  write_ends(file, end, 1, mesh.points.size());
  write_size(file, types);
  write_repeated(file, vtk_triangle, mesh.triangles.size());
  write_repeated(file, vtk_line, mesh.edges.size());
  write_repeated(file, vtk_vertex, mesh.points.size());
  cell_data.append(file);
  file.write("\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace rbpa::app
