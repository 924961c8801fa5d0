// Ball pivoting in space, after Bernardini, Mittleman, Rushmeier, Silva and Taubin (1999), as a policy of the advancing
// front: points with normals on a torus become a closed surface of genus 1. Copy and change it. It decides with rounded
// numbers; rbpa::surface() decides exactly, and has the same triangles where no decision is close.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <random>

#include "meshops/front/engine.h"
#include "meshops/topology/report.h"
#include "rbpa/space/surface.h"

using meshops::Front;
using meshops::Halfedge;
using meshops::Site;
using Vec = OpenMesh::Vec3d;

struct Sample {
  Vec point, normal;
};

/// A ball of one radius rolls over the points, from edge to edge.
class BallPivoting {
 public:
  BallPivoting(const std::vector<Sample>& samples, double radius) : samples_(samples), radius_(radius) {
    for (Site s = 0; s < samples.size(); ++s) grid_[cell(samples[s].point)].push_back(s);
  }

  /// Three points on which an empty ball rests, the first of them free.
  std::optional<std::array<Site, 3>> seed(const Front& front) {
    for (; next_ < samples_.size(); ++next_) {
      if (!front.is_free(next_)) continue;
      const std::vector<Site> near = near_to(at(next_));
      for (const Site b : near)
        for (const Site c : near) {
          if (!faces_outward(next_, b, c)) continue;
          if (const auto o = centre(next_, b, c); o && is_empty(*o, {next_, b, c})) return std::array{next_, b, c};
        }
    }
    return std::nullopt;
  }

  /// The ball rests on the triangle behind h, and rolls over h until it touches a point: the one with the least turn.
  std::optional<Site> propose(const Front& front, Halfedge h) const {
    const Site a = front.from_site(h), b = front.to_site(h);
    const Halfedge behind = front.mesh().opposite_halfedge_handle(h);
    const Site c = front.to_site(front.mesh().next_halfedge_handle(behind));
    const auto start = centre(b, a, c);
    if (!start) return std::nullopt;
    const Vec middle = (at(a) + at(b)) / 2, along = (at(b) - at(a)).normalized();
    const Vec u = *start - middle, v = u % along;
    double least = 2 * std::numbers::pi;
    std::optional<Site> touched;
    for (const Site p : near_to(middle)) {
      const auto end = p == c ? std::nullopt : centre(a, b, p);
      if (!end) continue;
      double turn = std::atan2((*end - middle) | v, (*end - middle) | u);
      if (turn < 0) turn += 2 * std::numbers::pi;
      if (turn >= least) continue;
      least = turn;
      touched = p;
    }
    return touched && faces_outward(a, b, *touched) ? touched : std::nullopt;
  }

 private:
  const Vec& at(Site s) const { return samples_[s].point; }

  /// The normal of the triangle agrees with those of its corners.
  bool faces_outward(Site a, Site b, Site c) const {
    const Vec n = (at(b) - at(a)) % (at(c) - at(a));
    return (n | samples_[a].normal) > 0 && (n | samples_[b].normal) > 0 && (n | samples_[c].normal) > 0;
  }

  /// Of the ball that touches the three, on the side from which they are counter-clockwise; none when they are too far
  /// apart for it.
  std::optional<Vec> centre(Site a, Site b, Site c) const {
    const Vec p = at(b) - at(a), q = at(c) - at(a), n = p % q;
    if (n.sqrnorm() == 0) return std::nullopt;
    const Vec to_circumcentre = ((n % p) * q.sqrnorm() + (q % n) * p.sqrnorm()) / (2 * n.sqrnorm());
    const double height = radius_ * radius_ - to_circumcentre.sqrnorm();
    if (height < 0) return std::nullopt;
    return at(a) + to_circumcentre + n * std::sqrt(height / n.sqrnorm());
  }

  bool is_empty(const Vec& centre, const std::array<Site, 3>& corners) const {
    for (const Site s : near_to(centre))
      if (std::ranges::count(corners, s) == 0 && (at(s) - centre).sqrnorm() < radius_ * radius_) return false;
    return true;
  }

