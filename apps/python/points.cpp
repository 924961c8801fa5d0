#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/crs.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/read_mesh.h"
#include "io/number.h"
#include "io/polygon/ogr.h"
#include "python/file_errors.h"
#include "python/module.h"
#include "rbpa/base/error.h"

namespace rbpa::python {
namespace {

using app::Format;
using MaybeText = std::optional<std::string>;

Format format_of(const std::string& path, const MaybeText& name, app::Use use) {
  if (const std::optional<Format> found = app::find_format(use, name ? *name : app::input_ending(path))) return *found;
  if (name) app::refuse_name("format", *name, app::endings(use));
  app::refuse_input(path, use, "format");
}

/// The requested fields, each with its name and its kind: "number", "text", or "" if the values of the file decide.
using WantedFields = std::vector<std::pair<std::string, std::string>>;

std::vector<app::WantedColumn> columns_of(const WantedFields& fields, app::Use use, bool texts) {
  const auto has_texts = [](const app::CloudFormat& reader) {
    return reader.fields != nullptr && reader.fields().texts;
  };
  std::vector<app::WantedColumn> columns;
  for (const auto& [name, kind] : fields) {
    using Kind = app::WantedColumn::Kind;
    app::require_format(texts || kind != "text", "fields", "without fields of text", app::readable(use, has_texts));
    columns.push_back({.name = name,
                       .kind = kind == "number" ? Kind::number
                               : kind == "text" ? Kind::text
                                                : Kind::by_value});
  }
  return columns;
}

app::PointSource source_of(const std::string& path, bool space, const WantedFields& fields, const MaybeText& where,
                           const MaybeText& columns, const MaybeText& format, bool skip_invalid, bool vertices) {
  app::PointSource source{.path = path, .skip_invalid = skip_invalid, .vertices = vertices};
  const app::Use use = space ? app::Use::space : app::Use::points;
  source.format = format_of(path, format, use);
  app::require_readable(use, source.format,
                        {.columns = columns ? "columns" : nullptr,
                         .skip_invalid = skip_invalid ? "skip_invalid" : nullptr,
                         .vertices = vertices ? "vertices" : nullptr,
                         .fields = where            ? "where"
                                   : fields.empty() ? nullptr
                                                    : "fields"});
  if (columns) source.columns = space ? app::parse_space_columns(*columns) : app::parse_columns(*columns);
  if (where || !fields.empty()) {
    const app::FieldNames names = *app::fields_of(source.format);
    source.where.emplace(where.value_or(""), names, columns_of(fields, use, names.texts));
  }
  if (!fields.empty()) source.keeps.emplace().names.emplace();
  for (const auto& [name, kind] : fields)
    if (kind.empty()) source.keeps->names->push_back(name);
  return source;
}

/// Returns the window that selects points by box and resolution. Throws WrongUsage for an invalid box or resolution.
app::PointWindow window_of(const std::optional<std::vector<double>>& bounds, std::optional<double> resolution) {
  app::PointWindow window{.resolution = resolution};
  if (bounds) window.bounds = app::box_of("bounds", *bounds);
  if (resolution && !(*resolution > 0 && std::isfinite(*resolution)))
    app::bad_usage("resolution", app::text_of(*resolution), "a length above 0");
  return window;
}

/// Returns a list of texts for Python, with escapes for bytes that are not UTF-8.
py::list printable_texts(const std::vector<std::string>& texts) {
  py::list list;
  for (const std::string& text : texts) try {
      list.append(py::str(text));
    } catch (const py::error_already_set&) {
      list.append(app::printable(text));
    }
  return list;
}

/// Returns the values of a column as an array with the type of the column.
py::object values_of(const app::PointColumn& column) {
  return app::with_type(column.type, [&](auto zero) -> py::object {
    using Value = decltype(zero);
    return py::array_t<Value>(static_cast<py::ssize_t>(column.size()),
                              reinterpret_cast<const Value*>(column.bytes.data()));
  });
}

/// Returns the data of a file as a dict, for points in the plane or in space, with None as normals and colors.
py::dict dict_of(Doubles points, app::PointFacts file, const app::PointSource& source) {
  py::dict result;
  result["points"] = std::move(points);
  result["normals"] = py::none();
  result["colors"] = py::none();
  py::list fields;
  file.fields.resize(source.where ? source.where->columns() : 0);  // the reader has no fields if the file has no points
  for (std::size_t k = 0; k < file.fields.size(); ++k) {
    const app::WantedColumn& wanted = source.where->column(k);
    const app::PointColumn* kept = app::find_column(file.kept, wanted.name);
    const bool has_texts = k < file.texts.size() && file.texts[k];
    if (kept != nullptr && !has_texts && wanted.kind == app::WantedColumn::Kind::by_value)
      for (const std::string& text : kept->texts)  // the file has other numbers too, so that no integer type holds all
        if (app::parse_whole_number(text).fault == app::NumberFault::rounded_integer)
          app::refuse_integer(source.path + ": field " + app::in_quotes(wanted.name), text);
    if (kept != nullptr && !kept->is_text && wanted.kind == app::WantedColumn::Kind::by_value)
      fields.append(values_of(*kept));
    else if (has_texts)
      fields.append(py::make_tuple(line<double>(std::move(file.fields[k])), printable_texts(*file.texts[k])));
    else
      fields.append(line<double>(std::move(file.fields[k])));
  }
  result["fields"] = std::move(fields);
  result["crs"] = file.crs ? py::object(py::str(file.crs->text())) : py::none();
  py::list warnings;
  for (const std::string& warning : file.warnings) warnings.append(app::printable(warning));
  result["warnings"] = std::move(warnings);
  std::vector<std::int64_t> index(file.index.begin(), file.index.end());
  result["selected"] = index.empty() ? py::object(py::none()) : py::object(line<std::int64_t>(std::move(index)));
  return result;
}

template <typename Read>
auto read_watched(Read read) {
  constexpr std::size_t many = std::numeric_limits<std::size_t>::max();  // unknown, so the work may be long
  return watched(many, py::none(), [&](Watch& watch) {
    const app::Interruption interruption(watch.until_stopped());
    return read();
  });
}

py::dict read(const app::PointSource& source, bool space) {
  if (!space) {
    app::PointFile file = read_watched([&] { return app::read_points(source); });
    return dict_of(rows<double>(std::move(file.points)), std::move(file), source);
  }
  const app::CloudRequest request{.columns = source.columns,
                                  .where = source.where,
                                  .skip_invalid = source.skip_invalid,
                                  .needs_normals = false,
                                  .keeps = source.keeps,
                                  .window = source.window};
  app::SpacePoints file = read_watched([&] { return app::read_space_points(source.path, source.format, request); });
  py::dict result = dict_of(rows<double>(std::move(file.points)), std::move(file), source);
  if (!file.normals.empty()) result["normals"] = rows<double>(std::move(file.normals));
  if (!file.colors.empty()) result["colors"] = rows<std::uint8_t>(std::move(file.colors));
  return result;
}

py::dict read_points(const py::bytes& path, bool space, const WantedFields& fields, const MaybeText& where,
                     const MaybeText& columns, const MaybeText& format, bool skip_invalid, bool vertices,
                     const std::optional<std::vector<double>>& bounds, std::optional<double> resolution) {
  return with_file_errors([&] {
    app::PointSource source = source_of(path, space, fields, where, columns, format, skip_invalid, vertices);
    source.window = window_of(bounds, resolution);
    return read(source, space);
  });
}

/// Positions, corners, the begin of each face among the corners, and warnings.
using MeshArrays = std::tuple<Doubles, Indices, Begins, std::vector<std::string>>;

MeshArrays read_mesh(const py::bytes& path, const MaybeText& format) {
  return with_file_errors([&] {
    const app::MeshSource source{path, format_of(path, format, app::Use::mesh)};
    app::MeshFile file = read_watched([&] { return app::read_mesh(source); });
    for (std::string& warning : file.warnings) warning = app::printable(warning);
    std::vector<std::int64_t> begin(file.soup.begin.begin(), file.soup.begin.end());
    return MeshArrays(rows<double>(std::move(file.positions)), line<std::int32_t>(std::move(file.soup.corners)),
                      line<std::int64_t>(std::move(begin)), std::move(file.warnings));
  });
}

/// Returns the name of a system for the member "crs" of GeoJSON; nothing for WGS 84, GeoJSON's default.
std::optional<std::string> crs_urn(const std::string& name) {
  const std::optional<app::Crs> crs = app::crs_of_name(name);
  if (!crs) throw InvalidInput("crs: found " + app::in_quotes(name) + ", expected a horizontal system, EPSG:CODE");
  return crs->is_wgs84() ? std::nullopt : std::optional(crs->urn());
}

}  // namespace

void bind_points(py::module_& module) {
  using py::arg;
  module.def("crs_urn", &crs_urn, arg("name"));
  module.def("read_points", &read_points, arg("path"), arg("space"), arg("fields"), arg("where"), arg("columns"),
             arg("format"), arg("skip_invalid"), arg("vertices"), arg("bounds"), arg("resolution"));
  module.def("read_mesh", &read_mesh, arg("path"), arg("format"));
}

}  // namespace rbpa::python
