// What: marks the symbols that a shared librbpa exports; all other symbols are hidden.
#pragma once

#define RBPA_API __attribute__((visibility("default")))
