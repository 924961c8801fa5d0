// What: describes the machine and the build of a measurement.
#pragma once

#include <string>

namespace rbpa_bench {

std::string processor();  ///< model and number of processors
std::string memory();     ///< in GiB
std::string system();     ///< kernel and architecture
std::string compiler();
std::string compiler_flags();
/// Returns all of these, separated by semicolons.
std::string machine_and_build();

/// Returns the date in UTC: "2026-11-22".
std::string today();

}  // namespace rbpa_bench
