#include "support/read_points.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

namespace rbpa_test {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error(path.string() + ": cannot be opened");
  return {std::istreambuf_iterator<char>(stream), {}};
}

void append_text(const fs::path& path, Points& points) {
  const std::string text = contents(path);
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  for (std::size_t line = 1; at != end; ++line) {
    rbpa::Point p;
    for (double* coordinate : {&p.x, &p.y}) {
      at = std::find_if_not(at, end, blank);
      const auto [next, error] = std::from_chars(at, end, *coordinate);
      if (error != std::errc{})
        throw std::runtime_error(path.string() + ":" + std::to_string(line) + ": two numbers expected");
      at = next;
    }
    at = std::find_if_not(at, end, blank);
    if (at != end && *at++ != '\n')
      throw std::runtime_error(path.string() + ":" + std::to_string(line) + ": more than two numbers");
    points.push_back(p);
  }
}

double little_endian_double(const char* bytes) {
  std::uint64_t bits = 0;
  for (int i = 7; i >= 0; --i) bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
  return std::bit_cast<double>(bits);
}

void append_binary(const fs::path& path, Points& points) {
  const std::string bytes = contents(path);
  if (bytes.size() % 16 != 0) throw std::runtime_error(path.string() + ": not a whole number of points");
  for (std::size_t at = 0; at < bytes.size(); at += 16)
    points.push_back({little_endian_double(&bytes[at]), little_endian_double(&bytes[at + 8])});
}

}  // namespace

std::vector<PointFile> point_files(const fs::path& folder) {
  std::map<std::string, PointFile> by_name;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
    const fs::path& path = entry.path();
    if (path.extension() != ".xy" && path.extension() != ".f64xy") continue;
    std::string name = path.stem().string();
    if (const std::size_t part = name.rfind(".part"); part != std::string::npos) name.resize(part);
    by_name[name].name = name;
    by_name[name].parts.push_back(path);
  }
  std::vector<PointFile> files;
  for (auto& [name, file] : by_name) {
    std::sort(file.parts.begin(), file.parts.end(), [](const fs::path& a, const fs::path& b) {
      const std::string first = a.string(), second = b.string();
      return first.size() != second.size() ? first.size() < second.size() : first < second;  // part10 after part9
    });
    files.push_back(std::move(file));
  }
  return files;
}

Points read_points(const PointFile& file) {
  Points points;
  for (const fs::path& path : file.parts)
    path.extension() == ".xy" ? append_text(path, points) : append_binary(path, points);
  return points;
}

}  // namespace rbpa_test
