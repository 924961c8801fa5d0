#include "io/read_mesh.h"

#include <limits>

#include "io/failure.h"
#include "io/gunzip.h"
#include "io/input_bytes.h"
#include "io/obj_mesh.h"
#include "io/off_header.h"
#include "io/off_mesh.h"
#include "io/ply_data.h"
#include "io/ply_mesh.h"
#include "io/stl_mesh.h"

namespace rbpa::app {
namespace {

MeshFile parse(MeshFormat format, std::string_view bytes, const std::string& name) {
  switch (format) {
    case MeshFormat::off:
      return read_off_mesh(bytes, name);
    case MeshFormat::ply:
      return read_ply_mesh(bytes, name);
    case MeshFormat::obj:
      return read_obj_mesh(bytes, name);
    case MeshFormat::stl:
      break;
  }
  return read_stl_mesh(bytes, name);
}

Claim claim_of(MeshFormat format) {
  switch (format) {
    case MeshFormat::off:
      return {claimed_off_size};
    case MeshFormat::ply:
      return {claimed_ply_size};
    case MeshFormat::stl:
      return {claimed_stl_size};
    case MeshFormat::obj:
      break;
  }
  return {};
}

}  // namespace

MeshFile read_mesh(const MeshSource& source) {
  InputBytes input(source.path, "a mesh file");
  if (is_gzip(input.bytes())) input.gunzip(claim_of(source.format));
  return mesh_in(input.bytes(), input.name(), source.format);
}

MeshFile mesh_in(std::string_view bytes, const std::string& name, MeshFormat format) {
  // A mesh without faces may be meant; no bytes at all come from a command that failed before.
  if (bytes.empty()) bad_input(name, "an empty file", "a mesh");
  MeshFile mesh = parse(format, bytes, name);
  // A halfedge mesh numbers its elements with int, and a soup its corners with 32 bits.
  constexpr std::size_t most = std::numeric_limits<int>::max() / 2;
  if (mesh.positions.size() > most || mesh.soup.corners.size() > most)
    bad_input(name, counted(mesh.positions.size(), "point") + " and " + counted(mesh.soup.corners.size(), "corner"),
              "at most " + std::to_string(most) + " of each");
  mesh.soup.points = mesh.positions.size();
  return mesh;
}

}  // namespace rbpa::app
