#include "rbpa/space/repair/refining/filling_patch.h"

#include <algorithm>

#include <Eigen/SparseCholesky>

#include "meshops/stellar/flip.h"
#include "meshops/stellar/split_face.h"
#include "rbpa/space/surface/surface_mesh.h"

namespace rbpa::space {
namespace {

/// Solves a sparse system of linear equations between places by least squares. Cost: about n^1.5 for n places on a
/// surface.
class LeastSquares {
 public:
  explicit LeastSquares(std::size_t places) : places_(places) {}

  /// Begins another equation: the terms added next sum up to `known`.
  void add_equation(const Vector& known) { known_.push_back(known); }
  /// Adds the term factor · place to the last equation.
  void add(std::uint32_t place, double factor) {
    entries_.push_back({static_cast<std::uint32_t>(known_.size()) - 1, place, factor});
  }

  /// Returns the places; nothing if the equations do not determine them.
  std::optional<std::vector<Vector>> solution() const {
    using Matrix = Eigen::SparseMatrix<double>;
    std::vector<Eigen::Triplet<double>> entries;
    for (const Entry& e : entries_) entries.emplace_back(static_cast<int>(e.row), static_cast<int>(e.column), e.factor);
    Matrix rows(static_cast<Eigen::Index>(known_.size()), static_cast<Eigen::Index>(places_));
    rows.setFromTriplets(entries.begin(), entries.end());
    Eigen::MatrixX3d known(static_cast<Eigen::Index>(known_.size()), 3);
    for (std::size_t i = 0; i < known_.size(); ++i) {
      const Vector& v = known_[i];
      known.row(static_cast<Eigen::Index>(i)) << v.x, v.y, v.z;
    }
    const Matrix square = rows.transpose() * rows;
    const Eigen::SimplicialLDLT<Matrix> solver(square);
    if (solver.info() != Eigen::Success) return std::nullopt;
    const Eigen::MatrixX3d found = solver.solve(rows.transpose() * known);
    if (solver.info() != Eigen::Success || !found.allFinite()) return std::nullopt;
    std::vector<Vector> places;
    for (Eigen::Index i = 0; i < found.rows(); ++i) places.push_back({found(i, 0), found(i, 1), found(i, 2)});
    return places;
  }

 private:
  struct Entry {
    std::uint32_t row, column;
    double factor;
  };

