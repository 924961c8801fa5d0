#include <array>

#include "io/claim.h"
#include "io/interrupt.h"
#include "io/points/npy_points.h"
#include "io/space/readers.h"

namespace rbpa::app {

namespace {

NpyLayout layout_of(std::string_view bytes, std::size_t size, const std::string& name) {
  return read_npy_layout(bytes, size, name, {3, 6});
}

}  // namespace

double claimed_npy_space_size(std::string_view first, const std::string& name) {
  return layout_of(first, unknown_size, name).end();
}

SpacePoints read_npy_space(std::string_view bytes, const std::string& name) {
  const NpyLayout array = layout_of(bytes, bytes.size(), name);
  const char* data = bytes.data() + array.data;
  const std::size_t next_row = array.columns_first ? array.item() : array.row();
  const std::size_t next_column = array.columns_first ? array.rows * array.item() : array.item();
  SpacePoints file;
  reserve_points(file, array.rows, array.columns == 6, false);
  std::array<double, 6> value{};
  for (std::size_t i = 0; i < array.rows; ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    for (std::size_t k = 0; k < array.columns; ++k)
      value[k] = load_number(array.type, data + i * next_row + k * next_column, array.order);
    append_numbers({value.data(), array.columns}, file, name);
  }
  return file;
}

}  // namespace rbpa::app
