// What: how much more memory this process can allocate.
#pragma once

#include <optional>
#include <string>

namespace rbpa::app {

/// Returns the available memory in bytes: the least of the memory that is free on the machine, of what the control
/// groups leave, and of what the limit on the address space leaves. Returns nothing if the system reports none of the
/// three.
std::optional<double> available_memory();

/// Returns a size in bytes as text: "1.5 GB", "20 MB".
std::string bytes_text(double bytes);

}  // namespace rbpa::app
