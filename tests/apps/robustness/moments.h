// What: how often each thing happens to each verb.
#pragma once

namespace robustness {

extern int moments;

}  // namespace robustness
