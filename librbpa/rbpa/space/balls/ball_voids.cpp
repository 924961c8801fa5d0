#include "rbpa/space/balls/ball_voids.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/grouped.h"
#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/balls/full/hollows.h"
#include "rbpa/space/balls/full/orthoball.h"
#include "rbpa/space/predicate/outer_faces.h"

namespace rbpa {
namespace {

constexpr std::uint32_t none = RegularTriangulation::none;

/// The triangle of a tetrahedron across from one of its corners.
struct Face {
  std::uint32_t tetrahedron;
  std::uint8_t across;
};

class Finder {
 public:
  Finder(std::span<const Point3> centers, std::span<const double> radii, const RegularTriangulation& regular,
         const BallVoidsOptions& options)
      : centers_(centers),
        radii_(radii),
        regular_(regular),
        go_on_(go_on_of(options.progress, centers.size())),
        threads_(threads_for(centers.size(), options.threads)),
        hollows_(centers, radii, regular, threads_, go_on_),
        faces_(hollows_.faces()),
        is_outside_(regular.simplices.size(), 0) {
    find_outside(options.pockets);
  }

  BallVoids find() {
    std::vector<BallVoid> all = regions();
    const space::RegionMeasures measures = hollows_.measure(region_, all.size(), threads_, go_on_);
    for (const space::RegionShare& share : measures.shares) all[share.region].balls.push_back({share.ball, share.area});
    CheckpointOfThreads checkpoint(go_on_);
    for_each_index(threads_, all.size(), [&](std::size_t i) {
      checkpoint();
      BallVoid& of = all[i];
      of.volume_of_tetrahedra = measures.all[i].tetrahedra;
      of.volume = measures.all[i].volume;
      of.area = measures.all[i].area;
      const std::vector<std::uint32_t> around = corners(of);
      find_mouths(of, around);
      if (of.mouths.empty()) {  // rounding may leave sizes just below 0
        of.volume = std::max(of.volume, 0.0);
        for (LiningBall& ball : of.balls) ball.area = std::max(ball.area, 0.0);
      }
      hollows_.find_largest_ball(of, around, region_);
    });
    return sorted(std::move(all));
  }

 private:
  double unscaled(double value, int degree) const { return hollows_.unscaled(value, degree); }
  std::uint32_t beyond(const Face& face) const { return regular_.neighbors[face.tetrahedron][face.across]; }
  bool is_open(const Face& face) const { return !faces_.has_triangle(face.tetrahedron, face.across); }
  Triangle corners(const Face& face) const {
    return space::outer_face(regular_.simplices[face.tetrahedron], face.across);
  }

  /// Returns whether the orthocenter of a tetrahedron is beyond a face of it.
  bool flows(const Face& face) const {
    const auto [a, b, c] = space::outer_faces[face.across];
    const std::uint32_t t = face.tetrahedron;
    const auto ball = [&](std::size_t k) { return hollows_.ball(t, k); };
    return space::is_conflict(ball(a), ball(b), ball(c), ball(face.across));
  }

  /// Marks the tetrahedra that are connected to infinity through triangles outside of the complex; if `by_flow`, only
  /// tetrahedra that flow to infinity.
  void find_outside(bool by_flow) {
    std::vector<std::uint32_t> found;
    Steps step(go_on_);
    const auto add = [&](const Face& face) {
      step();
      if (is_outside_[face.tetrahedron] != 0 || !is_open(face) || (by_flow && !flows(face))) return;
      is_outside_[face.tetrahedron] = 1;
      found.push_back(face.tetrahedron);
    };
    for (std::uint32_t t = 0; t < regular_.simplices.size(); ++t)
      for (std::uint8_t k = 0; k < 4; ++k)
        if (faces_.is_on_hull(t, k)) add({t, k});
    while (!found.empty()) {
      const std::uint32_t t = found.back();
      found.pop_back();
      for (const std::uint32_t other : regular_.neighbors[t])
        if (other != none)
          for (std::uint8_t k = 0; k < 4; ++k)
            if (regular_.neighbors[other][k] == t) add({other, k});
    }
  }

