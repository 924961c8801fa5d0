// What: polygons as files of geographic information systems, one after the other.
// Law:  the bytes depend on what is added alone; coordinates read back to the same doubles.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "io/crs.h"
#include "io/output_file.h"
#include "rbpa/base/point.h"

namespace rbpa::app {

/// What is known of a polygon beside its rings.
struct PolygonFacts {
  double area = 0;
  double perimeter = 0;
  std::uint64_t holes = 0;
  std::uint64_t points = 0;  ///< in it and in none before it
};

/// Who takes polygons ring by ring.
class PolygonSink {
 public:
  PolygonSink() = default;
  virtual ~PolygonSink() = default;
  PolygonSink(const PolygonSink&) = delete;
  PolygonSink& operator=(const PolygonSink&) = delete;

  /// Its rings follow: the shell, then the holes, whose first points are not repeated; then end().
  virtual void begin(const PolygonFacts& facts) = 0;
  virtual void ring(std::span<const Point> points) = 0;
  virtual void end() = 0;
  /// That were all polygons.
  virtual void finish() = 0;
};

/// GeoJSON (RFC 7946): a FeatureCollection with one Feature for each polygon, whose properties are "number", from 1,
/// "area", "perimeter", "holes", how many, and "points". An area beyond the range of double is null. A system other than
/// WGS 84 is a member "crs".
class GeojsonWriter final : public PolygonSink {
 public:
  GeojsonWriter(OutputFile& file, const std::optional<Crs>& crs);
  void begin(const PolygonFacts& facts) override;
  void ring(std::span<const Point> points) override;
  void end() override;
  void finish() override;

 private:
  OutputFile& file_;
  std::uint64_t number_ = 0;
  bool any_ring_ = false;
};

/// Well-known text: one MULTIPOLYGON, or MULTIPOLYGON EMPTY.
class WktWriter final : public PolygonSink {
 public:
  explicit WktWriter(OutputFile& file) : file_(file) {}
  void begin(const PolygonFacts& facts) override;
  void ring(std::span<const Point> points) override;
  void end() override;
  void finish() override;

 private:
  OutputFile& file_;
  bool any_ = false, any_ring_ = false;
};

}  // namespace rbpa::app
