// What: measures the peak of resident memory of one piece of work, in a process of its own so that nothing else affects
//       it.
#pragma once

#include <functional>
#include <optional>

namespace rbpa_bench {

/// Calls work(). Returns the peak rise of the resident memory of this process, in bytes; nothing when the system does
/// not report it.
std::optional<double> rise_of_peak(const std::function<void()>& work);

/// Forks; the child calls prepare(), then work(). Returns the peak rise of the resident memory of the child during
/// work(), in bytes; nothing when the child fails or the system does not report it.
std::optional<double> peak_bytes(const std::function<void()>& prepare, const std::function<void()>& work);

/// Returns the present resident memory of this process; nothing when the system does not report it.
std::optional<double> resident_bytes();

/// Keeps freed memory in this process from now on. On a virtual machine, the price of fresh memory depends on the host
/// and can vary tenfold from moment to moment: warm measurements do not pay it.
void keep_memory();

}  // namespace rbpa_bench
