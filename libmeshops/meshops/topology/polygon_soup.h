// What: faces as lists of points, as files hold them: nothing is known yet of how they hang together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshops {

/// Points are numbers from 0; a face is the cycle of its corners. Any lists at all are a soup.
struct PolygonSoup {
  std::size_t points = 0;
  std::vector<std::uint32_t> corners;    ///< of all faces, one after the other
  std::vector<std::size_t> begin = {0};  ///< face f has the corners begin[f] to begin[f + 1]

  std::size_t faces() const { return begin.size() - 1; }
  std::span<const std::uint32_t> face(std::size_t f) const {
    return std::span(corners).subspan(begin[f], begin[f + 1] - begin[f]);
  }
  void add_face(std::span<const std::uint32_t> cycle) {
    corners.insert(corners.end(), cycle.begin(), cycle.end());
    begin.push_back(corners.size());
  }
};

}  // namespace meshops
