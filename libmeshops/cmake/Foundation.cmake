# What both libraries rest on: the packages that they need, what they are compiled with, how they are installed.
option(RBPA_WARNINGS_AS_ERRORS "Turn compiler warnings into errors" OFF)
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
set(RBPA_LEAST_BOOST 1.74)
if(NOT RBPA_ARRAYS_ONLY)
  find_package(OpenMeshCore REQUIRED)
endif()
find_package(Boost ${RBPA_LEAST_BOOST} REQUIRED)
include(InstallLibrary)
include(ForwardHeaders)

# What every target of the project is compiled with, and no consumer of it.
add_library(rbpa_development INTERFACE)
target_compile_features(rbpa_development INTERFACE cxx_std_20)
target_compile_options(rbpa_development INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
  # Where sizes have 32 bits other conversions are narrow.
  $<$<NOT:$<BOOL:${EMSCRIPTEN}>>:-Wconversion> $<$<NOT:$<BOOL:${EMSCRIPTEN}>>:-Wsign-conversion>
  $<$<BOOL:${RBPA_WARNINGS_AS_ERRORS}>:-Werror>
  # A fused multiply-add breaks the splitting on which exact products rest (predicate/expansion.h).
  -ffp-contract=off
  # Nothing here reads errno or floating-point exceptions; without them loops of selections vectorise.
  -fno-math-errno -fno-trapping-math)
