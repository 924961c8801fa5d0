// What: how far a gzip file is unpacked: some kilobytes may become gigabytes.
// Law:  a whole file is never refused for its claim, unless more than a mebibyte lies behind its data, or is one line of
//       its text, with the comments and blank lines before it.
// Cost: memory is at most twice what is claimed, and two mebibytes; a claim is asked for again when as much more is there.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/claim.h"

namespace rbpa::app {

class UnpackLimit {
 public:
  /// Of the file `name`. Without a claim memory alone is the limit; `way_out` ends the sentence that says so.
  UnpackLimit(const std::string& name, const Claim& claim, const std::string& way_out);

  /// What is unpacked so far. Throws BadInput when that is more than the first of it claims, or when memory would not
  /// suffice for more of it and for what reading makes of it.
  void require(std::string_view unpacked);

 private:
  double claimed_by(std::string_view unpacked) const;

  const std::string& name_;
  Claim claim_;
  const std::string& way_out_;
  std::optional<double> most_;  // for which memory suffices
  double next_;                 // the size at which the claim is asked for
};

}  // namespace rbpa::app
