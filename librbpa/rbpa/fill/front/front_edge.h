// What: an edge of a front, as the sites at its ends: the unfilled region lies on its left.
#pragma once

#include "meshops/patch/site.h"

namespace rbpa {

struct FrontEdge {
  meshops::Site from, to;
  friend bool operator==(const FrontEdge&, const FrontEdge&) = default;
};

}  // namespace rbpa
