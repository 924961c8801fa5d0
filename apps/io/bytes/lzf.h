// What: decompression of LZF, with which the Point Cloud Library compresses points.
// Source: M. Lehmann, liblzf.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rbpa::app {

/// Returns the `size` bytes that were compressed. Throws BadInput naming `place`, where the data are; before anything
/// is allocated if `compressed` is too short for that size or if memory does not suffice.
std::vector<char> decompress_lzf(std::string_view compressed, std::size_t size, const std::string& place);

}  // namespace rbpa::app
