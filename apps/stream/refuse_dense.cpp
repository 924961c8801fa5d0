#include "stream/refuse_dense.h"

#include <string>

#include "io/bytes/number.h"
#include "io/failure.h"

namespace rbpa::app {

void refuse_dense(const TooDense& dense, const StreamRequest& request, const Budget& budget) {
  constexpr std::uint64_t megabyte = std::uint64_t{1} << 20U;
  const auto megabytes = [](std::uint64_t bytes) { return std::to_string((bytes + megabyte - 1) / megabyte) + "M"; };
  throw Failure("--memory " + megabytes(request.memory) + ": found " + counted(dense.points, "point") +
                " within 2 alpha = " + text_of(2 * request.alpha) + " of each other near (" + text_of(dense.where.x) +
                ", " + text_of(dense.where.y) + "), expected at most " + std::to_string(budget.tile_points) +
                "; --memory " + megabytes(memory_for(dense.points + dense.points / 4, request.threads)) +
                " would do, or a smaller alpha");
}

}  // namespace rbpa::app
