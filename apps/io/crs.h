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
  bool degrees = false;   ///< true: x is a longitude and y a latitude
  bool implied = false;   ///< true: the file names no system, which in GeoJSON means WGS 84

  /// Returns "EPSG:28992".
  std::string text() const { return authority + ":" + code; }
  /// Returns "urn:ogc:def:crs:EPSG::28992".
  std::string urn() const;
  /// Returns "28992", the number that PostGIS uses; nothing if the system has no EPSG code.
  std::optional<std::string> srid() const;
  /// Returns whether x, y and z are distances from the center of the earth: x and y alone are no place on a map.
  bool is_geocentric() const;
  /// Returns whether the system is longitude and latitude of WGS 84, which is GeoJSON's default.
  bool is_wgs84() const;
};

/// Returns longitude and latitude of WGS 84, the system of GeoJSON and of GPS receivers.
Crs wgs84();

/// Returns the horizontal system that `name` names: "EPSG:28992", or an URN or URL of the OGC, in letters of either
/// case. Returns nothing for any other name and for systems of heights, such as EPSG:5703.
std::optional<Crs> crs_of_name(std::string_view name);

/// Returns the horizontal system that an AUTHORITY or ID in well-known text names. The text has either version of the
/// OGC, or that of ESRI. The horizontal part of a compound system counts. Returns nothing for a system without
/// AUTHORITY and ID, and for a system of heights.
std::optional<Crs> crs_of_wkt(std::string_view text);

/// Returns the length in meters of the unit of a projected system in well-known text; nothing if the text names no
/// unit.
std::optional<double> unit_of_wkt(std::string_view text);

/// Returns the warning that a file's coordinate system `name`, which crs_of_name() does not know, is dropped.
std::string warning_on_crs(std::string_view name);

/// Throws BadInput unless the system `crs` of the file `name` and the system `first` of the file `first_name` are the
/// same, or both are absent.
void require_same_crs(const std::optional<Crs>& crs, const std::string& name, const std::optional<Crs>& first,
                      const std::string& first_name);

/// Parses the value of `--crs`. Throws WrongUsage that names the value unless it names a horizontal system.
Crs parse_crs(const std::string& text);

}  // namespace rbpa::app
