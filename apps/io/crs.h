// What: names of coordinate reference systems, in files and on the command line.
// Law:  a name is copied from input to output; no coordinate is changed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rbpa::app {

struct Crs {
  std::string authority;  ///< "EPSG", or "OGC" for CRS84
  std::string code;       ///< "28992"
  bool degrees = false;   ///< geographic: x is a longitude and y a latitude

  /// Returns "EPSG:28992".
  std::string text() const { return authority + ":" + code; }
  /// Returns "urn:ogc:def:crs:EPSG::28992".
  std::string urn() const;
  /// Returns "28992", the number that PostGIS uses; nothing if the system has no EPSG code.
  std::optional<std::string> srid() const;
  /// Returns whether the system is longitude and latitude of WGS 84, which is GeoJSON's default.
  bool is_wgs84() const;
};

/// Returns longitude and latitude of WGS 84, the system of GeoJSON and of GPS receivers.
Crs wgs84();

/// Returns the horizontal system that `name` names: "EPSG:28992", or an URN or URL of the OGC, in letters of either
/// case. Returns nothing for any other name and for systems of heights, such as EPSG:5703.
std::optional<Crs> crs_of_name(std::string_view name);

/// Returns the horizontal system of well-known text, in either version of the OGC or in that of ESRI, by the AUTHORITY
/// or ID of the system; of a compound system the horizontal part. Returns nothing if it has neither, and for systems of
/// heights.
std::optional<Crs> crs_of_wkt(std::string_view text);

/// Returns the length in meters of the unit of a projected system in well-known text; nothing if the text names no
/// unit.
std::optional<double> unit_of_wkt(std::string_view text);

/// Returns the warning that `name`, a file's name of its system that crs_of_name() does not know, is dropped.
std::string warning_on_crs(std::string_view name);

/// Throws BadInput unless two files, `name` with `crs` and `first_name` with `first`, have the same system or none.
void require_same_crs(const std::optional<Crs>& crs, const std::string& name, const std::optional<Crs>& first,
                      const std::string& first_name);

/// Parses the value of `--crs`. Throws WrongUsage that names the value.
Crs parse_crs(const std::string& text);

}  // namespace rbpa::app
