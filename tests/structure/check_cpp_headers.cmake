cmake_minimum_required(VERSION 3.22)
# Fails if docs/reference/cpp_headers.md is not the table of the public headers and their "What:" lines. Regenerate it by
#   cmake -DROOT=. -DWRITE=ON -P tests/structure/check_cpp_headers.cmake
# Public headers are directly in these folders: in librbpa those of PublicHeaders.cmake; in libmeshops, which installs all headers, those that are not in a namespace detail.
set(librbpa_folders rbpa rbpa/plane rbpa/fill rbpa/space/solid rbpa/space/surface rbpa/space/normals rbpa/space/repair rbpa/space/simplify rbpa/space/persistence rbpa/space/balls rbpa/base)
set(libmeshops_folders meshops meshops/core meshops/handle meshops/stellar meshops/history meshops/patch meshops/front
  meshops/topology meshops/graph meshops/simplify)
get_filename_component(ROOT "${ROOT}" ABSOLUTE)
include(${ROOT}/librbpa/cmake/PublicHeaders.cmake)
set(page ${ROOT}/docs/reference/cpp_headers.md)

set(text "# C++ headers

`tests/structure/check_cpp_headers.cmake` makes this page of the `What:` lines of the headers that are installed. What a function promises is
at its declaration: law, cost, source, what it requires and throws. [A C++ project](../how_to/cpp_project.md) says how the libraries are
found by CMake, and [architecture](../explanation/architecture.md) what is behind the headers.
")
set(count 0)
foreach(library librbpa libmeshops)
  foreach(folder IN LISTS ${library}_folders)
    string(APPEND text "\n## ${folder}\n\n| header | what it has |\n|---|---|\n")
    file(GLOB headers RELATIVE ${ROOT}/${library} ${ROOT}/${library}/${folder}/*.h)
    list(SORT headers)
    foreach(header IN LISTS headers)
      file(READ ${ROOT}/${library}/${header} source)
      string(FIND "${source}" "\nnamespace meshops::detail {" inner)
      if((library STREQUAL "librbpa" AND NOT header IN_LIST rbpa_public_headers) OR NOT inner EQUAL -1)
        continue()
      endif()
      # The comment continues as long as lines are indented.
      if(NOT source MATCHES "// What: +([^\n]*(\n//   +[^\n]*)*)")
        message(FATAL_ERROR "${library}/${header} has no line \"// What:\"")
      endif()
      string(REGEX REPLACE "\n// +" " " what "${CMAKE_MATCH_1}")
      string(APPEND text "| `${header}` | ${what} |\n")
      math(EXPR count "${count} + 1")
    endforeach()
  endforeach()
endforeach()
if(count LESS 100)
  message(FATAL_ERROR "only ${count} public headers found in ${ROOT}: the check looks in the wrong place")
endif()

if(WRITE)
  file(WRITE ${page} "${text}")
endif()
file(READ ${page} is)
if(NOT is STREQUAL text)
  message(FATAL_ERROR "${page} is not what the headers say: write it anew by\n"
    "  cmake -DROOT=. -DWRITE=ON -P tests/structure/check_cpp_headers.cmake")
endif()
message(STATUS "${count} public headers are in ${page}")
