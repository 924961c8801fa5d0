// What: the folders of point sets from outside the project.
#pragma once

#include <filesystem>

namespace rbpa_test {

/// Returns tests/data of the source tree.
std::filesystem::path bundled_data();

/// Returns the folder that the environment variable RBPA_DATA_DIR names; empty if it names none. Names of test cases
/// that read it begin with "further".
std::filesystem::path further_data();

/// Returns whether that folder exists. Without it, the test cases of further data check nothing; with it, they require
/// files.
bool has_further_data();

}  // namespace rbpa_test
