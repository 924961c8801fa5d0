// What: reads texts as tables of points in the plane, and checks their warnings and refusals.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/read_points.h"
#include "io/failure.h"
#include "support/refusal_of.h"
#include "support/text.h"

namespace apps_test {

using rbpa_test::contains;

/// Returns the points of the text, as read from a table of the name "t".
inline rbpa::app::PointFile read_table(const std::string& text, const rbpa::app::CloudRequest& rule = {}) {
  return read_plane_points(*rbpa::app::table_reader.open(rbpa::app::Content(text, "t"), rule));
}

/// Returns the message of the BadInput that read_table() throws; "" if it throws none.
inline std::string refusal_of_table(const std::string& text, const rbpa::app::CloudRequest& rule = {}) {
  return rbpa_test::refusal_of<rbpa::app::BadInput>([&] { read_table(text, rule); });
}

/// Returns the warnings of a table with a part that is `part`.
inline std::vector<std::string> warnings_with(const std::string& text, const std::string& part) {
  std::vector<std::string> found;
  for (const std::string& warning : read_table(text).warnings)
    if (contains(warning, part)) found.push_back(warning);
  return found;
}

/// Checks that the table is refused with a message that begins so, whether lines may be left out or not.
inline void is_refused_whole(const std::string& text, const std::string& message) {
  CAPTURE(text);
  for (const rbpa::app::CloudRequest& request :
       {rbpa::app::CloudRequest{}, rbpa::app::CloudRequest{.skip_invalid = true}}) {
    const std::string refusal = refusal_of_table(text, request);
    CAPTURE(refusal);
    CHECK(refusal.starts_with(message));
    CHECK(!contains(refusal, "--skip-invalid"));
  }
}

}  // namespace apps_test
