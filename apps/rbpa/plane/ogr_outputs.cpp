#include "plane/ogr_outputs.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include "io/failure.h"

namespace rbpa::app {

void add_ogr(Run& run, const Target& target, const std::vector<OgrFile>& files) {
  const std::vector<std::string> endings = ogr_endings(target.format), paths = ogr_paths(target);
  for (std::size_t i = 0; i < endings.size(); ++i) {
    const auto made =
        std::find_if(files.begin(), files.end(), [&](const OgrFile& file) { return file.ending == endings[i]; });
    if (made != files.end())
      run.add(paths[i], [&](OutputFile& file) { file.write(made->bytes); });
    else if (std::filesystem::exists(paths[i]))
      // Refuse an old .prj: its coordinate system would apply to the new file.
      throw Failure(paths[i] + ": found an old file, expected none next to " + target.path + " (remove it)");
  }
}

}  // namespace rbpa::app
