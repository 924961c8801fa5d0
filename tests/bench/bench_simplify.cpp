// Prints tables of meshes of .off files. Decimated to 10 %, 1 % and 1,000 of their triangles: how near they are, and
// the time, beside CGAL, OpenMesh and meshoptimizer. With --remesh: how even and how near remeshed meshes are, and the
// time, beside CGAL's isotropic_remeshing() with the same sharp edges and rounds, at three lengths each.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#ifdef RBPA_BENCH_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure.h"
#include "bench/options.h"
#include "bench/tables.h"
#include "rbpa/base/mesh.h"
#include "rbpa/space/simplify/decimate_mesh.h"
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

template <typename Mesh = rbpa::Mesh>
Mesh open_mesh(const Soup& soup) {
  Mesh mesh;
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
    const auto reach = [&](const Point& p) { most = std::max(most, from(p)); };
    for (const auto f : other.faces()) {
      const auto p = corners(other, f);
      reach(CGAL::centroid(p[0], p[1], p[2]));
      for (std::size_t k = 0; k < 3; ++k) {
        reach(p[k]);
        reach(CGAL::midpoint(p[k], p[(k + 1) % 3]));
      }
    }
    return most;
  }
  /// Returns the mean and the greatest distance of corners and of about 200,000 points, which are evenly spread.
  std::array<double, 2> of_samples(const CgalMesh& other) const {
    double area = 0, sum = 0, due = 0, most = 0;
    for (const auto v : other.vertices()) most = std::max(most, from(other.point(v)));
    const auto area_of = [](const auto& p) { return std::sqrt(CGAL::squared_area(p[0], p[1], p[2])); };
    for (const auto f : other.faces()) area += area_of(corners(other, f));
    std::size_t count = 0;
    for (const auto f : other.faces()) {
      const auto p = corners(other, f);
      for (due += 200000 * area_of(p) / area; due > 0; --due, ++count) {
        double u = std::fmod(0.7548776662466927 * static_cast<double>(count), 1),
               v = std::fmod(0.5698402909980532 * static_cast<double>(count), 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const double distance = from(p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]));
        sum += distance;
        most = std::max(most, distance);
      }
    }
    return {sum / static_cast<double>(count), most};
  }

 private:
  double from(const Point& p) const { return std::sqrt(tree_.squared_distance(p)); }
  static std::array<Point, 3> corners(const CgalMesh& mesh, CgalMesh::Face_index f) {
    const auto h = mesh.halfedge(f);
    return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))};
  }
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

template <typename Mesh>
CgalMesh as_cgal(const Mesh& mesh) {
  Soup soup;
  for (const auto v : mesh.vertices()) soup.points.emplace_back(mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]);
  for (const auto f : mesh.faces()) {
    auto& corners = soup.triangles.emplace_back();
    std::size_t k = 0;
    for (const auto v : mesh.fv_range(f)) corners[k++] = static_cast<std::uint32_t>(v.idx());
  }
  return cgal_mesh(soup);
}

