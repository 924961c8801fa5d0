// What: reads the faces of an OFF file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "meshops/topology/polygon_soup.h"

namespace rbpa_test {

struct MeshFile {
  std::string name;  ///< without folder and ending
  std::filesystem::path path;
};

/// Returns the .off files of a folder, sorted by name; none when there is no such folder.
std::vector<MeshFile> mesh_files(const std::filesystem::path& folder);

/// Reads a file. Throws std::runtime_error that names the file when it is incomplete.
meshops::PolygonSoup read_off(const MeshFile& file);

}  // namespace rbpa_test
