// What: where the tests find point sets that nobody of the project made.
#pragma once

#include <filesystem>

namespace rbpa_test {

/// tests/data of the source tree.
std::filesystem::path bundled_data();

/// The larger collection, of which tests/data holds what may be passed on: the environment variable RBPA_DATA_DIR, else
/// the folder that CMake was given under the same name. It need not exist.
std::filesystem::path further_data();

}  // namespace rbpa_test
