#include "rbpa/plane/filtration/solid_parts.h"

namespace rbpa {

SolidParts::SolidParts(const std::vector<FaceCell>& cells, std::size_t vertices)
    : cells_(cells), gaps_(gaps_of(cells, vertices)), parts_(cells.size()), vertices_(cells.size()), on_(vertices) {}

}  // namespace rbpa