  /// All points within two radii, and some more.
  std::vector<Site> near_to(const Vec& p) const {
    std::vector<Site> near;
    const auto [x, y, z] = cell(p);
    for (int i = x - 1; i <= x + 1; ++i)
      for (int j = y - 1; j <= y + 1; ++j)
        for (int k = z - 1; k <= z + 1; ++k)
          if (const auto found = grid_.find({i, j, k}); found != grid_.end())
            near.insert(near.end(), found->second.begin(), found->second.end());
    return near;
  }
  std::array<int, 3> cell(const Vec& p) const {
    const auto index = [&](double x) { return static_cast<int>(std::floor(x / (2 * radius_))); };
    return {index(p[0]), index(p[1]), index(p[2])};
  }

  const std::vector<Sample>& samples_;
  double radius_;
  std::map<std::array<int, 3>, std::vector<Site>> grid_;  // cells two radii wide
  Site next_ = 0;
};

/// Points on a torus, none nearer to another than `distance`.
std::vector<Sample> torus(double distance) {
  std::mt19937 random(1999);
  const auto angle = [&] { return 2 * std::numbers::pi * static_cast<double>(random()) / 0x1p32; };
  std::vector<Sample> samples;
  for (int i = 0; i < 60'000; ++i) {
    const double around = angle(), tube = angle();
    const Vec out(std::cos(around), std::sin(around), 0), normal = out * std::cos(tube) + Vec(0, 0, std::sin(tube));
    const Vec point = out + 0.4 * normal;
    const auto is_near = [&](const Sample& s) { return (s.point - point).norm() < distance; };
    if (std::ranges::none_of(samples, is_near)) samples.push_back({point, normal});
  }
  return samples;
}

/// The triangles of the mesh, each from its smallest site on, in order.
std::vector<std::array<Site, 3>> triangles(const OpenMesh::TriMesh_ArrayKernelT<>& mesh,
                                           const std::vector<Site>& site) {
  std::vector<std::array<Site, 3>> found;
  for (const meshops::Face f : mesh.faces()) {
    auto corner = mesh.cfv_ccwbegin(f);
    std::array<Site, 3> t;
    for (Site& s : t) s = site[static_cast<std::size_t>((corner++)->idx())];
    std::ranges::rotate(t, std::ranges::min_element(t));
    found.push_back(t);
  }
  std::ranges::sort(found);
  return found;
}

int main() {
  const double distance = 0.07;
  const std::vector<Sample> samples = torus(distance);
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  Front front(mesh, samples.size());
  BallPivoting policy(samples, 1.2 * distance);
  struct Refusals : meshops::FrontVisitor {
    std::size_t count = 0;
    void refused(const Front&, Halfedge, const meshops::Refusal&) { ++count; }
  } refusals;
  meshops::advance(front, policy, refusals);
  const std::vector<Site> site = front.finish();
  for (std::size_t v = 0; v < site.size(); ++v)
    mesh.set_point(meshops::Vertex(static_cast<int>(v)),
                   OpenMesh::vector_cast<OpenMesh::Vec3f>(samples[site[v]].point));
  const meshops::TopologyReport topology = meshops::report(mesh, site);
  std::cout << samples.size() << " points, " << topology.faces << " triangles, " << topology.components
            << " component, " << topology.boundary_curves << " boundary curves, genus " << *topology.genus << ", "
            << refusals.count << " proposals refused\n";

  std::vector<rbpa::Point3> points, normals;
  for (const Sample& s : samples) {
    points.push_back({s.point[0], s.point[1], s.point[2]});
    normals.push_back({s.normal[0], s.normal[1], s.normal[2]});
  }
  const bool same = triangles(mesh, site) == rbpa::surface(points, normals, 1.2 * distance).triangles;
  std::cout << (same ? "the same triangles as rbpa::surface()\n" : "other triangles than rbpa::surface()\n");
}
