// What: marks what a shared libmeshops shows to others; everything else in it is hidden.
#pragma once

#define MESHOPS_API __attribute__((visibility("default")))
