// What: a vector as a property map of Boost, with an entry for each index of a graph view.
#pragma once

#include <boost/property_map/property_map.hpp>
#include <vector>

namespace meshops {

/// Returns a property map from the vertices of a view (faces, in a dual graph) or from its edges, which are halfedges,
/// to the entries of `values` by index; the map is read-only if `values` is const. `index` is
/// get(boost::vertex_index, view) or get(boost::edge_index, view).
/// Requires: `values` has num_vertices(view) or num_edges(view) entries, outlives the map, and is not reallocated
///           during the map's lifetime. Not checked.
template <typename Value, typename Index>
auto by_index(std::vector<Value>& values, Index index) {
  return boost::make_iterator_property_map(values.begin(), index);
}
template <typename Value, typename Index>
auto by_index(const std::vector<Value>& values, Index index) {
  return boost::make_iterator_property_map(values.begin(), index);
}
template <typename Value, typename Index>
void by_index(const std::vector<Value>&&, Index) = delete;  // the map would outlive the values

}  // namespace meshops
