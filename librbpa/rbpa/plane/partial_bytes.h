// What:   writes a Partial as bytes, and reads them on any machine.
// Law:    the bytes do not depend on the order in which regions were merged; truncated or changed bytes are refused.
// Source: docs/explanation/plane.md, section 22, has the format.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/plane/partial.h"

namespace rbpa {

/// Returns `partial` as bytes.
/// Cost: linear, and that of a sort of the polygons.
RBPA_API std::vector<std::uint8_t> to_bytes(const Partial& partial);

/// Returns the Partial that to_bytes() wrote.
/// Throws: InvalidInput that names the place and what was found, if the bytes are of another kind or version,
///         truncated, changed, or not such as to_bytes() writes.
RBPA_API Partial partial_from_bytes(std::span<const std::uint8_t> bytes);

}  // namespace rbpa
