# The common basis of both libraries: required packages, compile options, installation.
option(RBPA_WARNINGS_AS_ERRORS "Turn compiler warnings into errors" OFF)
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
set(RBPA_LEAST_BOOST 1.74)
if(NOT RBPA_ARRAYS_ONLY)
  find_package(OpenMeshCore REQUIRED)
endif()
find_package(Boost ${RBPA_LEAST_BOOST} REQUIRED)
include(InstallLibrary)

# Compile options of all targets of the project, but not of its consumers.
add_library(rbpa_development INTERFACE)
target_compile_features(rbpa_development INTERFACE cxx_std_20)
target_compile_options(rbpa_development INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
  # With sizes of 32 bits other conversions are narrowing.
  $<$<NOT:$<BOOL:${EMSCRIPTEN}>>:-Wconversion> $<$<NOT:$<BOOL:${EMSCRIPTEN}>>:-Wsign-conversion>
  $<$<BOOL:${RBPA_WARNINGS_AS_ERRORS}>:-Werror>
  # Fused multiply-add would break the splitting that exact products are based on (predicate/expansion.h).
  -ffp-contract=off
  # The code reads neither errno nor floating-point exceptions; without them, loops of selections vectorize.
  -fno-math-errno -fno-trapping-math)
# If several sources are compiled at a time, names of one hide names of another, which is no fault.
if(RBPA_COMPILE_TOGETHER)
  add_library(rbpa_together INTERFACE)
  target_compile_options(rbpa_together INTERFACE -Wno-shadow)
endif()
