#include "rbpa/rbpa.h"

#include <algorithm>
#include <utility>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/sort/canonical_order.h"
#include "rbpa/plane/mesh/assembly.h"
#include "rbpa/plane/patches/for_each_patch.h"

namespace rbpa {
namespace {

/// A sink that puts patches into a mesh.
struct MeshSink {
  using Share = meshops::Placement;
  static constexpr bool needs_outline = true;

  void prepare(const TilePatch&, Share&) const {}
  void place(const TilePatch& tile, Share& placement) { assembler.place(tile.patch, tile.outline, placement); }
  void fill(const TilePatch& tile, Share& placement) { assembler.fill(tile.patch, tile.outline, placement); }
  void worked() { monitor.worked(assembler.faces()); }

  meshops::PatchAssembler& assembler;
  Monitor& monitor;
};

/// Returns the assembled complex. Tiles find the triangles that they can decide; a last step finds the others.
meshops::AssembledPatches by_tiles(const Sites& sites, const Radius& radius, meshops::PatchAssembler assembler,
                                   Threads& threads, Monitor& monitor) {
  assembler.reserve(3 * sites.size(), 2 * sites.size());
  MeshSink sink{assembler, monitor};
  for_each_patch(sites, radius, threads, sink);
  auto assembled = std::move(assembler).join();
  monitor.completed(assembled.mesh());
  return assembled;
}

/// Returns the corners of a face as input indices, the smallest first.
Triangle corners_of(const SolidAlphaComplex& complex, Mesh::FaceHandle face) {
  Triangle corners;
  auto h = complex.mesh.halfedge_handle(face);
  for (std::uint32_t& corner : corners) {
    corner = complex.input_index[static_cast<std::size_t>(complex.mesh.to_vertex_handle(h).idx())];
    h = complex.mesh.next_halfedge_handle(h);
  }
  return from_least(corners);
}

}  // namespace

SolidAlphaComplex rbpa(std::span<const Point> points, double alpha, const Options& options) {
  check(points, alpha);
  SolidAlphaComplex complex;
  Threads threads = threads_for(points.size(), options.threads);
  Assembly assembly(points, complex, threads, options.progress);
  const Sites& sites = assembly.sites();
  Monitor monitor(options.progress, sites.size());
  if (assembly.are_collinear(options.progress))
    assembly.finish(assembly.front());
  else
    assembly.finish(by_tiles(sites, Radius::of(alpha), assembly.assembler(), threads, monitor));
  return complex;
}

std::vector<Triangle> triangles(const SolidAlphaComplex& complex) {
  std::size_t bound = 0;
  for (const std::uint32_t i : complex.input_index) bound = std::max(bound, i + std::size_t{1});
  Threads one;
  CanonicalOrder<Triangle> order(bound, complex.mesh.n_faces(), 1);
  order.with_writer([&](CanonicalOrder<Triangle>::Writer& writer) {
    for (const Mesh::FaceHandle face : complex.mesh.faces()) writer.add(corners_of(complex, face));
  });
  return order.sorted(one);
}

unsigned threads_used(std::size_t points, unsigned wanted) {
  return static_cast<unsigned>(threads_for(points, wanted).count());
}

}  // namespace rbpa
