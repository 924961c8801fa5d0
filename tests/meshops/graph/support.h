// Shared parts of the tests of graph views.
#pragma once

#include <boost/graph/graph_concepts.hpp>
#include <cstddef>
#include <random>
#include <vector>

#include "meshops/core/live.h"
#include "support/check_sound.h"
#include "support/corpus.h"

namespace meshops::test {

/// Calls visit(specimen, mesh, has_gaps) for every specimen as it is, and again with a fifth of its faces marked
/// deleted (together with elements that only they had), so that indices have gaps.
template <typename Visit>
void for_each_specimen(Visit visit) {
  for (const Specimen& specimen : corpus())
    for (const bool with_gaps : {false, true}) {
      TestMesh mesh;
      specimen.build(mesh);
      if (with_gaps) {
        // Two fans at one vertex are not a sound mesh: a face is deleted only if that does not happen.
        std::mt19937 random(5);
        for (int i = 0; i < static_cast<int>(mesh.n_faces()); ++i) {
          if (random() % 5 != 0 || mesh.status(Face(i)).deleted()) continue;
          int boundary_corners = 0, boundary_sides = 0;
          for (const auto v : mesh.fv_range(Face(i))) boundary_corners += mesh.is_boundary(v);
          for (const auto e : mesh.fe_range(Face(i))) boundary_sides += mesh.is_boundary(e);
          if (boundary_corners == 0 || (boundary_corners == 2 && boundary_sides == 1)) mesh.delete_face(Face(i), true);
        }
        check_sound(mesh);
      }
      visit(specimen, mesh, with_gaps);
    }
}

/// Checks all requirements of Boost for a graph with these models.
template <typename Graph>
struct ViewConcepts {
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  BOOST_CONCEPT_ASSERT((boost::concepts::BidirectionalGraph<Graph>));
  BOOST_CONCEPT_ASSERT((boost::concepts::AdjacencyGraph<Graph>));
  BOOST_CONCEPT_ASSERT((boost::concepts::VertexAndEdgeListGraph<Graph>));
  BOOST_CONCEPT_ASSERT((boost::concepts::ReadablePropertyGraph<Graph, Node, boost::vertex_index_t>));
  BOOST_CONCEPT_ASSERT((boost::concepts::ReadablePropertyGraph<Graph, Halfedge, boost::edge_index_t>));
};

/// The nodes and named edges of a view as lists.
template <typename Graph>
auto nodes_of(const Graph& g) {
  const auto [first, last] = vertices(g);
  return std::vector<typename Graph::vertex_descriptor>(first, last);
}
template <typename Graph>
std::vector<Halfedge> edges_of(const Graph& g) {
  const auto [first, last] = edges(g);
  return {first, last};
}

template <typename Handle>
std::size_t index(Handle handle) {
  return static_cast<std::size_t>(handle.idx());
}

}  // namespace meshops::test
