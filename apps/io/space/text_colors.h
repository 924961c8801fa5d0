// What: colours that stand as numbers behind the vertices of a file of text.
// Law:  one of each vertex, or none and a remark: a file that has them in part has none. Channels are from 0 to 1; where one
//       of the file is greater, all are from 0 to 255, or from 0 to 65535 where such are `allowed`.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/space/space_points.h"

namespace rbpa::app {

class TextColors {
 public:
  TextColors() = default;
  explicit TextColors(double allowed) : allowed_(allowed) {}

  /// The first three words of what follows a vertex, in line `line`; there may be more. Other words are no colour.
  void take(std::string_view rest, std::size_t line);

  /// The same of three words.
  void take(const std::array<std::string_view, 3>& words, std::size_t line);

  /// Those of all vertices of the file, once they are taken. It is no loss to have none, unless they are `announced`.
  void settle(bool announced, SpacePoints& file) const;

 private:
  std::string fault(bool announced) const;

  double allowed_ = 255;  // the greatest channel
  std::vector<std::array<float, 3>> channels_ = {};
  double greatest_ = 0;
  std::size_t line_without_ = 0;  // the first; 0: there is none
  std::size_t line_beyond_ = 0;   // the first with a channel below 0 or above what is allowed
  std::string beyond_ = {};       // that channel
};

}  // namespace rbpa::app
