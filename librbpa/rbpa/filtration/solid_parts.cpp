#include "rbpa/filtration/solid_parts.h"

namespace rbpa {

SolidParts::SolidParts(const Mesh& mesh)
    : cells_(face_cells(mesh)),
      gaps_(gaps_of(cells_, mesh.n_vertices())),
      parts_(mesh.n_faces()),
      vertices_(mesh.n_faces()),
      in_(mesh.n_faces()),
      on_(mesh.n_vertices()) {}

}  // namespace rbpa
