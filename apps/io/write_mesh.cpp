#include "io/write_mesh.h"

#include "io/polygon_files.h"

namespace rbpa::app {
namespace {

struct SoupPolygons {
  std::span<const std::array<double, 3>> positions;
  const meshops::PolygonSoup& soup;

  std::size_t points() const { return positions.size(); }
  std::size_t faces() const { return soup.faces(); }
  const std::array<double, 3>& point(std::size_t i) const { return positions[i]; }
  std::span<const std::uint32_t> face(std::size_t f) const { return soup.face(f); }
};

}  // namespace

void write_mesh(OutputFile& file, MeshFormat format, std::span<const std::array<double, 3>> positions,
                const meshops::PolygonSoup& soup) {
  const SoupPolygons mesh{positions, soup};
  switch (format) {
    case MeshFormat::off:
      return write_off(file, mesh);
    case MeshFormat::ply:
      return write_ply(file, mesh);
    case MeshFormat::obj:
      return write_obj(file, mesh);
    case MeshFormat::stl:
      break;
  }
}

}  // namespace rbpa::app
