// Prints how even and how near remeshed meshes are, and the time of it, beside CGAL's isotropic_remeshing() with the
// same sharp edges and the same number of rounds, as a table: meshes of .off files, at three lengths each.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure.h"
#include "bench/options.h"
#include "bench/tables.h"
#include "rbpa/base/mesh.h"
#include "rbpa/space/simplify/remesh.h"

namespace rbpa_bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Point = Kernel::Point_3;
namespace Processing = CGAL::Polygon_mesh_processing;

struct Soup {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Soup read(const std::string& path) {
  std::ifstream file(path);
  std::string magic;
  std::size_t points = 0, triangles = 0, number = 0;
  file >> magic >> points >> triangles >> number;
  Soup soup{std::vector<Point>(points), std::vector<std::array<std::uint32_t, 3>>(triangles)};
  for (Point& p : soup.points) file >> p;
  for (auto& [a, b, c] : soup.triangles) file >> number >> a >> b >> c;
  if (!file || magic != "OFF") throw std::runtime_error(path + ": found no triangles, expected those of an OFF file");
  return soup;
}

CgalMesh cgal_mesh(const Soup& soup) {
  CgalMesh mesh;
  for (const Point& p : soup.points) mesh.add_vertex(p);
  using Vertex = CgalMesh::Vertex_index;
  for (const auto& [a, b, c] : soup.triangles) mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
  return mesh;
}

rbpa::Mesh our_mesh(const Soup& soup) {
  rbpa::Mesh mesh;
  for (const Point& p : soup.points) mesh.add_vertex({p.x(), p.y(), p.z()});
  const auto vertex = [](std::uint32_t v) { return OpenMesh::VertexHandle(static_cast<int>(v)); };
  for (const auto& [a, b, c] : soup.triangles) mesh.add_face(vertex(a), vertex(b), vertex(c));
  return mesh;
}

/// Distances from the triangles of a mesh.
class Distance {
 public:
  explicit Distance(const CgalMesh& mesh) : mesh_(mesh), tree_(faces(mesh).begin(), faces(mesh).end(), mesh_) {}
  /// Returns the greatest distance of a corner, middle of a side or middle of a triangle.
  double greatest(const CgalMesh& other) const {
    double most = 0;
    const auto reach = [&](const Point& p) { most = std::max(most, std::sqrt(tree_.squared_distance(p))); };
    for (const auto f : other.faces()) {
      std::vector<Point> p;
      for (const auto v : vertices_around_face(other.halfedge(f), other)) p.push_back(other.point(v));
      reach(CGAL::centroid(p[0], p[1], p[2]));
      for (std::size_t k = 0; k < 3; ++k) {
        reach(p[k]);
        reach(CGAL::midpoint(p[k], p[(k + 1) % 3]));
      }
    }
    return most;
  }

 private:
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<CgalMesh>;
  const CgalMesh& mesh_;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

/// Returns the cells of a row that tell how even a mesh is.
std::vector<std::string> evenness(const CgalMesh& mesh, double length) {
  std::size_t inner = 0, regular = 0, fitting = 0;
  for (const auto v : mesh.vertices())
    if (!mesh.is_isolated(v) && !mesh.is_border(v)) {
      ++inner;
      regular += mesh.degree(v) == 6;
    }
  for (const auto e : mesh.edges()) {
    const double ratio =
        std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)))) / length;
    fitting += ratio >= 4.0 / 5 && ratio <= 4.0 / 3;
  }
  double least = 180, sum = 0;
  for (const auto f : mesh.faces()) {
    std::vector<Point> p;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh)) p.push_back(mesh.point(v));
    double angle = 180;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto u = p[(k + 1) % 3] - p[k], v = p[(k + 2) % 3] - p[k];
      const double across = std::sqrt(CGAL::cross_product(u, v).squared_length());
      angle = std::min(angle, std::atan2(across, u * v) * 180 / std::numbers::pi);
    }
    least = std::min(least, angle);
    sum += angle;
  }
  const auto share = [](std::size_t part, std::size_t all) {
    return text("%.1f", 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(all, 1)));
  };
  return {text("%u", mesh.number_of_faces()), share(regular, inner), share(fitting, mesh.number_of_edges()),
          text("%.1f", least), text("%.1f", sum / static_cast<double>(mesh.number_of_faces()))};
}

CgalMesh as_cgal(const rbpa::Mesh& mesh) {
  Soup soup;
  for (const auto v : mesh.vertices()) soup.points.emplace_back(mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]);
  for (const auto f : mesh.faces()) {
    auto& corners = soup.triangles.emplace_back();
    std::size_t k = 0;
    for (const auto v : mesh.fv_range(f)) corners[k++] = static_cast<std::uint32_t>(v.idx());
  }
  return cgal_mesh(soup);
}

void compare(const std::string& path, double factor, unsigned rounds, double angle) {
  const Soup soup = read(path);
  const CgalMesh given = cgal_mesh(soup);
  const Distance from_given(given);
  double sum = 0;
  for (const auto e : given.edges())
    sum += std::sqrt(CGAL::squared_distance(given.point(given.vertex(e, 0)), given.point(given.vertex(e, 1))));
  const double length = factor * sum / static_cast<double>(given.number_of_edges());
  const auto report = [&](const char* who, const CgalMesh& made, double seconds) {
    std::vector<std::string> cells = {std::filesystem::path(path).stem().string(), text("%g", factor), who};
    for (std::string& cell : evenness(made, length)) cells.push_back(std::move(cell));
    cells.push_back(text("%.3f", from_given.greatest(made) / length));
    cells.push_back(text("%.3f", Distance(made).greatest(given) / length));
    cells.push_back(text("%.3f", seconds));
    print_row(cells);
  };
  {
    rbpa::Mesh mesh = our_mesh(soup);
    const Stopwatch watch;
    rbpa::remesh(mesh, {.length = length, .rounds = rounds, .sharp_angle = angle});
    const double seconds = watch.processor_seconds();
    report("rbpa", as_cgal(mesh), seconds);
  }
  {
    CgalMesh mesh = given;
    const Stopwatch watch;
    auto is_sharp = mesh.add_property_map<CgalMesh::Edge_index, bool>("e:sharp", false).first;
    Processing::detect_sharp_edges(mesh, angle, is_sharp);
    Processing::isotropic_remeshing(faces(mesh), length, mesh,
                                    Processing::parameters::number_of_iterations(rounds)
                                        .number_of_relaxation_steps(3)
                                        .edge_is_constrained_map(is_sharp)
                                        .protect_constraints(false)
                                        .relax_constraints(true));
    const double seconds = watch.processor_seconds();
    mesh.collect_garbage();
    report("CGAL", mesh, seconds);
  }
}

int run(int argc, char** argv) {
  std::vector<std::string> files;
  int rounds = 10;
  double angle = 60;
  read_options(argc, argv,
               {{"--mesh", &files, "a file in .off, of triangles; once for each mesh"},
                {"--rounds", &rounds, "the rounds of each"},
                {"--angle", &angle, "the angle of sharp edges, in degrees"}});
  std::printf("%s\n\n", machine().c_str());
  print_head({"mesh", "length", "by"}, {"triangles", "six edges %", "4/5 to 4/3 %", "least angle", "mean least angle",
                                        "farthest", "farthest of the given", "processor s"});
  for (const std::string& file : files)
    for (const double factor : {0.5, 1.0, 2.0}) compare(file, factor, static_cast<unsigned>(rounds), angle);
  return 0;
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) { return rbpa_bench::run(argc, argv); }
