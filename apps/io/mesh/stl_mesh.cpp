#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/equal_positions.h"
#include "io/mesh/read_mesh.h"
#include "io/number.h"
#include "io/scalar.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {
namespace {

/// Numbers the corners of facets; corners at equal positions have one number.
class Corners {
 public:
  explicit Corners(MeshFile& mesh, std::size_t places = 0) : mesh_(mesh), places_(places) {}

  std::uint32_t number(Position p, std::optional<std::size_t> line) {
    for (double& coordinate : p) coordinate += 0.0;  // −0 becomes +0
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.push_back(p);
    const std::uint32_t first = places_.first_at(mesh_.positions, next);
    if (first != next)
      mesh_.positions.pop_back();
    else if (line)
      mesh_.point_lines.push_back(*line);
    return first;
  }

 private:
  MeshFile& mesh_;
  EqualPositions places_;
};

constexpr std::size_t header_size = 84, facet_size = 50;

std::size_t announced_facets(std::string_view bytes) {
  return load<std::uint32_t>(bytes.data() + header_size - 4, std::endian::little);
}

bool begins_with_word(const Lines& lines, std::string_view word) {
  std::string_view rest = lines.line();
  return same_letters(take_word(rest), word);
}

/// Returns whether the file is binary: its size fits the number of facets, or its bytes are not text. A binary file may
/// also begin with "solid".
bool is_binary(std::string_view bytes) {
  if (bytes.size() >= header_size && bytes.size() == header_size + facet_size * announced_facets(bytes)) return true;
  Lines lines(bytes);
  if (!lines.next_with_content()) return false;
  if (!begins_with_word(lines, "solid")) return true;
  if (lines.next_with_content() && (begins_with_word(lines, "facet") || begins_with_word(lines, "endsolid")))
    return false;
  return bytes.find('\0') != std::string_view::npos;
}

/// Reads `facets` facets. next(facet) returns the place where the facet after `facet` begins.
template <typename Next>
MeshFile facets_at(std::string_view bytes, std::size_t facets, const std::string& name, const Next& next) {
  MeshFile mesh;
  Corners corners(mesh, facets / 2);  // about the number of vertices of a closed surface
  mesh.reserve_faces(facets);
  const char* facet = bytes.data() + header_size;
  for (std::size_t f = 0; f < facets; ++f, facet = next(facet)) {
    if (f % 16384 == 0) stop_if_interrupted();
    const char* at = facet + 3 * sizeof(float);  // after the normal
    std::array<std::uint32_t, 3> cycle{};
    for (std::uint32_t& corner : cycle) {
      Position p{};
      for (double& coordinate : p) {
        coordinate = static_cast<double>(load<float>(at, std::endian::little));
        at += sizeof(float);
        if (!std::isfinite(coordinate))
          bad_input(name + ": facet " + std::to_string(f), in_quotes(text_of(coordinate)), "a finite number");
      }
      corner = corners.number(p, std::nullopt);
    }
    mesh.soup.add_face(cycle);
  }
  return mesh;
}

/// Returns the end of the attributes after a facet; the last two bytes of the facet have their size.
const char* behind_attributes(const char* facet) {
  return facet + facet_size + load<std::uint16_t>(facet + facet_size - 2, std::endian::little);
}

/// Returns whether `bytes` are exactly `facets` facets, each with its attributes.
bool have_attributes(std::string_view bytes, std::size_t facets) {
  const char* at = bytes.data() + header_size;
  const char* const end = bytes.data() + bytes.size();
  for (; facets > 0 && static_cast<std::size_t>(end - at) >= facet_size; --facets) {
    const char* const next = behind_attributes(at);
    if (static_cast<std::size_t>(next - at) > static_cast<std::size_t>(end - at)) return false;
    at = next;
  }
  return facets == 0 && at == end;
}

MeshFile read_binary(std::string_view bytes, const std::string& name) {
  if (bytes.size() < header_size)
    bad_input(
        name, counted(bytes.size(), "byte"),
        "text that begins with 'solid', or at least the " + std::to_string(header_size) + " bytes of a binary header");
  const std::size_t facets = announced_facets(bytes), end = header_size + facet_size * facets;
  if (bytes.size() < end)
    bad_input(
        name, counted(bytes.size(), "byte"),
        std::to_string(end) + " for the " + counted(facets, "facet") + " that the header counts in bytes 80 to 83");
  const std::size_t behind = bytes.size() - end;
  const bool are_attributes = behind > 0 && have_attributes(bytes, facets);
  MeshFile mesh = facets_at(bytes, facets, name, [&](const char* facet) {
    return are_attributes ? behind_attributes(facet) : facet + facet_size;
  });
  if (behind > 0)
    mesh.warnings.push_back(counted(behind, "byte") + (are_attributes ? " of attributes " : " after the last facet ") +
                            (behind == 1 ? "is" : "are") + " left out");
  return mesh;
}

class AsciiReader {
 public:
  AsciiReader(std::string_view text, const std::string& name) : lines_(text), name_(name) {}

