// What: what LZF has compressed, as the Point Cloud Library compresses points.
// Source: M. Lehmann, liblzf.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rbpa::app {

/// The `size` bytes that `packed` becomes. Nothing is allocated for a size that it cannot become, or for which memory does not
/// suffice. Throws BadInput naming `place`, where the data are.
std::vector<char> unpack_lzf(std::string_view packed, std::size_t size, const std::string& place);

}  // namespace rbpa::app
