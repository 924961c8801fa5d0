#include "tiles/stream_arguments.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <system_error>

#include "io/failure.h"
#include "io/formats.h"
#include "io/number.h"
#include "io/polygon/ogr.h"
#include "stream/budget.h"

namespace rbpa::app {
namespace {

std::optional<StreamFormat> stream_format(std::string_view name) {
  if (const auto shape = find_format(Use::shape, name)) {
    if (*shape == Format::geojson) return StreamFormat::geojson;
    if (*shape == Format::wkt) return StreamFormat::wkt;
  }
  if (const auto mesh = find_format(Use::triangles, name)) {
    if (*mesh == Format::npy) return StreamFormat::npy;
    if (*mesh == Format::ply) return StreamFormat::ply;
  }
  return std::nullopt;
}

namespace fs = std::filesystem;

/// Returns the first five names, sorted: "a.las, b.las, c.las, d.las, e.las and 12 more".
std::string some_of(std::vector<std::string> names) {
  constexpr std::size_t shown = 5;
  std::sort(names.begin(), names.end());
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, names.size()); ++i) text += (i == 0 ? "" : ", ") + names[i];
  return text + (names.size() > shown ? " and " + std::to_string(names.size() - shown) + " more" : "");
}

std::string name_in_folder(const std::string& path) { return fs::path(path).filename().string(); }

/// Returns whether a file in a folder of LAS files has a format that may describe the LAS files, such as text or a
/// picture. Files of other formats contain points.
bool is_about_tiles(const std::string& path, Format format) {
  constexpr Format about[] = {Format::text, Format::geojson, Format::wkt, Format::png, Format::pgm, Format::ogr};
  return std::find(std::begin(about), std::end(about), format) != std::end(about) && input_ending(path) != "xyz";
}

/// The contents of a folder: paths of files of points, by format; names of entries that are left out; paths of point
/// clouds in formats that are not read.
struct FolderContent {
  std::map<Format, std::vector<std::string>> points = {};
  std::vector<std::string> left_out = {}, clouds = {};
};

FolderContent content_of(const std::string& folder) {
  FolderContent content;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string path = entry.path().string(), name = name_in_folder(path);
    const std::optional<Format> format = find_format(Use::points, input_ending(path));
    std::error_code unknown;
    if (entry.is_directory(unknown))
      content.left_out.push_back(name + "/");
    else if (!entry.is_regular_file(unknown))
      content.left_out.push_back(name + " (no regular file)");
    else if (!cloud_conversion(path).empty())
      content.clouds.push_back(path);
    else if (format)
      content.points[*format].push_back(path);
    else
      content.left_out.push_back(name);
  }
  if (error) throw Failure(folder + ": cannot read the folder: " + error.message());
  return content;
}

}  // namespace

std::string stream_formats(bool with_meshes) {
  std::string list =
      endings(Use::shape, [](Format format) { return format == Format::geojson || format == Format::wkt; }) + ", " +
      endings(Use::triangles, [](Format format) { return format == Format::npy; });
  return with_meshes ? list + ", or ply where the name has a '*'" : list;
}

std::vector<std::string> files_in(const std::string& folder, const PointArguments& arguments, bool quiet) {
  FolderContent content = content_of(folder);
  std::sort(content.clouds.begin(), content.clouds.end());
  if (!content.clouds.empty())
    bad_input(content.clouds.front(), "points in a format that is not read, in a folder whose files are all read",
              "a folder without them, or the names of files (" + cloud_conversion(content.clouds.front()) + ")");
  const bool has_tiles =
      !arguments.format && (content.points.contains(Format::las) || content.points.contains(Format::laz));
  std::vector<std::string> found, formats;
  for (auto& [format, paths] : content.points) {
    std::sort(paths.begin(), paths.end());
    const bool all_are_beside =
        has_tiles && std::all_of(paths.begin(), paths.end(),
                                 [format = format](const std::string& path) { return is_about_tiles(path, format); });
    if (all_are_beside) {
      for (const std::string& path : paths) content.left_out.push_back(name_in_folder(path));
      continue;
    }
    formats.push_back(name_in_folder(paths.front()));
    found.insert(found.end(), paths.begin(), paths.end());
  }
  if (formats.size() > 1 && !arguments.format)
    bad_input(folder, "points in files of several formats, such as " + some_of(formats),
              "one format, or the names of files");
  if (found.empty())
    bad_input(folder, "a folder without files of points", "files with one of the endings " + endings(Use::points));
  std::sort(found.begin(), found.end());
  if (quiet) return found;
  std::vector<std::string> names;
  for (const std::string& path : found) names.push_back(name_in_folder(path));
  say("rbpa", folder + ": " + counted(found.size(), "file") + (found.size() == 1 ? " is" : " are") + " read: " +
                  some_of(names) + (content.left_out.empty() ? "" : "; not read: " + some_of(content.left_out)));
  return found;
}

std::uint64_t parse_memory(const std::string& text) {
  constexpr std::string_view units = "KMGT";
  std::string digits = text;
  unsigned shift = 0;
  if (!digits.empty() && units.find(static_cast<char>(std::toupper(digits.back()))) != std::string_view::npos) {
    shift = 10 * static_cast<unsigned>(units.find(static_cast<char>(std::toupper(digits.back()))) + 1);
    digits.pop_back();
  }
  const ParsedNumber number = parse_whole_number(digits);
  const double bytes = std::ldexp(number.value, static_cast<int>(shift));
  if (number.fault != NumberFault::none || !(bytes >= static_cast<double>(least_memory)) || bytes > 0x1p60)
    bad_usage("--memory", in_quotes(text),
              "a size from " + std::to_string(least_memory >> 20U) + "M on, such as 500M or 1G");
  return static_cast<std::uint64_t>(bytes);
}

StreamTarget parse_stream_target(const std::string& path, const std::optional<std::string>& otherwise) {
  if (path.empty()) bad_usage("-o", "an empty name", "a path or -");
  std::optional<StreamFormat> format = path == "-" ? std::nullopt : stream_format(ending(path));
  if (!format && otherwise) format = stream_format(*otherwise);
  if (!format && otherwise) refuse_name("--output-format", *otherwise, stream_formats());
  if (!format && path == "-") throw WrongUsage("-o - requires --output-format: one of " + stream_formats(false));
  if (!format) refuse_ending(path, stream_formats(), "--output-format");
  if (*format == StreamFormat::ply) {
    const std::size_t star = path.rfind('*');
    if (star == std::string::npos || path.find('/', star) != std::string::npos)
      bad_usage(path, "no '*' in the name of the file", "one for the number of the tile: 'tiles/*.ply'");
  }
  return {path, *format};
}

}  // namespace rbpa::app
