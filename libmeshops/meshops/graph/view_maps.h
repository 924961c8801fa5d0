// What: the property maps that every graph view has.
// Law:  an index is idx() of the handle of a vertex, a face, an edge, or, for edges of a directed view, a halfedge.
#pragma once

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>
#include <cstddef>

#include "meshops/core/connectivity.h"

namespace meshops {

template <typename Kind, typename Direction>
class GraphView;

/// Map from a handle to its index divided by `PerIndex`: 1, or 2 for the halfedges of an undirected view, whose index
/// is that of their edge.
template <typename Handle, int PerIndex>
struct IndexMap {
  using key_type = Handle;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;

  // OpenMesh keeps the halfedges of edge e at 2e and 2e + 1.
  std::size_t operator[](Handle handle) const { return static_cast<std::size_t>(handle.idx() / PerIndex); }
  friend std::size_t get(IndexMap map, Handle handle) { return map[handle]; }
};

/// Map from a halfedge to its opposite.
struct ReverseMap {
  using key_type = Halfedge;
  using value_type = Halfedge;
  using reference = Halfedge;
  using category = boost::readable_property_map_tag;

  Halfedge operator[](Halfedge h) const { return Halfedge(h.idx() ^ 1); }
  friend Halfedge get(ReverseMap map, Halfedge h) { return map[h]; }
};

}  // namespace meshops

// Boost looks up the types of the maps that get() returns in these specializations.
namespace boost {
template <typename Kind, typename Direction>
struct property_map<meshops::GraphView<Kind, Direction>, vertex_index_t> {
  using type = typename meshops::GraphView<Kind, Direction>::VertexIndexMap;
  using const_type = type;
};
template <typename Kind, typename Direction>
struct property_map<meshops::GraphView<Kind, Direction>, edge_index_t> {
  using type = typename meshops::GraphView<Kind, Direction>::EdgeIndexMap;
  using const_type = type;
};
template <typename Kind>
struct property_map<meshops::GraphView<Kind, bidirectional_tag>, edge_reverse_t> {
  using type = meshops::ReverseMap;
  using const_type = type;
};
template <typename Kind, typename Direction, typename Property>
struct property_map<const meshops::GraphView<Kind, Direction>, Property>
    : property_map<meshops::GraphView<Kind, Direction>, Property> {};
}  // namespace boost
