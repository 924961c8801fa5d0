// What: how much memory this process can still have.
#pragma once

#include <optional>
#include <string>

namespace rbpa::app {

/// In bytes: the least of what the machine has available, what the control group leaves and what the limit on the address
/// space leaves. Nothing where the system says none of them.
std::optional<double> available_memory();

/// "1.5 GB", "20 MB".
std::string bytes_text(double bytes);

}  // namespace rbpa::app
