#include "rbpa/space/repair/refine_filling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "meshops/core/progress.h"
#include "rbpa/base/arrays/simplices_at.h"
#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/cells/box_scale.h"
#include "rbpa/space/cells/box_tree.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/repair/closing/links_of_triangles.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/repair/refining/filling_patch.h"
#include "rbpa/space/surface/split_fans.h"

namespace rbpa {
namespace {

using Indices = std::vector<std::uint32_t>;
using space::FillingPatch;
using space::FillingRim;
using space::Vector;

/// The stage of refinement of a patch: with moved points, with added points in place, or without added points.
enum class Stage : std::uint8_t { coarse, flat, smooth };

/// A patch at one stage. Vertices of the rim have the lower numbers.
struct Refined {
  std::vector<Point3> points;
  std::vector<Triangle> between, triangles;
};

struct Patch {
  Indices triangles;  // triangles of the patch, by their numbers in the surface
  Indices rim;        // vertices of the patch, sorted by place
  std::optional<Refined> smooth, flat;
  Stage stage = Stage::coarse;

  const Refined& now() const { return stage == Stage::smooth ? *smooth : *flat; }
  void lower() { stage = stage == Stage::smooth && flat ? Stage::flat : Stage::coarse; }
};

/// The triangles at each vertex of a surface, and marks of the vertices that triangles surround.
class Fans {
 public:
  Fans(std::span<const Point3> points, const Surface& surface, const GoOn& go_on)
      : surface_(surface), fans_(split_fans(surface, go_on)) {
    for (const std::uint32_t point : fans_.point) {
      meshops::require(point < points.size(), "refine_filling: the surface has a corner that is not a point");
      places_.push_back(points[point]);
    }
    at_ = TrianglesAt(fans_.triangles, size());
    is_inner_.assign(size(), true);
    for (std::uint32_t t = 0; t < fans_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const Triangle& corners = fans_.triangles[t];
        if (surface.neighbors[t][k] == Surface::none)
          is_inner_[corners[(k + 1) % 3]] = is_inner_[corners[(k + 2) % 3]] = false;
      }
  }

  std::size_t size() const { return fans_.point.size(); }
  const Triangle& corners(std::uint32_t t) const { return fans_.triangles[t]; }
  const Triangle& neighbors(std::uint32_t t) const { return surface_.neighbors[t]; }
  const Point3& place(std::uint32_t v) const { return places_[v]; }
  const Indices& points() const { return fans_.point; }
  bool is_inner(std::uint32_t v) const { return is_inner_[v]; }
  std::span<const std::uint32_t> triangles_at(std::uint32_t v) const { return at_[v]; }

 private:
  const Surface& surface_;
  SplitFans fans_;
  std::vector<Point3> places_;
  TrianglesAt at_;
  std::vector<bool> is_inner_;
};

double distance(const Vector& u, const Vector& v) {
  const Vector d = {u.x - v.x, u.y - v.y, u.z - v.z};
  return std::sqrt(dot(d, d));
}

/// The input for the refinement of a patch. It depends on places, not on numbers.
class PatchInput {
 public:
  PatchInput(const Fans& fans, const Patch& patch, const std::vector<bool>& is_new, meshops::Steps& step)
      : fans_(fans), patch_(patch), scale_(scale_of(fans, patch)) {
    for (std::uint32_t i = 0; i < patch.rim.size(); ++i) {
      number_.emplace(patch.rim[i], i);
      rim_.places.push_back(scale_.place(fans.place(patch.rim[i])));
      rim_.is_inner.push_back(fans.is_inner(patch.rim[i]));
    }
    take_triangles(step);
    for (const std::uint32_t v : patch.rim) {
      step(64);
      take_outside(v, is_new);
      rim_.bend.push_back(bend_outside(v));
    }
  }

  const FillingRim& rim() const { return rim_; }

  Refined result_of(const FillingPatch& refined) const {
    Refined result;
    for (std::size_t k = 0; k < refined.added(); ++k) result.points.push_back(scale_.point(refined.place(k)));
    result.between = refined.between();
    result.triangles = refined.triangles();
    return result;
  }