  MeshFile read() {
    while (lines_.next_with_content()) {
      if (ends_file()) break;
      if (!begins_with("solid")) refuse("solid");
      while (!next_ends_solid()) read_facet();
    }
    return std::move(mesh_);
  }

 private:
  /// Returns whether only zero bytes and end-of-file marks follow, with which programs and disks pad a text.
  bool ends_file() {
    constexpr std::string_view blank("\0\x1a \t\r\n", 6);
    const std::string_view line = lines_.line(), rest = lines_.rest();
    if (line.find_first_not_of(blank) != std::string_view::npos) return false;
    if (rest.find_first_not_of(blank) != std::string_view::npos) return false;
    const std::size_t left_out = line.size() + rest.size();
    mesh_.warnings.push_back(counted(left_out, "byte") + " after the last solid " + (left_out == 1 ? "is" : "are") +
                             " left out");
    return true;
  }

  /// Goes to the next line; returns whether it ends a solid and does not begin a facet.
  bool next_ends_solid() {
    next("facet or endsolid");
    if (begins_with("endsolid")) return true;
    if (!begins_with("facet")) refuse("facet or endsolid");
    return false;
  }

  void read_facet() {
    mesh_.face_lines.push_back(lines_.number());
    next_begins_with("outer loop");
    std::array<std::uint32_t, 3> cycle{};
    for (std::uint32_t& corner : cycle) {
      next_begins_with("vertex");
      std::string_view rest = lines_.line();
      take_word(rest);
      corner = corners_.number(take_position(rest, lines_, name_), lines_.number());
      if (!trimmed(rest).empty()) refuse("one vertex of three numbers a line");
    }
    next_begins_with("endloop");
    next_begins_with("endfacet");
    mesh_.soup.add_face(cycle);
  }

  void next(const std::string& expected) {
    if (!lines_.next_with_content()) bad_input(name_, "the end of the file", expected);
  }
  void next_begins_with(const std::string& words) {
    next(words);
    if (!begins_with(words)) refuse(words);
  }
  bool begins_with(std::string_view words) const {
    std::string_view rest = lines_.line();
    while (!words.empty())
      if (!same_letters(take_word(rest), take_word(words))) return false;
    return true;
  }
  [[noreturn]] void refuse(const std::string& expected) const {
    bad_input(at_line(name_, lines_.number()), in_quotes(lines_.line()), expected);
  }

  Lines lines_;
  const std::string& name_;
  MeshFile mesh_ = {};
  Corners corners_{mesh_};
};

}  // namespace

MeshFile as_stl_mesh(const SinglePositions& positions, std::span<const std::array<std::uint32_t, 3>> triangles) {
  MeshFile mesh;
  Corners corners(mesh, triangles.size() / 2);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (f % 16384 == 0) stop_if_interrupted();
    std::array<std::uint32_t, 3> cycle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [x, y, z] = positions.at[triangles[f][k]];
      cycle[k] = corners.number({x, y, z}, std::nullopt);
    }
    mesh.soup.add_face(cycle);
  }
  mesh.soup.points = mesh.positions.size();
  return mesh;
}

MeshFile read_stl_mesh(std::string_view bytes, const std::string& name) {
  return is_binary(bytes) ? read_binary(bytes, name) : AsciiReader(bytes, name).read();
}

}  // namespace rbpa::app
