#include "support/data_folder.h"

#include <cstdlib>

namespace rbpa_test {

std::filesystem::path bundled_data() { return RBPA_TEST_BUNDLED_DATA; }

std::filesystem::path further_data() {
  const char* const folder = std::getenv("RBPA_DATA_DIR");
  return folder == nullptr ? "" : folder;
}

bool has_further_data() { return !further_data().empty(); }

}  // namespace rbpa_test
