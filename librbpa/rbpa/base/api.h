// What: marks what a shared librbpa shows to others; everything else in it is hidden.
#pragma once

#define RBPA_API __attribute__((visibility("default")))
