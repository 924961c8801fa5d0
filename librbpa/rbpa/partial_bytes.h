// What: a Partial as bytes that any machine reads.
// Law:  the bytes do not depend on the order in which regions were merged; bytes that are cut off or changed are refused.
// Source: docs/partial.md, section 6, has the format.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/partial.h"

namespace rbpa {

/// Cost: linear, and that of a sort of the polygons.
RBPA_API std::vector<std::uint8_t> to_bytes(const Partial& partial);

/// Throws: InvalidInput that names the place and what was found: not such bytes, of another version, cut off, changed, or bytes that
///         to_bytes() does not write.
RBPA_API Partial partial_from_bytes(std::span<const std::uint8_t> bytes);

}  // namespace rbpa
