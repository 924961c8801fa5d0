// What: marks the symbols that a shared libmeshops exports; all others are hidden.
#pragma once

#define MESHOPS_API __attribute__((visibility("default")))
