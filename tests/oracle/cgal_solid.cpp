#include "oracle/cgal_solid.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <fstream>
#include <stdexcept>

namespace rbpa_test {

CgalSolid cgal_solid(const std::string& path) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  std::ifstream file(path);
  if (!CGAL::IO::read_OFF(file, mesh)) throw std::runtime_error(path + ": CGAL reads no surface mesh");
  namespace processing = CGAL::Polygon_mesh_processing;
  CgalSolid solid{.faces = mesh.number_of_faces(),
                  .closed = CGAL::is_closed(mesh),
                  .crosses_itself = processing::does_self_intersect(mesh)};
  solid.bounds_a_volume = solid.closed && !solid.crosses_itself && processing::does_bound_a_volume(mesh);
  return solid;
}

}  // namespace rbpa_test
