// What: points that are rows of numbers: the vertices of PLY and OFF, the points of PCD and KITTI.
// Law:  only properties that the layout names are read; a binary file must nevertheless hold all elements.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/ply.h"

namespace rbpa::app {

/// Maps the properties of an element to the columns of a point.
struct PointLayout {
  std::size_t element = 0;                                        ///< index among the header's elements
  std::vector<std::pair<std::size_t, std::size_t>> columns = {};  ///< column of the block, and index of its property
  std::optional<std::size_t> height = std::nullopt;               ///< index of property z, unless z is a column
  std::optional<std::size_t> color = std::nullopt;                ///< property 0xRRGGBB: an integer, or bits of a float
  bool colors_behind = false;                                     ///< text: colors are three words after the properties
  bool has_room = false;                                          ///< the data are known to be long enough
  bool by_columns = false;              ///< binary without lists: all values of one property before those of the next
  std::vector<char> decompressed = {};  ///< decompressed data, which the header's data view
  CloudFacts facts = {};
};

/// Adds the columns of the normal if the element has all properties `names`, and a warning if it has only some.
void lay_out_normal(const PlyElement& element, const std::string_view (&names)[3], PointLayout& layout);

/// Returns a reader of the points of `content`, whose header is `header`.
std::unique_ptr<Cloud> open_elements(Content content, PlyHeader header, PointLayout layout,
                                     const CloudRequest& request);

}  // namespace rbpa::app
