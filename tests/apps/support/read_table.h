// What: reads texts as tables of points in the plane.
#pragma once

#include <string>

#include "io/cloud/cloud.h"
#include "io/cloud/read_points.h"
#include "io/failure.h"

namespace apps_test {

/// Returns the points of the text, as read from a table of the name "t".
inline rbpa::app::PointFile read_table(const std::string& text, const rbpa::app::CloudRequest& rule = {}) {
  return read_plane_points(*rbpa::app::table_reader.open(rbpa::app::Content(text, "t"), rule));
}

/// Returns the message of the BadInput that read_table() throws; "none" if it throws none.
inline std::string refusal_of_table(const std::string& text, const rbpa::app::CloudRequest& rule = {}) {
  try {
    read_table(text, rule);
  } catch (const rbpa::app::BadInput& error) {
    return error.what();
  }
  return "none";
}

}  // namespace apps_test
