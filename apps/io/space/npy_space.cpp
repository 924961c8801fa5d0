#include <array>

#include "io/interrupt.h"
#include "io/points/npy_points.h"
#include "io/space/readers.h"

namespace rbpa::app {

SpacePoints read_npy_space(std::string_view bytes, const std::string& name) {
  const NpyLayout array = read_npy_layout(bytes, bytes.size(), name, {3, 6});
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
