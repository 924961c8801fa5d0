// What: fields of vertices as properties of PLY.
// Law:  numbers are exact. A column of 64-bit integers, which PLY does not have, is written as int, uint or double, the
//       first type that holds all its values; it is left out if none does.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/point_columns.h"

namespace rbpa::app {

/// Returns the type of a column in PLY; nothing if no type holds its values.
std::optional<Scalar> ply_type(const PointColumn& column);

class PlyFields {
 public:
  /// Views `fields`. In names of properties blanks become '_'; a name that is taken gets a suffix _2, _3 and so on.
  explicit PlyFields(const VertexFields& fields);

  /// Returns the lines of the header that declare the properties.
  const std::string& lines() const { return lines_; }
  /// Returns comment lines of the header, which list the text for each number of a column of texts.
  const std::string& comments() const { return comments_; }
  /// Writes the fields of a vertex.
  void write(OutputFile& file, std::size_t vertex) const;

 private:
  struct Property {
    const PointColumn* column;
    Scalar type;
  };

  VertexFields fields_;
  std::vector<Property> properties_ = {};
  std::string lines_ = {}, comments_ = {};
};

}  // namespace rbpa::app
