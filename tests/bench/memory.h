// What: the peak of resident memory of one piece of work, in a process of its own so that nothing else blurs it.
#pragma once

#include <functional>
#include <optional>

namespace rbpa_bench {

/// Calls work(). By how many bytes the resident memory of this process rose at most above what it was before. Absent
/// where the system does not report it.
std::optional<double> rise_of_peak(const std::function<void()>& work);

/// Forks; the child calls prepare(), then work(), and reports by how many bytes its resident memory rose at most above
/// what it was in between. Absent where the child fails or the system does not report it.
std::optional<double> peak_bytes(const std::function<void()>& prepare, const std::function<void()>& work);

/// Resident memory of this process now. Absent where the system does not report it.
std::optional<double> resident_bytes();

/// From now on, memory that is freed stays with this process. Where a machine is a guest of another, fresh memory costs
/// what the host makes of it, ten times more at one moment than at the next: what is measured warm does not pay that.
void keep_memory();

}  // namespace rbpa_bench
