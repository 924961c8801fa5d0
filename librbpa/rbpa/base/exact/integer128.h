// What: names of the compiler's integer types of 128 bits.
#pragma once

namespace rbpa {

__extension__ using Integer128 = __int128;
__extension__ using Unsigned128 = unsigned __int128;

}  // namespace rbpa