  std::size_t places_;
  std::vector<Entry> entries_;
  std::vector<Vector> known_;
};

/// Returns the unit normal of the triangle's plane; 0 if the triangle has no area.
Vector unit_normal(const Vector& a, const Vector& b, const Vector& c) {
  const Vector n = cross(minus(b, a), minus(c, a));
  const double size = length(n);
  return size > 0 ? Vector{n.x / size, n.y / size, n.z / size} : Vector{0, 0, 0};
}

std::pair<std::uint32_t, std::uint32_t> key_of(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

SurfaceMesh mesh_of(const FillingRim& rim) {
  std::vector<Point3> points;
  for (const Vector& place : rim.places) points.push_back({place.x, place.y, place.z});
  return surface_mesh(points, rim.triangles);
}

}  // namespace

FillingPatch::FillingPatch(const FillingRim& rim) : rim_(rim), scales_(rim.scales), edges_(rim.edges) {
  SurfaceMesh made = mesh_of(rim);
  mesh_ = std::move(made.mesh);
  names_ = std::move(made.input_index);
  for (const auto e : mesh_.edges()) {
    const Halfedge h = mesh_.halfedge_handle(e, 0);
    edges_.insert(key_of(name(mesh_.from_vertex_handle(h)), name(mesh_.to_vertex_handle(h))));
  }
}

Vector FillingPatch::at(Vertex v) const {
  const auto& p = mesh_.point(v);
  return {p[0], p[1], p[2]};
}

std::array<Vector, 3> FillingPatch::corners(Mesh::FaceHandle f) const {
  std::array<Vector, 3> corners{};
  std::size_t k = 0;
  for (const auto v : mesh_.fv_range(f)) corners[k++] = at(v);
  return corners;
}

Vector FillingPatch::place(std::size_t added) const {
  return at(Vertex(static_cast<int>(mesh_.n_vertices() - between_.size() + added)));
}

void FillingPatch::refine(std::size_t most, meshops::Steps& step) {
  flip_all(step);
  while (between_.size() < most && split_large(step)) flip_all(step);
}

/// Splits the triangles that are large at the time of the call. Returns whether there were any.
bool FillingPatch::split_large(meshops::Steps& step) {
  bool has_split = false;
  const std::size_t count = mesh_.n_faces();
  for (std::size_t f = 0; f < count; ++f) {
    step();
    const Mesh::FaceHandle face(static_cast<int>(f));
    if (!is_large(face)) continue;
    std::array<std::uint32_t, 3> corners{};
    double scale = 0;
    std::size_t k = 0;
    for (const auto v : mesh_.fv_range(face)) {
      corners[k++] = name(v);
      scale += scales_[name(v)] / 3;
    }
    std::sort(corners.begin(), corners.end());
    meshops::split_face(mesh_, face);
    const auto added = static_cast<std::uint32_t>(rim_.places.size() + between_.size());
    for (const std::uint32_t corner : corners) edges_.insert({corner, added});
    names_.push_back(added);
    scales_.push_back(scale);
    between_.push_back(corners);
    has_split = true;
  }
  return has_split;
}

/// Returns whether the distance of the triangle's centroid to each corner is large relative to the edges at the corner
/// and to the edges wanted in the middle.
bool FillingPatch::is_large(Mesh::FaceHandle f) const {
  std::array<Vector, 3> corners{};
  std::array<double, 3> scales{};
  std::size_t k = 0;
  for (const auto v : mesh_.fv_range(f)) {
    corners[k] = at(v);
    scales[k++] = scales_[name(v)];
  }
  const auto& [a, b, c] = corners;
  const Vector middle = {a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3, a.z / 3 + b.z / 3 + c.z / 3};
  const double scale = scales[0] / 3 + scales[1] / 3 + scales[2] / 3;
  for (k = 0; k < 3; ++k) {
    const double distance = std::sqrt(2.0) * length(minus(corners[k], middle));
    if (distance <= scale || distance <= scales[k]) return false;
  }
  return true;
}

void FillingPatch::flip_all(meshops::Steps& step) {
  // In space, flips need not terminate; in a patch without great turns they end long before this limit.
  std::size_t left = 20 * mesh_.n_edges();
  std::vector<Edge> waiting;
  for (std::size_t e = mesh_.n_edges(); e-- > 0;) waiting.emplace_back(static_cast<int>(e));
  while (!waiting.empty() && left > 0) {
    const Edge e = waiting.back();
    waiting.pop_back();
    step(4);
    if (!is_better_flipped(e)) continue;
    --left;
    const Halfedge h = mesh_.halfedge_handle(e, 0);
    edges_.erase(key_of(name(mesh_.from_vertex_handle(h)), name(mesh_.to_vertex_handle(h))));
    meshops::flip(mesh_, e);
    edges_.insert(key_of(name(mesh_.from_vertex_handle(h)), name(mesh_.to_vertex_handle(h))));
    for (const unsigned side : {0U, 1U}) {
      const Halfedge half = mesh_.halfedge_handle(e, side);
      waiting.push_back(mesh_.edge_handle(mesh_.next_halfedge_handle(half)));
      waiting.push_back(mesh_.edge_handle(mesh_.prev_halfedge_handle(half)));
    }
  }
}

/// Returns whether the edge should be flipped: the angles across from it sum to more than 180 degrees, and the flipped
/// edge does not exist yet and folds nothing.
bool FillingPatch::is_better_flipped(Edge e) const {
  if (mesh_.is_boundary(e)) return false;
  const Halfedge h = mesh_.halfedge_handle(e, 0);
  const Vertex from = mesh_.from_vertex_handle(h), to = mesh_.to_vertex_handle(h);
  const Vertex left = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h));
  const Vertex right = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(h)));
  if (edges_.contains(key_of(name(left), name(right))) || meshops::flip_blocker(mesh_, e)) return false;
  const Vector a = at(from), b = at(to), c = at(left), d = at(right);
  const Vector ca = minus(a, c), cb = minus(b, c), da = minus(a, d), db = minus(b, d);
  const double sine_c = length(cross(ca, cb)), sine_d = length(cross(da, db));
  constexpr double clearly = 0x1p-40;
  if (!(dot(ca, cb) * sine_d + dot(da, db) * sine_c < -clearly * sine_c * sine_d)) return false;
  const Vector old_left = unit_normal(a, b, c), old_right = unit_normal(b, a, d);
  const Vector mean = {old_left.x + old_right.x, old_left.y + old_right.y, old_left.z + old_right.z};
  const Vector new_from = unit_normal(d, c, a), new_to = unit_normal(c, d, b);
  return dot(new_from, mean) > 0 && dot(new_to, mean) > 0 && dot(new_from, new_to) > 0;
}