 private:
  static space::BoxScale scale_of(const Fans& fans, const Patch& patch) {
    space::Box box;
    for (const std::uint32_t v : patch.rim)
      for (const std::uint32_t t : fans.triangles_at(v))
        for (const std::uint32_t w : fans.corners(t)) box.include(fans.place(w));
    return {box.low, box.high};
  }

  void take_triangles(meshops::Steps& step) {
    std::vector<Triangle> rows;
    for (const std::uint32_t t : patch_.triangles) {
      Triangle& row = rows.emplace_back(fans_.corners(t));
      for (std::uint32_t& v : row) v = number_.at(v);
    }
    Indices same(patch_.rim.size());
    for (std::uint32_t i = 0; i < same.size(); ++i) same[i] = i;
    space::LinkedTriangles linked = space::linked_triangles(rows, same, step);
    rim_.triangles.triangles = std::move(linked.triangles);
    rim_.triangles.neighbors = std::move(linked.neighbors);
  }

  /// Adds to rim_ the values at v outside of the patch: curvature, edges to other rim vertices, mean length of edges.
  void take_outside(std::uint32_t v, const std::vector<bool>& is_new) {
    Indices around, outside;
    for (const std::uint32_t t : fans_.triangles_at(v)) {
      if (is_new[t] && std::binary_search(patch_.triangles.begin(), patch_.triangles.end(), t)) continue;
      outside.push_back(t);
      for (const std::uint32_t w : fans_.corners(t))
        if (w != v) around.push_back(w);
    }
    sort_unique(around);
    rim_.outside.push_back(curvature_at(v, outside));
    const Vector place = rim_.places[number_.at(v)];
    std::vector<double> lengths;
    for (const std::uint32_t w : around) {
      lengths.push_back(distance(place, scale_.place(fans_.place(w))));
      if (const auto other = number_.find(w); other != number_.end())
        rim_.edges.insert(std::minmax(number_.at(v), other->second));
    }
    std::sort(lengths.begin(), lengths.end());
    double sum = 0;
    for (const double length : lengths) sum += length;
    rim_.scales.push_back(lengths.empty() ? std::numeric_limits<double>::infinity()
                                          : sum / static_cast<double>(lengths.size()));
  }

  /// Returns the curvature of `triangles` at v, summed in an order that does not depend on triangle numbers.
  space::FanCurvature curvature_at(std::uint32_t v, std::span<const std::uint32_t> triangles) const {
    std::vector<std::pair<Point3, Point3>> across;
    for (const std::uint32_t t : triangles) {
      const Triangle& corners = fans_.corners(t);
      const auto k = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
      across.emplace_back(fans_.place(corners[(k + 1) % 3]), fans_.place(corners[(k + 2) % 3]));
    }
    std::sort(across.begin(), across.end());
    space::FanCurvature fan;
    for (const auto& [a, b] : across) fan.add(scale_.place(fans_.place(v)), scale_.place(a), scale_.place(b));
    return fan;
  }

  /// Returns twice the mean curvature over the two rings of vertices next to rim vertex v. Only vertices count that
  /// triangles surround, none of them in the patch. Returns nothing if no vertex counts.
  std::optional<double> bend_outside(std::uint32_t v) const {
    const auto neighbors_of = [&](const Indices& of) {
      Indices others;
      for (const std::uint32_t u : of)
        for (const std::uint32_t t : fans_.triangles_at(u))
          for (const std::uint32_t w : fans_.corners(t))
            if (fans_.is_inner(w) && !number_.contains(w)) others.push_back(w);
      sort_unique(others);
      return others;
    };
    Indices rings = neighbors_of({v});
    for (const std::uint32_t w : neighbors_of(rings)) rings.push_back(w);
    sort_unique(rings);
    std::vector<std::pair<Point3, std::uint32_t>> by_place;
    for (const std::uint32_t w : rings) by_place.emplace_back(fans_.place(w), w);
    std::sort(by_place.begin(), by_place.end());
    double bend = 0, area = 0;
    for (const auto& [place, w] : by_place) {
      const space::FanCurvature fan = curvature_at(w, fans_.triangles_at(w));
      bend += fan.bend();
      area += fan.area;
    }
    if (!(area > 0)) return std::nullopt;
    return bend / area;
  }

