#include "support/data_folder.h"

#include <cstdlib>

namespace rbpa_test {

std::filesystem::path bundled_data() { return RBPA_TEST_BUNDLED_DATA; }

std::filesystem::path further_data() {
  const char* const chosen = std::getenv("RBPA_DATA_DIR");
  return chosen != nullptr ? chosen : RBPA_TEST_FURTHER_DATA;
}

}  // namespace rbpa_test
