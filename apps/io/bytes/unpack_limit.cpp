#include "io/bytes/unpack_limit.h"

#include <algorithm>

#include "io/bytes/available_memory.h"
#include "io/failure.h"

namespace rbpa::app {
namespace {

/// So long a header may be; and what may lie behind the data, as readers of files that are not packed leave it alone.
constexpr std::size_t slack = std::size_t{1} << 20U;

/// Four bytes of text, "0 0" and a line end, become a point of 16.
constexpr double bytes_for_each = 5;

}  // namespace

UnpackLimit::UnpackLimit(const std::string& name, const Claim& claim, const std::string& way_out)
    : name_(name), claim_(claim), way_out_(way_out), next_(claim.size == nullptr ? any_size : slack) {
  if (const std::optional<double> there = available_memory()) most_ = *there / bytes_for_each;
}

void UnpackLimit::require(std::string_view unpacked) {
  const auto size = static_cast<double>(unpacked.size());
  if (most_ && size > *most_)
    bad_input(name_, "more than " + bytes_text(*most_) + " unpacked",
              "at most a fifth of the " + bytes_text(bytes_for_each * *most_) +
                  " of memory there are, as reading takes several times as much" + way_out_);
  if (size <= next_) return;
  const double claimed = claimed_by(unpacked);
  if (size > claimed + slack)
    bad_input(name_, "more than " + counted(static_cast<std::size_t>(claimed) + slack, "byte") + " unpacked",
              counted(static_cast<std::size_t>(claimed), "byte") + " as the header claims, or at most " +
                  std::to_string(slack) + " more" + std::string(claim_.hint));
  next_ = std::max(claimed + slack, 2 * size);
}

/// A message about a header says how much was unpacked, since more of the file may follow.
double UnpackLimit::claimed_by(std::string_view unpacked) const {
  try {
    return claim_.size(unpacked, name_);
  } catch (const BadInput& refusal) {
    throw BadInput(std::string(refusal.what()) + " (in the first " + counted(unpacked.size(), "byte") + " unpacked)");
  }
}

}  // namespace rbpa::app
