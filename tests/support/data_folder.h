// What: where the tests find point sets that nobody of the project made.
#pragma once

#include <filesystem>

namespace rbpa_test {

/// tests/data of the source tree.
std::filesystem::path bundled_data();

/// The folder that the environment variable RBPA_DATA_DIR names; empty where it names none. Test cases that read it have
/// names that begin with "further".
std::filesystem::path further_data();

/// Whether there is such a folder. Without it the test cases of further data check nothing; with it they require files.
bool has_further_data();

}  // namespace rbpa_test
