// What:   converts a Partial to bytes that any machine can read, and back.
// Law:    to_bytes(partial_from_bytes(b)) is b for every result b of to_bytes(). Unless polygons or holes were removed,
//         bytes do not depend on the order in which regions were merged. A checksum detects truncated bytes and bytes
//         changed by accident, not those changed on purpose.
// Source: docs/explanation/plane.md, section 22, has the format.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/plane/partial.h"

namespace rbpa {

/// Returns `partial` as bytes.
/// Cost: linear, and that of a sort of the polygons and of the rings of unfinished components.
RBPA_API std::vector<std::uint8_t> to_bytes(const Partial& partial);

/// Returns the Partial that to_bytes() wrote.
/// Throws: InvalidInput with what was found and expected, if the bytes are of another kind or version, do not have the
///         size or checksum that they state, or break a rule that to_bytes() keeps.
/// Cost:   linear; n log n in the corners of the part of the plane that is merged.
RBPA_API Partial partial_from_bytes(std::span<const std::uint8_t> bytes);

}  // namespace rbpa