/// Returns twice the mean curvature wanted at each numbered vertex: the given one, cut to most_bend(), where the rim
/// has one, and harmonic elsewhere. Returns nothing if the equations do not determine the curvature.
std::optional<std::vector<double>> FillingPatch::bends() const {
  std::vector<double> bends(rim_.places.size() + between_.size(), 0);
  const std::optional<double> most = most_bend();
  if (!most || std::none_of(rim_.bend.begin(), rim_.bend.end(), [](const auto& bend) { return bend.has_value(); }))
    return bends;
  std::vector<std::uint32_t> number(bends.size(), Surface::none);  // for each vertex number, the number of its unknown
  std::uint32_t count = 0;
  for (std::size_t name = 0; name < bends.size(); ++name) {
    if (name < rim_.bend.size() && rim_.bend[name])
      bends[name] = std::clamp(*rim_.bend[name], -*most, *most);
    else
      number[name] = count++;
  }
  std::vector<std::vector<std::uint32_t>> around(bends.size());
  for (const auto e : mesh_.edges()) {
    const Halfedge h = mesh_.halfedge_handle(e, 0);
    const std::uint32_t from = name(mesh_.from_vertex_handle(h)), to = name(mesh_.to_vertex_handle(h));
    around[from].push_back(to);
    around[to].push_back(from);
  }
  LeastSquares equations(count);
  for (std::size_t name = 0; name < bends.size(); ++name) {
    if (number[name] == Surface::none) continue;
    double known = 0;
    for (const std::uint32_t other : around[name])
      if (number[other] == Surface::none) known += bends[other];
    equations.add_equation({known, 0, 0});
    equations.add(number[name], static_cast<double>(around[name].size()));
    for (const std::uint32_t other : around[name])
      if (number[other] != Surface::none) equations.add(number[other], -1);
  }
  const auto found = equations.solution();
  if (!found) return std::nullopt;
  for (std::size_t name = 0; name < bends.size(); ++name)
    if (number[name] != Surface::none) bends[name] = (*found)[number[name]].x;
  return bends;
}

/// Returns the greatest bend that a surface with this rim can have everywhere: that of half a ball over the rim.
std::optional<double> FillingPatch::most_bend() const {
  double area = 0, around = 0;
  for (const auto f : mesh_.faces()) {
    const auto [a, b, c] = corners(f);
    area += length(cross(minus(b, a), minus(c, a))) / 2;
  }
  for (const auto e : mesh_.edges()) {
    const Halfedge h = mesh_.halfedge_handle(e, 0);
    if (mesh_.is_boundary(e)) around += length(minus(at(mesh_.to_vertex_handle(h)), at(mesh_.from_vertex_handle(h))));
  }
  if (!(area > 0) || !(around > 0)) return std::nullopt;
  return around / area;  // for a circle it is 2 / r
}

