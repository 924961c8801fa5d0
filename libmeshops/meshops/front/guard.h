// What: detects forbidden changes: changes of the mesh by code other than the front, and changes of the front by a
//       policy or a visitor during a call.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/element_counts.h"

namespace meshops::detail {

class MESHOPS_API Guard {
 public:
  explicit Guard(const Connectivity& mesh) : mesh_(mesh) {}

  /// Records the present numbers of elements. The front calls this function after each of its changes.
  void count_elements() { counts_ = ElementCounts::of(mesh_); }
  void finish() { counts_ = finished; }
  /// Returns whether the front is not finished and no other code has changed the number of elements.
  bool is_intact() const { return ElementCounts::of(mesh_) == counts_; }

  // The three functions require_…() throw ContractViolation, whose message names the cause.
  void require_intact() const {
    if (!is_intact()) [[unlikely]]
      violated();
  }
  void require_changeable() const {
    require_intact();
    if (caller_ != Caller::user) [[unlikely]]
      changed_while_called();
  }
  void require_states_changeable() const {
    require_intact();
    if (caller_ == Caller::policy) [[unlikely]]
      changed_while_called();
  }

  /// Code that the engine is calling: a policy may change nothing, a visitor may only activate and freeze halfedges.
  enum class Caller : std::uint8_t { user, policy, visitor };
  /// Marks a call of a policy or a visitor during the lifetime of the object.
  class Call {
   public:
    Call(Guard& guard, Caller caller) : guard_(guard), before_(guard.caller_) { guard.caller_ = caller; }
    ~Call() { guard_.caller_ = before_; }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

   private:
    Guard& guard_;
    Caller before_;
  };

 private:
  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
  static constexpr ElementCounts finished{never, never, never};
  [[noreturn, gnu::cold, gnu::noinline]] void violated() const;
  [[noreturn, gnu::cold, gnu::noinline]] void changed_while_called() const;

  const Connectivity& mesh_;
  ElementCounts counts_;  // as the front left them; impossible values after finish()
  Caller caller_ = Caller::user;
};

}  // namespace meshops::detail
