#include "stream/input_blocks.h"

#include <atomic>
#include <memory>

#include "io/cloud/point_blocks.h"
#include "io/interrupt.h"
#include "rbpa/base/read_ahead.h"

namespace rbpa::app {

void for_each_input_block(std::span<const PointSource> sources, const InputPlace& from, PassProgress& progress,
                          const std::function<void(const InputBlock&)>& visit) {
  InputPlace at = from;
  std::unique_ptr<PointBlocks> file;  // null until the next file is open
  std::atomic<std::uint64_t> bytes = at.bytes;
  ReadAhead<InputBlock> blocks(1, 4, [&](InputBlock& block) {
    if (at.files >= sources.size()) return false;
    if (!file) file = open_point_blocks(sources[at.files]);
    block.first = at.points;
    block.file = at.files;
    block.ends_file = !file->next(block.points);
    block.fields = file->fields();
    bytes = at.bytes + file->bytes_read();
    at.points += block.points.size();
    if (block.ends_file) {
      block.about = file->about();
      file = nullptr;
      at.bytes = bytes;
      ++at.files;
    }
    return true;
  });
  for (InputBlock block; blocks.next(block);) {
    stop_if_interrupted();
    visit(block);
    progress.at(bytes, block.first + block.points.size());
  }
}

}  // namespace rbpa::app