  const Fans& fans_;
  const Patch& patch_;
  space::BoxScale scale_;
  std::map<std::uint32_t, std::uint32_t> number_;  // for each vertex: its number in the patch
  FillingRim rim_;
};

class Refining {
 public:
  Refining(std::span<const Point3> points, const Surface& surface, const std::vector<bool>& is_new,
           const SurfaceOptions& options)
      : points_(points),
        surface_(surface),
        is_new_(is_new),
        options_(options),
        go_on_(go_on_of(options.progress, points.size(), surface.triangles.size())),
        fans_(points, surface, go_on_) {}

  RefinedSurface run() {
    find_patches();
    refine();
    for (;;) {
      RefinedSurface result = assembled();
      if (!lower_crossing(result)) return result;
    }
  }

 private:
  /// Finds the patches: the connected components of the new triangles, in the order of their places.
  void find_patches() {
    meshops::DisjointSets connected(surface_.triangles.size());
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      for (const std::uint32_t other : fans_.neighbors(t))
        if (is_new_[t] && other != Surface::none && is_new_[other]) connected.join(t, other);
    std::map<std::uint32_t, Indices> sets;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      if (is_new_[t]) sets[connected.find(t)].push_back(t);
    const auto is_before = [&](std::uint32_t v, std::uint32_t w) { return fans_.place(v) < fans_.place(w); };
    for (auto& [first, triangles] : sets) {
      Patch& patch = patches_.emplace_back();
      patch.triangles = std::move(triangles);
      for (const std::uint32_t t : patch.triangles)
        patch.rim.insert(patch.rim.end(), fans_.corners(t).begin(), fans_.corners(t).end());
      sort_unique(patch.rim);
      std::sort(patch.rim.begin(), patch.rim.end(), is_before);
    }
    std::sort(patches_.begin(), patches_.end(), [&](const Patch& a, const Patch& b) {
      return std::lexicographical_compare(a.rim.begin(), a.rim.end(), b.rim.begin(), b.rim.end(), is_before);
    });
  }

  void refine() {
    Threads threads(options_.threads);
    std::mutex one_call;
    for_each_index(threads, patches_.size(), [&](std::size_t i) {
      const GoOn go_on = [&] {
        const std::lock_guard<std::mutex> lock(one_call);
        return !go_on_ || go_on_();
      };
      stop_if_cancelled(go_on);
      meshops::Steps step(go_on);
      refine(patches_[i], step);
    });
  }

  void refine(Patch& patch, meshops::Steps& step) const {
    constexpr std::size_t most = std::size_t{1} << 20U;  // number of added points at which refining a patch stops
    // A filling with two vertices at one place is not a disk with distinct corners.
    const auto is_same = [&](std::uint32_t v, std::uint32_t w) { return fans_.place(v) == fans_.place(w); };
    if (std::adjacent_find(patch.rim.begin(), patch.rim.end(), is_same) != patch.rim.end()) return;
    const PatchInput input(fans_, patch, is_new_, step);
    FillingPatch refined(input.rim());
    refined.refine(most, step);
    if (refined.added() == 0) return;
    if (!refined.is_degenerate()) {
      patch.flat = input.result_of(refined);
      patch.stage = Stage::flat;
    }
    if (!refined.make_smooth(step) || refined.is_degenerate()) return;
    patch.smooth = input.result_of(refined);
    patch.stage = Stage::smooth;
  }

