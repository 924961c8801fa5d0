#include "rbpa/plane/filtration/solid_parts.h"

namespace rbpa {

SolidParts::SolidParts(const TriangleArrays& arrays, std::size_t points)
    : arrays_(arrays),
      gaps_(gaps_of(arrays, points)),
      parts_(arrays.triangles.size()),
      vertices_(arrays.triangles.size()),
      on_(points) {}

}  // namespace rbpa
