cmake_minimum_required(VERSION 3.22)
# Fails if a file includes one from a folder that its own folder must not include.
# Each line has a folder and the folders that it may include; a folder may always include itself.
set(allowed
  "meshops: meshops/core meshops/front meshops/graph meshops/handle meshops/history meshops/patch meshops/stellar
    meshops/topology"
  "meshops/front: meshops/core meshops/handle meshops/patch"
  "meshops/graph: meshops/core"
  "meshops/handle: meshops/core"
  "meshops/history: meshops/core meshops/handle meshops/stellar"
  "meshops/patch: meshops/core"
  "meshops/stellar: meshops/core"
  "meshops/topology: meshops/core meshops/graph meshops/handle meshops/stellar"

  "rbpa/base: meshops/core rbpa/base/parallel"
  "rbpa/base/exact: rbpa/base"
  "rbpa/base/sort: meshops/core meshops/patch rbpa/base rbpa/base/parallel"
  "rbpa: meshops/core meshops/front meshops/stellar rbpa/base"
  "rbpa/plane: meshops/core meshops/topology rbpa rbpa/base rbpa/base/exact rbpa/base/parallel rbpa/base/sort rbpa/plane/arrays rbpa/plane/divide
    rbpa/plane/grid rbpa/plane/hierarchy rbpa/plane/mesh rbpa/plane/patches rbpa/plane/predicate"
  "rbpa/plane/arrays: meshops/core meshops/patch rbpa rbpa/base rbpa/base/parallel rbpa/base/sort rbpa/plane/predicate"
  "rbpa/plane/divide: meshops/core meshops/patch rbpa rbpa/base rbpa/base/parallel rbpa/plane/arrays rbpa/plane/predicate"
  "rbpa/plane/enumeration: rbpa/base/lanes rbpa/plane/predicate rbpa/plane/tile"
  "rbpa/plane/filtration: meshops/core rbpa rbpa/base rbpa/plane/arrays rbpa/plane/predicate rbpa/plane/shape"
  "rbpa/plane/grid: meshops/core rbpa/base rbpa/base/exact rbpa/base/parallel rbpa/base/sort rbpa/plane/predicate"
  "rbpa/plane/groups: rbpa rbpa/base rbpa/base/parallel rbpa/plane/filtration rbpa/plane/shape"
  "rbpa/plane/hierarchy: meshops/core meshops/front meshops/patch rbpa rbpa/base rbpa/base/parallel rbpa/base/sort
    rbpa/plane/filtration rbpa/plane/grid rbpa/plane/mesh rbpa/plane/patches rbpa/plane/predicate"
  "rbpa/plane/mesh: meshops/core meshops/front meshops/patch rbpa rbpa/base rbpa/plane/grid"
  "rbpa/plane/partial: meshops/core rbpa rbpa/base rbpa/plane/predicate rbpa/plane/shape"
  "rbpa/plane/patches: meshops/patch rbpa/plane/enumeration rbpa/plane/pivots rbpa/plane/remainder rbpa/plane/tile"
  "rbpa/plane/pivots: rbpa/base/lanes rbpa/plane/predicate rbpa/plane/tile"
  "rbpa/plane/predicate: rbpa/base rbpa/base/exact"
  "rbpa/plane/remainder: meshops/patch rbpa/base/parallel rbpa/plane/divide rbpa/plane/grid rbpa/plane/predicate
    rbpa/plane/tile"
  "rbpa/plane/shape: meshops/core rbpa rbpa/base rbpa/base/exact rbpa/plane/predicate"
  "rbpa/plane/tile: meshops/patch rbpa/base rbpa/base/parallel rbpa/plane/grid rbpa/plane/predicate"
  "rbpa/space: meshops/core meshops/front meshops/handle meshops/patch rbpa rbpa/base rbpa/base/exact rbpa/base/parallel rbpa/base/sort rbpa/space/boundary rbpa/space/cells
    rbpa/space/closing rbpa/space/full rbpa/space/insertion rbpa/space/levels
    rbpa/space/normals rbpa/space/periodic rbpa/space/persistence rbpa/space/pivot rbpa/space/predicate rbpa/space/refining rbpa/space/spacing rbpa/space/star rbpa/space/tiles rbpa/space/triples"
  "rbpa/space/boundary: meshops/core rbpa rbpa/base rbpa/base/exact rbpa/space/levels rbpa/space/predicate"
  "rbpa/space/cells: rbpa/base rbpa/base/exact rbpa/base/parallel rbpa/base/sort"
  "rbpa/space/closing: meshops/core rbpa/base rbpa/space rbpa/space/predicate"
  "rbpa/space/full: meshops/core rbpa rbpa/base rbpa/base/exact rbpa/base/parallel rbpa/space rbpa/space/predicate"
  "rbpa/space/insertion: meshops/core rbpa/base rbpa/space rbpa/space/predicate"
  "rbpa/space/levels: rbpa rbpa/base rbpa/space/cells"
  "rbpa/space/normals: meshops/core rbpa rbpa/base rbpa/base/parallel rbpa/space/cells"
  "rbpa/space/periodic: rbpa rbpa/base rbpa/base/exact rbpa/space rbpa/space/full"
  "rbpa/space/persistence: meshops/core rbpa rbpa/base rbpa/base/parallel rbpa/space/predicate"
  "rbpa/space/pivot: rbpa/space/predicate"
  "rbpa/space/predicate: rbpa/base rbpa/base/exact rbpa/base/lanes"
  "rbpa/space/refining: meshops/core meshops/stellar rbpa rbpa/space/predicate"
  "rbpa/space/spacing: rbpa/base"
  "rbpa/space/star: meshops/core rbpa rbpa/base rbpa/base/lanes rbpa/base/parallel rbpa/space/cells rbpa/space/pivot rbpa/space/predicate"
  "rbpa/space/tiles: meshops/core rbpa/base rbpa/base/lanes rbpa/base/parallel rbpa/base/sort rbpa/space rbpa/space/insertion
    rbpa/space/predicate"
  "rbpa/space/triples: meshops/core rbpa/base rbpa/base/lanes rbpa/base/parallel rbpa/space/cells rbpa/space/predicate"
  "rbpa/fill: meshops/core meshops/front meshops/patch meshops/stellar meshops/topology rbpa rbpa/base rbpa/base/exact
    rbpa/plane/grid rbpa/plane/mesh rbpa/plane/predicate rbpa/plane/shape"
  "rbpa/paper: meshops/core meshops/front meshops/patch rbpa rbpa/base rbpa/plane/hierarchy rbpa/plane/mesh
    rbpa/plane/predicate"

  # Programs: for each, first the folders of apps, then those of the libraries.
  "cli: rbpa rbpa/base io io/bytes io/cloud io/mesh io/polygon picture program report stream triangulation"
  "examples: meshops meshops/core meshops/front meshops/graph meshops/topology rbpa"
  "io: rbpa/base"
  "io/bytes: meshops/core io"
  "io/cloud: rbpa/base io io/bytes io/polygon io/text"
  "io/mesh: meshops/core meshops/topology rbpa rbpa/base io io/bytes io/cloud io/polygon io/text"
  "io/polygon: rbpa rbpa/base io io/bytes io/text"
  "io/text: io io/bytes"
  "javascript: rbpa rbpa/base"
  "meshtopo: meshops/core meshops/topology rbpa rbpa/base io io/bytes io/mesh program triangulation"
  "picture: meshops/front rbpa rbpa/base io io/bytes io/mesh io/text"
  "program: rbpa/base io io/bytes"
  "python: meshops/core meshops/front meshops/handle meshops/stellar meshops/topology rbpa rbpa/base io io/bytes io/cloud io/mesh
    io/polygon"
  "report: rbpa rbpa/base io io/bytes io/text"
  "stream: rbpa rbpa/base rbpa/base/parallel io io/bytes io/cloud io/mesh io/polygon"
  "triangulation: meshops/core rbpa rbpa/base io io/bytes io/mesh")