  RefinedSurface assembled() {
    meshops::Steps step(go_on_);
    RefinedSurface result;
    std::vector<Triangle> triangles;
    Indices point = fans_.points();
    patch_of_.clear();
    const auto add = [&](const Triangle& triangle, std::uint32_t patch) {
      triangles.push_back(triangle);
      patch_of_.push_back(patch);
    };
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      if (!is_new_[t]) add(fans_.corners(t), no_patch);
    for (std::uint32_t i = 0; i < patches_.size(); ++i) {
      const Patch& patch = patches_[i];
      ++(patch.stage == Stage::smooth ? result.smooth : patch.stage == Stage::flat ? result.flat : result.coarse);
      if (patch.stage == Stage::coarse) {
        for (const std::uint32_t t : patch.triangles) add(fans_.corners(t), i);
        continue;
      }
      const Refined& refined = patch.now();
      Indices vertices = patch.rim;
      for (std::size_t k = 0; k < refined.points.size(); ++k) {
        vertices.push_back(static_cast<std::uint32_t>(point.size()));
        point.push_back(static_cast<std::uint32_t>(points_.size() + result.points.size()));
        Triangle& between = result.between.emplace_back(refined.between[k]);
        for (std::uint32_t& v : between) v = point[vertices[v]];
        result.points.push_back(refined.points[k]);
      }
      for (Triangle triangle : refined.triangles) {
        for (std::uint32_t& v : triangle) v = vertices[v];
        add(triangle, i);
      }
    }
    meshops::require(point.size() < std::size_t{1} << 31U,
                     "refine_filling: there would be 2^31 points or more, expected fewer (refine fewer fillings)");
    space::LinkedTriangles linked = space::linked_triangles(triangles, point, step);
    result.surface.triangles = std::move(linked.triangles);
    result.surface.neighbors = std::move(linked.neighbors);
    result.surface.duplicates = surface_.duplicates;
    result.surface.distinct = surface_.distinct + result.points.size();
    Indices patch_of;
    for (const std::uint32_t t : linked.order) patch_of.push_back(patch_of_[t]);
    patch_of_ = std::move(patch_of);
    for (const std::uint32_t patch : patch_of_) result.is_new.push_back(patch != no_patch);
    return result;
  }

  /// Lowers the stage of each patch that crosses another triangle. Returns whether a stage was lowered.
  bool lower_crossing(const RefinedSurface& result) {
    std::vector<Point3> all(points_.begin(), points_.end());
    all.insert(all.end(), result.points.begin(), result.points.end());
    std::vector<bool> crosses(patches_.size(), false);
    for (const auto& [t, u] : crossing_triangles(all, result.surface.triangles, all_of_them, options_))
      for (const std::uint32_t triangle : {t, u})
        if (patch_of_[triangle] != no_patch) crosses[patch_of_[triangle]] = true;
    bool has_lowered = false;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      if (!crosses[i] || patches_[i].stage == Stage::coarse) continue;
      patches_[i].lower();
      has_lowered = true;
    }
    return has_lowered;
  }

  static constexpr std::uint32_t no_patch = Surface::none;
  static constexpr std::size_t all_of_them = std::numeric_limits<std::size_t>::max();

  std::span<const Point3> points_;
  const Surface& surface_;
  const std::vector<bool>& is_new_;
  const SurfaceOptions& options_;
  GoOn go_on_;
  Fans fans_;
  std::vector<Patch> patches_;
  Indices patch_of_;  // for each assembled triangle, its patch or no_patch
};

}  // namespace

RefinedSurface refine_filling(std::span<const Point3> points, const Surface& surface, const std::vector<bool>& is_new,
                              const SurfaceOptions& options) {
  space::check_points(points);
  meshops::require_one_each("refine_filling", is_new.size(), "values of `is_new`", surface.triangles.size(),
                            "triangles");
  return Refining(points, surface, is_new, options).run();
}

AddedPoints refine_filling(std::span<const Point3> points, FilledSurface& filled, const SurfaceOptions& options) {
  RefinedSurface refined = refine_filling(points, filled.surface, filled.is_new, options);
  filled.surface = std::move(refined.surface);
  filled.is_new = std::move(refined.is_new);
  return refined;
}

}  // namespace rbpa
