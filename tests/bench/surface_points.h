// What: points with normals on surfaces, with a given spacing, for the contest of ball pivoting.
// Law:  a set is a function of the arguments alone, except for the last bits of sines and cosines.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa_bench {

struct SurfacePoints {
  std::string name;
  std::vector<rbpa::Point3> points, normals;
  double spacing;  ///< square root of the area per point
};

/// Returns points on the unit sphere along a golden spiral, which are evenly spread; each is then moved at random by up
/// to 0.2
/// spacings along the sphere, and by up to `noise` spacings along the normal.
SurfacePoints on_sphere(std::size_t count, double noise);

/// Returns about `count` points on two merged tori, of genus 2: around the tubes of both in rings one spacing apart,
/// with points of neighboring rings half a spacing apart. They are moved like those of the sphere, and brought to the
/// common surface. Of two points nearer than half a spacing to each other, which occur where the tori meet, one is
/// kept.
SurfacePoints on_double_torus(std::size_t count);

// Sets on which a point may cost much more than on a smooth surface.

/// Returns points on a torus as from a scanner with lines: the spacing is that of the lines, and points along a line
/// are a twentieth of it apart.
SurfacePoints on_scan_lines(std::size_t count);
/// Returns on_sphere(), and one point in twenty anywhere in a cube of four times its width.
SurfacePoints with_outliers(std::size_t count);
/// Returns ground and facades around a scanner, up to a hundred times as dense near it as far away; the spacing is that
/// of the farthest tenth.
SurfacePoints on_street(std::size_t count);
/// Returns all points of an integer grid in a cube: ties of every kind.
SurfacePoints on_grid(std::size_t count);
/// Returns on_sphere() with each point ten times.
SurfacePoints ten_times(std::size_t count);

}  // namespace rbpa_bench