bool FillingPatch::make_smooth(meshops::Steps& step) {
  constexpr int rounds = 20;  // each uses the weights and normals of the round before
  constexpr double still = 0x1p-10;
  const auto wanted = bends();
  if (!wanted) return false;
  double scale = 0;
  for (const double of : scales_)
    if (std::isfinite(of)) scale = std::max(scale, of);
  bool has_moved = false;
  double farthest = 0;
  for (int round = 0; round < rounds; ++round) {
    if (!bend_like(*wanted, step, farthest)) return has_moved;
    has_moved = true;
    flip_all(step);
    if (farthest <= still * scale) break;
  }
  return has_moved;
}

/// Does one round: moves the added vertices to where the curvature is as wanted, by the current weights and normals,
/// and sets `farthest` to the longest move. Returns false, and moves nothing, if the equations determine no places.
bool FillingPatch::bend_like(const std::vector<double>& bends, meshops::Steps& step, double& farthest) {
  const std::size_t rim = rim_.places.size();
  std::vector<FanCurvature> fans(bends.size());
  std::copy(rim_.outside.begin(), rim_.outside.end(), fans.begin());
  struct Weight {
    std::uint32_t other;
    double factor;
  };
  std::vector<std::vector<Weight>> weights(bends.size());
  std::vector<Vector> places(bends.size());
  for (const auto v : mesh_.vertices()) places[name(v)] = at(v);
  for (const auto f : mesh_.faces()) {
    std::array<std::uint32_t, 3> t{};
    std::size_t k = 0;
    for (const auto v : mesh_.fv_range(f)) t[k++] = name(v);
    for (k = 0; k < 3; ++k) {
      const std::uint32_t v = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      const CornerWeights of(places[v], places[a], places[b]);
      weights[v].push_back({a, of.to_a});
      weights[v].push_back({b, of.to_b});
      fans[v].normal = plus(fans[v].normal, of.normal);
      fans[v].area += of.area;
    }
  }
  LeastSquares equations(between_.size());
  for (std::uint32_t v = 0; v < bends.size(); ++v) {
    if (v < rim && !rim_.is_inner[v]) continue;
    const double size = length(fans[v].normal), area = fans[v].area;
    if (!(area > 0) || !(size > 0)) continue;
    const double factor = 1 / std::sqrt(area);
    Vector known = minus(times(area * bends[v] / size, fans[v].normal), fans[v].sum);
    double own = 0;
    for (const Weight& w : weights[v]) {
      own += w.factor;
      if (w.other < rim) known = minus(known, times(w.factor, places[w.other]));
    }
    if (v < rim) known = plus(known, times(own, places[v]));
    equations.add_equation(times(factor, known));
    for (const Weight& w : weights[v])
      if (w.other >= rim) equations.add(w.other - static_cast<std::uint32_t>(rim), factor * w.factor);
    if (v >= rim) equations.add(v - static_cast<std::uint32_t>(rim), -factor * own);
    step(16);
  }
  const auto found = equations.solution();
  if (!found) return false;
  farthest = 0;
  const std::size_t first = mesh_.n_vertices() - between_.size();
  for (std::size_t k = 0; k < found->size(); ++k) {
    const Vector& p = (*found)[k];
    farthest = std::max(farthest, length(minus(p, places[rim + k])));
    mesh_.set_point(Vertex(static_cast<int>(first + k)), {p.x, p.y, p.z});
  }
  step(64 * found->size());
  return true;
}

std::vector<std::array<std::uint32_t, 3>> FillingPatch::triangles() const {
  std::vector<std::array<std::uint32_t, 3>> all;
  for (const auto f : mesh_.faces()) {
    auto& corners = all.emplace_back();
    std::size_t k = 0;
    for (const auto v : mesh_.fv_range(f)) corners[k++] = name(v);
  }
  return all;
}

bool FillingPatch::is_degenerate() const {
  for (const auto f : mesh_.faces()) {
    const auto [a, b, c] = corners(f);
    const Vector normal = unit_normal(a, b, c);
    if (!(dot(normal, normal) > 0)) return true;
  }
  return false;
}

}  // namespace rbpa::space