set(arrows "")
foreach(line ${allowed})
  string(REGEX MATCHALL "[^: \n]+" folders "${line}")
  list(POP_FRONT folders from)
  foreach(to ${folders})
    list(APPEND arrows "${from}>${to}")
    # plane and space are siblings on base, which has what both need.
    if("${from}>${to}" MATCHES "^rbpa/plane.*>rbpa/space" OR "${from}>${to}" MATCHES "^rbpa/space.*>rbpa/plane"
       OR "${from}>${to}" MATCHES "^rbpa/base.*>rbpa/(plane|space|fill|paper)" OR "${from}>${to}" MATCHES "^meshops.*>rbpa")
      message(FATAL_ERROR "${from} must not be allowed to include ${to}")
    endif()
  endforeach()
endforeach()

set(checked 0)
set(bad "")
foreach(root libmeshops librbpa apps)
  file(GLOB_RECURSE files RELATIVE ${ROOT}/${root} ${ROOT}/${root}/*.h ${ROOT}/${root}/*.cpp)
  foreach(file ${files})
    get_filename_component(from ${file} DIRECTORY)
    file(STRINGS ${ROOT}/${root}/${file} includes REGEX "^#include \"")
    foreach(line ${includes})
      string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included ${line})
      get_filename_component(to ${included} DIRECTORY)
      math(EXPR checked "${checked} + 1")
      if(NOT from STREQUAL to AND NOT "${from}>${to}" IN_LIST arrows)
        string(APPEND bad "\n  ${file} includes ${included}")
      endif()
    endforeach()
  endforeach()
endforeach()

# Public headers, and programs, which are users too, include no internal header of librbpa: these are not installed,
# their symbols are hidden in a shared library, and they are exact only with the compile options of this project.
# docs/drawings may include them, as it draws internals.
file(STRINGS ${ROOT}/librbpa/CMakeLists.txt lines REGEX "rbpa/[a-z0-9_/]+\\.h")
list(FILTER lines EXCLUDE REGEX ">")  # old paths
string(REGEX MATCHALL "rbpa/[a-z0-9_/]+\\.h" installed "${lines}")
list(LENGTH installed count)
file(GLOB root_headers RELATIVE ${ROOT}/librbpa ${ROOT}/librbpa/rbpa/*.h)
foreach(header ${root_headers})
  if(NOT header IN_LIST installed)
    string(APPEND bad "\n  ${header} is among the public headers and is not installed")
  endif()
endforeach()
file(GLOB_RECURSE programs RELATIVE ${ROOT} ${ROOT}/apps/*.h ${ROOT}/apps/*.cpp)
set(users ${programs})
foreach(header ${installed})
  list(APPEND users librbpa/${header})
endforeach()
foreach(file ${users})
  file(STRINGS ${ROOT}/${file} includes REGEX "^#include \"rbpa/")
  foreach(line ${includes})
    string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included ${line})
    if(NOT included IN_LIST installed)
      string(APPEND bad "\n  ${file}: ${line}, which is inside librbpa")
    endif()
  endforeach()
endforeach()
if(count LESS 30)
  message(FATAL_ERROR "only ${count} public headers found in librbpa/CMakeLists.txt")
endif()

if(checked LESS 500)
  message(FATAL_ERROR "only ${checked} includes found under ${ROOT}: the check looks in the wrong place")
endif()
if(bad)
  message(FATAL_ERROR "includes against the layering:${bad}")
endif()
message(STATUS "${checked} includes go one way")
