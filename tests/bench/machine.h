// What: the machine and the build a figure was measured on, without which it means nothing.
#pragma once

#include <string>

namespace rbpa_bench {

std::string processor();  ///< model, and the number of them
std::string memory();     ///< in GiB
std::string system();     ///< kernel and architecture
std::string compiler();
std::string compiler_flags();
/// All of these, with semicolons between them.
std::string machine_and_build();

/// In UTC: "2026-11-22".
std::string today();

}  // namespace rbpa_bench
