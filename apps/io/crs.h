// What: coordinate reference systems, as files and people name them.
// Law:  a name is carried from input to output; no coordinate is changed.
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
  /// Returns "28992", the number that PostGIS uses; nothing if there is none.
  std::optional<std::string> srid() const;
  /// Returns whether the system is longitude and latitude of WGS 84, which is GeoJSON's default.
  bool is_wgs84() const;
};

/// Returns longitude and latitude of WGS 84, the system of GeoJSON and of GPS receivers.
Crs wgs84();

/// Returns the horizontal system of a name: "EPSG:28992", or its URN or URL of the OGC, in letters of either case.
/// Returns nothing for any other name and for systems of heights, such as EPSG:5703.
std::optional<Crs> crs_of_name(std::string_view name);

/// Returns the horizontal system of well-known text, of either version of the OGC's or of ESRI's, by its own AUTHORITY
/// or ID; of a compound system the horizontal part. Returns nothing if that has none, and for systems of heights.
std::optional<Crs> crs_of_wkt(std::string_view text);

/// Returns the meters in a unit of the projected system of well-known text; nothing if the text names no unit.
std::optional<double> unit_of_wkt(std::string_view text);

/// Returns the warning that a file's name of a system, which crs_of_name() does not know, is dropped.
std::string warning_on_crs(std::string_view name);

/// Throws BadInput unless two files name the same system, or neither names one.
void require_same_crs(const std::optional<Crs>& crs, const std::string& name, const std::optional<Crs>& first,
                      const std::string& first_name);

/// Parses the value of `--crs`. Throws WrongUsage naming the value.
Crs parse_crs(const std::string& text);

}  // namespace rbpa::app
