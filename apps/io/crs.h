// What: coordinate reference systems, as files and people name them.
// Law:  a name is carried from input to output; no coordinate is changed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rbpa::app {

struct Crs {
  std::string authority;  ///< "EPSG"; "OGC" of CRS84
  std::string code;       ///< "28992"
  bool degrees = false;   ///< geographic: x is a longitude and y a latitude

  /// "EPSG:28992".
  std::string text() const { return authority + ":" + code; }
  /// "urn:ogc:def:crs:EPSG::28992".
  std::string urn() const;
  /// "28992", the number that PostGIS knows it by; nothing where it has none.
  std::optional<std::string> srid() const;
  /// Longitude and latitude of WGS 84, which GeoJSON means by itself.
  bool is_wgs84() const;
};

/// What GeoJSON and GPS receivers have.
Crs wgs84();

/// "EPSG:28992", or the same as a URN or URL of the OGC. Letters may be of either case. A system of heights, such as
/// EPSG:5703, is none.
std::optional<Crs> crs_of_name(std::string_view name);

/// The system of the plane in well-known text of the OGC, of either version, or of ESRI: the horizontal part of a compound
/// system, by its own AUTHORITY or ID; nothing when it has none. A system of heights is none.
std::optional<Crs> crs_of_wkt(std::string_view text);

/// The factor to meters that well-known text names as the unit of its projected system; nothing when it has none.
std::optional<double> unit_of_wkt(std::string_view text);

/// Why a file's name of a system, which crs_of_name() does not know, is not carried over.
std::string remark_on_crs(std::string_view name);

/// Throws BadInput unless two files name one system, or neither does: coordinates of two have nothing in common.
void require_same_crs(const std::optional<Crs>& crs, const std::string& name, const std::optional<Crs>& first,
                      const std::string& first_name);

/// `--crs`. Throws WrongUsage naming the value.
Crs parse_crs(const std::string& text);

}  // namespace rbpa::app