  /// Returns the regions with their tetrahedra, in the order of the first tetrahedron of each.
  std::vector<BallVoid> regions() {
    const auto count = static_cast<std::uint32_t>(regular_.simplices.size());
    const auto is_in = [&](std::uint32_t t) { return is_outside_[t] == 0 && !faces_.has_tetrahedron(t); };
    meshops::DisjointSets sets(count);
    Steps step(go_on_);
    for (std::uint32_t t = 0; t < count; ++t)
      for (std::uint8_t k = 0; k < 4; ++k) {
        step();
        const std::uint32_t other = regular_.neighbors[t][k];
        if (other != none && t < other && is_in(t) && is_in(other) && is_open({t, k})) sets.join(t, other);
      }
    const space::Grouped groups(count, count, [&](std::uint32_t t) { return is_in(t) ? sets.find(t) : none; });
    region_ = groups.number();
    std::vector<BallVoid> all(groups.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i].tetrahedra.assign(groups.items(i).begin(), groups.items(i).end());
    return all;
  }

  /// Returns the balls at corners of simplices, ascending.
  template <typename Simplices>
  static std::vector<std::uint32_t> corners_of(const Simplices& simplices) {
    std::vector<std::uint32_t> all;
    for (const auto& simplex : simplices) all.insert(all.end(), simplex.begin(), simplex.end());
    sort_unique(all);
    return all;
  }
  static std::vector<std::uint32_t> corners(const BallMouth& of) { return corners_of(of.triangles); }
  std::vector<std::uint32_t> corners(const BallVoid& of) const {
    std::vector<std::array<std::uint32_t, 4>> rows;
    for (const std::uint32_t t : of.tetrahedra) rows.push_back(regular_.simplices[t]);
    return corners_of(rows);
  }