void compare_remeshings(const std::string& path, double factor, unsigned rounds, double angle) {
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
    rbpa::Mesh mesh = open_mesh(soup);
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

/// A way to decimate: returns the mesh with at most so many triangles, and the processor time.
struct Decimator {
  const char* name;
  std::function<std::pair<CgalMesh, double>(const Soup&, std::size_t)> run;
};

std::pair<CgalMesh, double> decimated_by_rbpa(const Soup& soup, std::size_t faces) {
  rbpa::Mesh mesh = open_mesh(soup);
  meshops::request_status(mesh);
  const Stopwatch watch;
  std::vector<rbpa::Point3> places = rbpa::places_of(mesh);
  rbpa::decimate(mesh, places, {.faces = faces});
  for (const auto v : mesh.vertices()) {
    const rbpa::Point3& p = places[static_cast<std::size_t>(v.idx())];
    mesh.set_point(v, {p.x, p.y, p.z});
  }
  const double seconds = watch.processor_seconds();
  mesh.garbage_collection();
  return {as_cgal(mesh), seconds};
}

std::pair<CgalMesh, double> decimated_by_cgal(const Soup& soup, std::size_t faces) {
  namespace Simplification = CGAL::Surface_mesh_simplification;
  CgalMesh mesh = cgal_mesh(soup);
  const Stopwatch watch;
  using Policies = Simplification::GarlandHeckbert_plane_policies<CgalMesh, Kernel>;
  const Policies policies(mesh);
  const Simplification::Bounded_normal_change_placement<Policies::Get_placement> placement(policies.get_placement());
  // It counts edges: as many go as there would be if the share of triangles and edges stayed.
  const Simplification::Count_stop_predicate<CgalMesh> stop(mesh.number_of_edges() * faces / mesh.number_of_faces());
  Simplification::edge_collapse(mesh, stop, CGAL::parameters::get_cost(policies.get_cost()).get_placement(placement));
  const double seconds = watch.processor_seconds();
  mesh.collect_garbage();
  return {std::move(mesh), seconds};
}

std::pair<CgalMesh, double> decimated_by_openmesh(const Soup& soup, std::size_t faces) {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
  Mesh mesh = open_mesh<Mesh>(soup);
  mesh.request_face_normals();
  const Stopwatch watch;
  mesh.update_face_normals();
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();
  decimater.initialize();
  decimater.decimate_to_faces(0, faces);
  const double seconds = watch.processor_seconds();
  mesh.garbage_collection();
  return {as_cgal(mesh), seconds};
}

#ifdef RBPA_BENCH_MESHOPTIMIZER
std::pair<CgalMesh, double> decimated_by_meshoptimizer(const Soup& soup, std::size_t faces) {
  std::vector<std::array<float, 3>> points;
  for (const Point& p : soup.points)
    points.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
  Soup left{soup.points, soup.triangles};
  const Stopwatch watch;
  const std::size_t corners =
      meshopt_simplify(left.triangles[0].data(), soup.triangles[0].data(), 3 * soup.triangles.size(), points[0].data(),
                       points.size(), sizeof(points[0]), 3 * faces, 1e30F, 0, nullptr);
  const double seconds = watch.processor_seconds();
  left.triangles.resize(corners / 3);
  CgalMesh mesh = cgal_mesh(left);
  for (const auto v : mesh.vertices())
    if (mesh.is_isolated(v)) mesh.remove_vertex(v);
  mesh.collect_garbage();
  return {std::move(mesh), seconds};
}
#endif

const std::vector<Decimator> decimators = {
    {"rbpa", decimated_by_rbpa},
    {"CGAL", decimated_by_cgal},
    {"OpenMesh", decimated_by_openmesh},
#ifdef RBPA_BENCH_MESHOPTIMIZER
    {"meshoptimizer", decimated_by_meshoptimizer},
#endif
};

void compare_decimations(const std::string& path) {
  const Soup soup = read(path);
  const CgalMesh given = cgal_mesh(soup);
  const Distance from_given(given);
  const CGAL::Bbox_3 box = CGAL::bbox_3(soup.points.begin(), soup.points.end());
  const double size = std::hypot(box.x_span(), box.y_span(), box.z_span());
  for (const auto& [left, faces] : {std::pair("10 %", soup.triangles.size() / 10),
                                    {"1 %", soup.triangles.size() / 100},
                                    {"1,000", std::size_t{1000}}}) {
    if (faces > soup.triangles.size() / 2) continue;
    std::vector<double> least(decimators.size(), INFINITY);
    std::vector<CgalMesh> made(decimators.size());
    for (int round = 0; round < 5; ++round)
      for (std::size_t i = 0; i < decimators.size(); ++i) {
        auto [mesh, seconds] = decimators[i].run(soup, faces);
        least[i] = std::min(least[i], seconds);
        made[i] = std::move(mesh);
      }
    std::vector<std::string> cells = {std::filesystem::path(path).stem().string(), left};
    for (std::size_t i = 0; i < decimators.size(); ++i) {
      const auto [mean, most] = from_given.of_samples(made[i]);
      const auto [mean_back, most_back] = Distance(made[i]).of_samples(given);
      const auto collapses = static_cast<double>(given.number_of_vertices() - made[i].number_of_vertices());
      cells.push_back(text("%u: %.2f, %.1f; %.2f", made[i].number_of_faces(), (mean + mean_back) / 2 / size * 1000,
                           std::max(most, most_back) / size * 1000, least[i] * 1e6 / collapses));
    }
    print_row(cells);
  }
}

int run(int argc, char** argv) {
  std::vector<std::string> files;
  int rounds = 10;
  double angle = 60;
  bool is_remeshing = false;
  read_options(argc, argv,
               {{"--mesh", &files, "a file in .off, of triangles; once for each mesh"},
                {"--remesh", &is_remeshing, "remesh in place of decimating"},
                {"--rounds", &rounds, "the rounds of each remeshing"},
                {"--angle", &angle, "the angle of sharp edges of a remeshing, in degrees"}});
  std::printf("%s\n\n", machine().c_str());
  if (!is_remeshing) {
    std::printf("Triangles: mean, greatest distance in thousandths of the diagonal; microseconds a collapse.\n\n");
    print_head({"mesh", "left"}, columns({}, decimators));
    for (const std::string& file : files) compare_decimations(file);
    return 0;
  }
  print_head({"mesh", "length", "by"}, {"triangles", "six edges %", "4/5 to 4/3 %", "least angle", "mean least angle",
                                        "farthest", "farthest of the given", "processor s"});
  for (const std::string& file : files)
    for (const double factor : {0.5, 1.0, 2.0}) compare_remeshings(file, factor, static_cast<unsigned>(rounds), angle);
  return 0;
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) { return rbpa_bench::run(argc, argv); }
