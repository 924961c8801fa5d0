// What: points that lie in rows of numbers: the vertices of PLY and OFF, the points of PCD.
// Law:  nothing is read that the layout does not name; in a binary file all elements have to be there.
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

/// Which properties of an element are what of a point.
struct PointLayout {
  std::size_t element = 0;                                        ///< which of the header's
  std::vector<std::pair<std::size_t, std::size_t>> columns = {};  ///< of a block, each with its property
  std::vector<std::size_t> condition = {};                        ///< properties that the condition reads
  std::optional<std::size_t> height = std::nullopt;               ///< z where it is no column
  std::optional<std::size_t> color = std::nullopt;                ///< 0xRRGGBB in an integer, or in the bits of a float
  bool colors_behind = false;                                     ///< of text, three words behind these
  bool has_room = false;                                          ///< the data are known to be long enough
  bool by_columns = false;          ///< of binary data without lists, all of one property before all of the next
  std::vector<char> unpacked = {};  ///< what the header's data are of, where they were compressed
  CloudFacts facts = {};
};

/// Adds the columns of the normal when all of `names` are there, and a remark when only some are.
void lay_out_normal(const PlyElement& element, const std::string_view (&names)[3], PointLayout& layout);

/// The points of `header`, which is that of `content`.
std::unique_ptr<Cloud> open_elements(Content content, PlyHeader header, PointLayout layout,
                                     const CloudRequest& request);

}  // namespace rbpa::app
