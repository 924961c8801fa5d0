#include "oracle/read_off.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rbpa_test {

std::vector<MeshFile> mesh_files(const std::filesystem::path& folder) {
  std::vector<MeshFile> files;
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".off") files.push_back({entry.path().stem().string(), entry.path()});
  std::sort(files.begin(), files.end(), [](const MeshFile& a, const MeshFile& b) { return a.name < b.name; });
  return files;
}

meshops::PolygonSoup read_off(const MeshFile& file) {
  // After comments are removed, the rest is words.
  std::ifstream stream(file.path);
  std::stringstream words;
  for (std::string line; std::getline(stream, line);) words << line.substr(0, line.find('#')) << '\n';

  std::string magic;
  std::size_t points = 0, faces = 0, edges = 0;
  words >> magic >> points >> faces >> edges;
  meshops::PolygonSoup soup;
  soup.points = points;
  for (double coordinate = 0; points > 0; --points) words >> coordinate >> coordinate >> coordinate;
  std::vector<std::uint32_t> corners;
  for (std::size_t length = 0; faces > 0 && words >> length; --faces) {
    corners.resize(length);
    for (std::uint32_t& corner : corners) words >> corner;
    soup.add_face(corners);
  }
  if (magic != "OFF" || !words || faces > 0) throw std::runtime_error(file.path.string() + ": not an OFF file");
  return soup;
}

}  // namespace rbpa_test
