#include "io/las/las_count.h"

#include "io/failure.h"

namespace rbpa::app {

std::size_t LasCount::settle(bool skip_invalid, const std::string& name, std::vector<std::string>& remarks) const {
  if (claimed_ == room_) return room_;
  const bool too_high = claimed_ > room_;
  if (!skip_invalid)
    bad_input(name, counted(room_, "whole record") + " of " + counted(length_, "byte"),
              std::to_string(claimed_) + " as the header says (--skip-invalid reads " +
                  (too_high        ? "those that are whole)"
                   : claimed_ == 0 ? "all of them)"
                                   : "as many as it says)"));
  if (takes_all(skip_invalid)) {
    remarks.push_back("the header says that there are no points, and " +
                      (room_ == 1 ? "the whole record behind it is"
                                  : "all " + std::to_string(room_) + " whole records behind it are") +
                      " read");
    return room_;
  }
  if (too_high) {
    remarks.push_back(std::to_string(claimed_ - room_) + " of " + counted(claimed_, "point") +
                      " that the header says are left out: the file ends before them");
    return room_;
  }
  const std::size_t more = room_ - claimed_;
  remarks.push_back(counted(more, "whole record") + " behind the " + counted(claimed_, "point") +
                    " that the header says " + (more == 1 ? "is" : "are") + " left out");
  return claimed_;
}

}  // namespace rbpa::app