  void find_mouths(BallVoid& of, std::span<const std::uint32_t> around) const {
    std::vector<Face> open;
    for (const std::uint32_t t : of.tetrahedra)
      for (std::uint8_t k = 0; k < 4; ++k)
        if (is_open({t, k}) && (faces_.is_on_hull(t, k) || is_outside_[beyond({t, k})] != 0)) open.push_back({t, k});
    meshops::DisjointSets sets(open.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first_at;  // first triangle at each edge
    for (std::uint32_t i = 0; i < open.size(); ++i) {
      const Triangle triangle = corners(open[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto edge = std::minmax(triangle[k], triangle[(k + 1) % 3]);
        const auto [at, is_new] = first_at.emplace(edge, i);
        if (!is_new && !hollows_.has_edge(edge.first, edge.second)) sets.join(at->second, i);
      }
    }
    const space::Grouped mouths(open.size(), open.size(), [&](std::uint32_t i) { return sets.find(i); });
    for (std::size_t i = 0; i < mouths.size(); ++i) {
      BallMouth& mouth = of.mouths.emplace_back(measured(of, open, mouths.items(i)));
      mouth.radius = std::numeric_limits<double>::infinity();
      for (const std::uint32_t ball : around)
        mouth.radius = std::clamp(space::distance(mouth.center, centers_[ball]) - radii_[ball], 0.0, mouth.radius);
    }
    std::sort(of.mouths.begin(), of.mouths.end(),
              [&](const BallMouth& a, const BallMouth& b) { return is_before(a.power, a, b.power, b); });
  }

  BallMouth measured(const BallVoid& of, std::span<const Face> open, std::span<const std::uint32_t> items) const {
    BallMouth mouth;
    for (const std::uint32_t i : items) {
      const Triangle triangle = from_least(corners(open[i]));
      mouth.triangles.push_back(triangle);
      const space::Slice slice = hollows_.scaled_cells().slice(triangle);
      mouth.area_of_triangles += unscaled(slice.area, 2);
      mouth.area += unscaled(slice.outside, 2);
      mouth.perimeter += unscaled(slice.perimeter, 1);
      const space::Orthoball closing = closing_ball(open[i]);
      if (const double power = unscaled(closing.power, 2); power > mouth.power) {
        mouth.power = power;
        mouth.center = hollows_.unscaled(is_finite(closing.touching.center) ? closing.touching.center : closing.center);
      }
    }
    std::sort(mouth.triangles.begin(), mouth.triangles.end());
    mouth.balls = corners(mouth);
    std::erase_if(mouth.balls, [&](std::uint32_t i) {
      return std::none_of(of.balls.begin(), of.balls.end(), [&](const LiningBall& ball) { return ball.ball == i; });
    });
    return mouth;
  }

  /// Returns the orthoball of the simplex with which a triangle of a mouth comes into the complex: the triangle itself,
  /// or the tetrahedron outside if it flows into the pocket.
  space::Orthoball closing_ball(const Face& face) const {
    const std::uint32_t outside = beyond(face);
    if (outside != none) {
      const auto& back = regular_.neighbors[outside];
      const auto k = std::find(back.begin(), back.end(), face.tetrahedron) - back.begin();
      if (flows({outside, static_cast<std::uint8_t>(k)}))
        return space::orthoball(hollows_.scaled_balls(regular_.simplices[outside]));
    }
    return space::orthoball(hollows_.scaled_balls(corners(face)));
  }

  /// Returns whether an item comes before another one: by descending size, then by the coordinates of its corners.
  template <typename Item>
  bool is_before(double size, const Item& item, double other_size, const Item& other) const {
    if (size != other_size) return size > other_size;
    const auto key = [&](const Item& of) {
      std::vector<Point3> points;
      for (const std::uint32_t i : corners(of)) points.push_back(centers_[i]);
      std::sort(points.begin(), points.end());
      return points;
    };
    return key(item) < key(other);
  }

  BallVoids sorted(std::vector<BallVoid> all) const {
    std::sort(all.begin(), all.end(), [&](const BallVoid& a, const BallVoid& b) {
      return is_before(a.volume_of_tetrahedra, a, b.volume_of_tetrahedra, b);
    });
    BallVoids result;
    for (BallVoid& of : all) {
      if (of.mouths.empty()) {
        result.volume += of.volume;
        result.area += of.area;
      }
      (of.mouths.empty() ? result.voids : result.pockets).push_back(std::move(of));
    }
    return result;
  }

  std::span<const Point3> centers_;
  std::span<const double> radii_;
  const RegularTriangulation& regular_;
  GoOn go_on_;
  Threads threads_;
  space::Hollows hollows_;
  const space::FacesWithin& faces_;
  std::vector<std::uint8_t> is_outside_;
  std::vector<std::uint32_t> region_;  // region of each tetrahedron
};

}  // namespace

BallVoids ball_voids(std::span<const Point3> centers, std::span<const double> radii,
                     const RegularTriangulation& regular, const BallVoidsOptions& options) {
  meshops::require_one_each("ball_voids", radii.size(), "radii", centers.size(), "centers");
  meshops::require(regular.neighbors.size() == regular.simplices.size(),
                   "ball_voids: the triangulation has no neighbors, expected regular_triangulation() with neighbors");
  for (const auto& row : regular.simplices)
    for (const std::uint32_t corner : row)
      meshops::require(corner < centers.size(), "ball_voids: a corner of the triangulation is no ball");
  return Finder(centers, radii, regular, options).find();
}

std::vector<Triangle> boundary_of(const BallVoid& hollow, const RegularTriangulation& regular) {
  std::vector<Triangle> triangles;
  for (const std::uint32_t t : hollow.tetrahedra)
    for (std::size_t k = 0; k < 4; ++k)
      if (!std::binary_search(hollow.tetrahedra.begin(), hollow.tetrahedra.end(), regular.neighbors[t][k]))
        triangles.push_back(space::outer_face(regular.simplices[t], k));
  return triangles;
}

}  // namespace rbpa
