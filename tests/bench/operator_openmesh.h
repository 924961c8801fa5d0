// What: the mesh on which libmeshops and OpenMesh compete, and the queries that both make.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <vector>

#include "bench/operator_contest.h"

namespace meshops_bench {

struct TriMesh : OpenMesh::TriMesh_ArrayKernelT<> {
  TriMesh();
};

/// Builds a mesh by OpenMesh's add_face().
TriMesh mesh_of(const Task& task);
void copy_with_room(const TriMesh& from, TriMesh& to);
Shape shape_of(const TriMesh& mesh);

OpenMesh::VertexHandle vertex(std::uint32_t index);
OpenMesh::HalfedgeHandle halfedge(const TriMesh& mesh, std::uint32_t from, std::uint32_t to);
OpenMesh::FaceHandle face(const TriMesh& mesh, const Site& site);

/// Contestant whose step gets the result of `locate(mesh, site)` for each site.
template <typename Locate, typename Step>
std::unique_ptr<Contestant> at_sites(TriMesh mesh, const Task& task, Locate locate, Step step) {
  using Handles = decltype(locate(mesh, task.sites.front()));
  std::vector<Handles> sites;
  for (const Site& site : task.sites) sites.push_back(locate(mesh, site));
  using Result = AtSites<TriMesh, Handles, decltype(&copy_with_room), Step, decltype(&shape_of)>;
  return std::make_unique<Result>(std::move(mesh), std::move(sites), &copy_with_room, step, &shape_of);
}

/// Contestant that operates on the whole mesh at once: prepare(mesh) is not timed, run(mesh) is.
template <typename Prepare, typename Run>
class AtOnce : public Contestant {
 public:
  AtOnce(Prepare prepare, Run run) : prepare_(prepare), run_(run) {}
  double pass() override {
    mesh_ = TriMesh();
    prepare_(mesh_);
    const double begin = seconds_of_thread();
    run_(mesh_);
    return seconds_of_thread() - begin;
  }
  Shape shape() const override { return shape_of(mesh_); }

 private:
  TriMesh mesh_;
  Prepare prepare_;
  Run run_;
};

template <typename Prepare, typename Run>
std::unique_ptr<Contestant> at_once(Prepare prepare, Run run) {
  return std::make_unique<AtOnce<Prepare, Run>>(prepare, run);
}

}  // namespace meshops_bench
