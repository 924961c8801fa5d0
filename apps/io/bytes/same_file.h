// What: finds the file behind a path; refuses runs that would overwrite their input, write one file twice, or write
//       into a folder that does not exist.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rbpa::app {

/// Returns the path of the file to which `path` leads by symbolic links; the file need not exist. Renaming a file to
/// the returned path replaces the file, not a link. Throws Failure for a loop of links.
std::string behind_links(const std::string& path);

/// Returns the path of the world file, .pgw, of a picture .png; nothing for files with other endings.
std::optional<std::string> world_file_of(const std::string& path);

/// Checks the names of output files before a long run. World files of `outputs` count as outputs, too. Throws
/// WrongUsage if a name is empty, if two outputs are, or will be, the same file, or if one is `input`, which messages
/// call the file of `content`; Failure if a name is a folder or a loop of symbolic links, or if the folder of a file
/// does not exist. Outputs may be the same device. "-" is standard output among `outputs` and standard input as
/// `input`; each counts as the file to which it is redirected.
void require_different(const std::vector<std::string>& outputs, const std::string& input, const std::string& content);

}  // namespace rbpa::app
