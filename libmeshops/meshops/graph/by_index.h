// What: a vector as a property map of Boost, with an entry for each index of a graph view.
#pragma once

#include <boost/property_map/property_map.hpp>
#include <vector>

namespace meshops {

/// Returns a map from vertices, faces or edges to the entries of `values` by index. `index` is a map of the view:
/// get(boost::vertex_index, view), with num_vertices(view) values, or get(boost::edge_index, view), with
/// num_edges(view). The map refers to `values`, which must outlive it and must not be reallocated.
template <typename Value, typename Index>
auto by_index(std::vector<Value>& values, Index index) {
  return boost::make_iterator_property_map(values.begin(), index);
}
template <typename Value, typename Index>
auto by_index(const std::vector<Value>& values, Index index) {
  return boost::make_iterator_property_map(values.begin(), index);
}

}  // namespace meshops
