cmake_minimum_required(VERSION 3.22)
# Fails if a file includes one from a folder that its own folder must not include.
# Each line has a folder and the folders that it may include; a folder may always include itself.
set(allowed
  "meshops: meshops/core meshops/front meshops/graph meshops/handle meshops/history meshops/patch meshops/simplify
    meshops/stellar meshops/topology"
  "meshops/front: meshops/core meshops/handle meshops/patch"
  "meshops/graph: meshops/core"
  "meshops/handle: meshops/core"
  "meshops/history: meshops/core meshops/handle meshops/stellar"
  "meshops/patch: meshops/core"
  "meshops/simplify: meshops/core meshops/stellar"
  "meshops/stellar: meshops/core"
  "meshops/topology: meshops/core meshops/graph meshops/handle meshops/stellar"

  "rbpa: meshops/core meshops/front meshops/topology rbpa/base rbpa/base/exact rbpa/base/parallel rbpa/base/run
    rbpa/base/sort rbpa/fill rbpa/fill/front rbpa/fill/rings rbpa/paper rbpa/plane rbpa/plane/hierarchy rbpa/plane/mesh
    rbpa/plane/patches rbpa/plane/predicate rbpa/plane/shape rbpa/space/balls rbpa/space/normals rbpa/space/persistence rbpa/space/repair rbpa/space/simplify
    rbpa/space/solid rbpa/space/surface"
  "rbpa/base: meshops/core"
  "rbpa/base/arrays: meshops/core rbpa/base rbpa/base/run"
  "rbpa/base/exact: rbpa/base"
  "rbpa/base/parallel: rbpa/base"
  "rbpa/base/run: meshops/core rbpa/base rbpa/base/parallel"
  "rbpa/base/radii: meshops/core rbpa/base/run"
  "rbpa/base/sort: meshops/core meshops/patch rbpa/base rbpa/base/parallel"
  "rbpa/fill: meshops/core meshops/topology rbpa/base rbpa/base/arrays rbpa/base/run rbpa/fill/rings rbpa/fill/voronoi
    rbpa/plane rbpa/plane/predicate rbpa/plane/shape"
  "rbpa/fill/front: meshops/core meshops/front meshops/patch meshops/stellar rbpa/base rbpa/base/arrays rbpa/base/exact
    rbpa/base/run rbpa/fill rbpa/fill/rings rbpa/plane rbpa/plane/constrained rbpa/plane/grid rbpa/plane/predicate"
  "rbpa/fill/rings: meshops/core rbpa/base rbpa/base/exact rbpa/base/run rbpa/fill rbpa/plane rbpa/plane/grid
    rbpa/plane/predicate rbpa/plane/shape"
  "rbpa/fill/voronoi: meshops/core rbpa/base rbpa/base/run rbpa/fill rbpa/fill/rings rbpa/plane rbpa/plane/predicate
    rbpa/plane/shape rbpa/plane/voronoi"
  "rbpa/paper: meshops/front meshops/patch rbpa/base rbpa/plane/mesh rbpa/plane/predicate"
  "rbpa/plane: meshops/core meshops/front meshops/topology rbpa/base rbpa/base/arrays rbpa/base/exact
    rbpa/base/parallel rbpa/base/radii rbpa/base/run rbpa/plane/arrays rbpa/plane/constrained
    rbpa/plane/divide rbpa/plane/filtration rbpa/plane/grid rbpa/plane/groups rbpa/plane/hierarchy rbpa/plane/mesh rbpa/plane/partial rbpa/plane/patches
    rbpa/plane/predicate rbpa/plane/shape rbpa/plane/voronoi"
  "rbpa/plane/arrays: meshops/core meshops/patch rbpa/base rbpa/base/arrays rbpa/base/exact rbpa/base/parallel
    rbpa/base/run rbpa/base/sort rbpa/plane rbpa/plane/predicate"
  "rbpa/plane/constrained: meshops/core rbpa/base rbpa/base/exact rbpa/base/run rbpa/plane rbpa/plane/grid
    rbpa/plane/predicate"
  "rbpa/plane/divide: meshops/core meshops/patch rbpa/base rbpa/base/parallel rbpa/plane rbpa/plane/arrays
    rbpa/plane/predicate"
  "rbpa/plane/enumeration: rbpa/base/lanes rbpa/plane/predicate rbpa/plane/tile"
  "rbpa/plane/filtration: meshops/core rbpa/base rbpa/base/arrays rbpa/base/exact rbpa/base/radii rbpa/base/run rbpa/plane
    rbpa/plane/arrays rbpa/plane/predicate"
  "rbpa/plane/grid: meshops/core rbpa/base rbpa/base/exact rbpa/base/parallel rbpa/base/run rbpa/base/sort rbpa/plane/predicate"
  "rbpa/plane/groups: rbpa/base rbpa/base/parallel rbpa/base/run rbpa/plane rbpa/plane/filtration rbpa/plane/shape"
  "rbpa/plane/hierarchy: meshops/core meshops/front meshops/patch rbpa/base rbpa/base/parallel rbpa/base/sort
    rbpa/plane rbpa/plane/grid rbpa/plane/mesh rbpa/plane/patches rbpa/plane/predicate"
  "rbpa/plane/mesh: meshops/core meshops/front meshops/patch rbpa/base rbpa/plane rbpa/plane/grid"
  "rbpa/plane/partial: meshops/core rbpa/base rbpa/base/arrays rbpa/base/run rbpa/plane rbpa/plane/predicate
    rbpa/plane/shape"
  "rbpa/plane/patches: rbpa/base rbpa/plane/enumeration rbpa/plane/grid rbpa/plane/pivots rbpa/plane/remainder
    rbpa/plane/tile"
  "rbpa/plane/pivots: rbpa/base/lanes rbpa/plane/predicate rbpa/plane/tile"
  "rbpa/plane/predicate: rbpa/base rbpa/base/exact"
  "rbpa/plane/remainder: meshops/core meshops/patch rbpa/base/arrays rbpa/base/parallel rbpa/plane/divide rbpa/plane/grid
    rbpa/plane/predicate rbpa/plane/tile"
  "rbpa/plane/shape: rbpa/base rbpa/base/exact rbpa/base/run rbpa/plane rbpa/plane/predicate"
  "rbpa/plane/tile: meshops/patch rbpa/base rbpa/base/parallel rbpa/plane/grid rbpa/plane/predicate"
  "rbpa/plane/voronoi: meshops/core rbpa/base rbpa/base/run rbpa/plane"
  "rbpa/space/balls: meshops/core rbpa/base rbpa/base/arrays rbpa/base/exact rbpa/base/parallel rbpa/base/run rbpa/space/balls/full
    rbpa/space/balls/periodic rbpa/space/cells rbpa/space/persistence rbpa/space/persistence/pairing
    rbpa/space/predicate rbpa/space/solid
    rbpa/space/solid/boundary rbpa/space/solid/insertion rbpa/space/solid/rows rbpa/space/surface"
  "rbpa/space/balls/full: meshops/core rbpa/base rbpa/base/arrays rbpa/base/exact rbpa/base/parallel rbpa/base/run
    rbpa/space/balls rbpa/space/predicate rbpa/space/solid"
  "rbpa/space/balls/periodic: rbpa/base rbpa/base/exact rbpa/base/run rbpa/space/balls rbpa/space/balls/full
    rbpa/space/predicate rbpa/space/solid"
  "rbpa/space/cells: meshops/core rbpa/base rbpa/base/exact rbpa/base/parallel rbpa/base/run rbpa/base/sort
    rbpa/space/predicate"
  "rbpa/space/normals: rbpa/base rbpa/space/cells rbpa/space/normals/sides rbpa/space/surface/neighbors"
  "rbpa/space/normals/sides: meshops/core rbpa/base rbpa/base/parallel rbpa/space/cells rbpa/space/solid
    rbpa/space/surface/neighbors"
  "rbpa/space/persistence: meshops/core rbpa/base rbpa/base/arrays rbpa/base/parallel rbpa/base/radii rbpa/base/run
    rbpa/space/cells rbpa/space/persistence/pairing rbpa/space/predicate rbpa/space/solid rbpa/space/solid/boundary
    rbpa/space/solid/insertion rbpa/space/surface"
  "rbpa/space/persistence/pairing: meshops/core rbpa/base rbpa/base/arrays rbpa/base/parallel rbpa/base/radii
    rbpa/base/run rbpa/space/persistence rbpa/space/predicate rbpa/space/solid rbpa/space/solid/insertion"
  "rbpa/space/predicate: rbpa/base rbpa/base/exact rbpa/base/lanes"
  "rbpa/space/repair: meshops/core meshops/front meshops/handle meshops/patch meshops/stellar rbpa/base
    rbpa/base/arrays rbpa/base/exact rbpa/base/parallel rbpa/base/run rbpa/space/cells rbpa/space/normals rbpa/space/predicate rbpa/space/repair/closing
    rbpa/space/repair/refining rbpa/space/simplify rbpa/space/surface rbpa/space/surface/levels"
  "rbpa/space/repair/closing: meshops/core rbpa/base rbpa/base/arrays rbpa/base/run rbpa/space/cells
    rbpa/space/predicate"
  "rbpa/space/repair/refining: meshops/core meshops/stellar rbpa/base rbpa/space/predicate rbpa/space/surface"
  "rbpa/space/simplify: meshops/core meshops/simplify meshops/stellar meshops/topology rbpa/base
    rbpa/space/predicate rbpa/space/simplify/distance rbpa/space/simplify/moving
    rbpa/space/simplify/remeshing rbpa/space/surface"
  "rbpa/space/simplify/distance: meshops/core rbpa/base rbpa/space/cells rbpa/space/predicate"
  "rbpa/space/simplify/moving: meshops/core meshops/stellar rbpa/base rbpa/space/cells rbpa/space/predicate"
  "rbpa/space/simplify/remeshing: meshops/core meshops/stellar rbpa/base rbpa/space/predicate rbpa/space/simplify
    rbpa/space/simplify/distance rbpa/space/simplify/moving"
  "rbpa/space/solid: meshops/core rbpa/base rbpa/base/arrays rbpa/base/parallel rbpa/base/radii rbpa/base/run
    rbpa/base/sort rbpa/space/cells rbpa/space/predicate rbpa/space/solid/boundary rbpa/space/solid/insertion
    rbpa/space/solid/periodic rbpa/space/solid/rows rbpa/space/solid/tiles rbpa/space/solid/triples rbpa/space/surface
    rbpa/space/surface/levels"
  "rbpa/space/solid/boundary: meshops/core rbpa/base rbpa/base/arrays rbpa/base/exact rbpa/base/parallel rbpa/base/run
    rbpa/space/predicate rbpa/space/solid rbpa/space/surface rbpa/space/surface/levels"
  "rbpa/space/solid/insertion: meshops/core rbpa/base rbpa/base/parallel rbpa/base/run rbpa/base/sort
    rbpa/space/predicate"
  "rbpa/space/solid/periodic: rbpa/base rbpa/base/run rbpa/space/predicate rbpa/space/solid"
  "rbpa/space/solid/rows: meshops/core rbpa/base rbpa/base/parallel rbpa/base/run rbpa/base/sort rbpa/space/solid
    rbpa/space/solid/insertion"
  "rbpa/space/solid/tiles: meshops/core rbpa/base rbpa/base/lanes rbpa/base/parallel rbpa/base/sort
    rbpa/space/predicate rbpa/space/solid/insertion rbpa/space/solid/rows"
  "rbpa/space/solid/triples: meshops/core rbpa/base/lanes rbpa/base/parallel rbpa/space/cells rbpa/space/predicate"
  "rbpa/space/surface: meshops/core meshops/patch meshops/stellar rbpa/base rbpa/base/arrays rbpa/base/exact
    rbpa/base/parallel rbpa/base/radii rbpa/base/run rbpa/space/cells rbpa/space/predicate rbpa/space/surface/levels
    rbpa/space/surface/neighbors rbpa/space/surface/pivot rbpa/space/surface/spacing rbpa/space/surface/star"
  "rbpa/space/surface/levels: rbpa/base rbpa/base/arrays rbpa/space/cells rbpa/space/surface"
  "rbpa/space/surface/neighbors: meshops/core rbpa/base rbpa/base/parallel rbpa/space/cells rbpa/space/surface"
  "rbpa/space/surface/pivot: rbpa/space/predicate"
  "rbpa/space/surface/spacing: rbpa/base"
  "rbpa/space/surface/star: meshops/core rbpa/base rbpa/base/lanes rbpa/base/parallel rbpa/base/run rbpa/space/cells
    rbpa/space/predicate rbpa/space/surface rbpa/space/surface/pivot"

  # Programs: folders of ours first, then what each uses of the libraries.
  "apps/examples: meshops meshops/core meshops/front meshops/graph meshops/simplify meshops/topology rbpa/plane rbpa/space/repair
    rbpa/space/simplify rbpa/space/surface"
  "apps/io: rbpa/base"
  "apps/io/bytes: apps/io meshops/core"
  "apps/io/cloud: apps/io apps/io/bytes apps/io/laz apps/io/polygon apps/io/text meshops/core rbpa/base"
  "apps/io/laz: apps/io apps/io/bytes rbpa/base"
  "apps/io/mesh: apps/io apps/io/bytes apps/io/cloud apps/io/polygon apps/io/text meshops/core meshops/topology
    rbpa/base rbpa/plane"
  "apps/io/polygon: apps/io apps/io/bytes apps/io/text rbpa rbpa/base rbpa/fill rbpa/plane"
  "apps/io/text: apps/io apps/io/bytes"
  "apps/javascript: rbpa/base rbpa/fill rbpa/plane rbpa/space/normals rbpa/space/surface"
  "apps/meshtopo: apps/io apps/io/bytes apps/io/mesh apps/program apps/triangulation meshops/core meshops/topology
    rbpa/base rbpa/space/repair rbpa/space/simplify rbpa/space/surface"
  "apps/picture: apps/io apps/io/bytes apps/io/mesh apps/io/text rbpa/base rbpa/plane rbpa/space/persistence"
  "apps/program: apps/io apps/io/bytes rbpa/base"
  "apps/python: apps/io apps/io/bytes apps/io/cloud apps/io/mesh apps/io/polygon meshops/core meshops/front
    meshops/handle meshops/stellar meshops/topology rbpa/base rbpa/fill rbpa/plane rbpa/space/balls rbpa/space/normals
    rbpa/space/persistence rbpa/space/repair rbpa/space/simplify rbpa/space/solid rbpa/space/surface"
  "apps/rbpa: apps/io apps/io/bytes apps/io/cloud apps/io/polygon apps/picture apps/program apps/rbpa/plane
    apps/rbpa/shared apps/rbpa/space apps/rbpa/tiles apps/report rbpa/base rbpa/plane rbpa/space/balls
    rbpa/space/persistence"
  "apps/rbpa/plane: apps/io apps/io/bytes apps/io/cloud apps/io/mesh apps/io/polygon apps/picture apps/rbpa/shared
    apps/report rbpa rbpa/base rbpa/fill rbpa/plane"
  "apps/rbpa/shared: apps/io apps/io/bytes apps/io/cloud apps/io/mesh apps/io/polygon apps/picture apps/report rbpa
    rbpa/base rbpa/plane rbpa/space/persistence"
  "apps/rbpa/space: apps/io apps/io/bytes apps/io/cloud apps/io/mesh apps/picture apps/rbpa/shared apps/triangulation
    rbpa/base rbpa/space/balls rbpa/space/persistence rbpa/space/repair rbpa/space/solid rbpa/space/surface"
  "apps/rbpa/tiles: apps/io apps/io/bytes apps/io/polygon apps/rbpa/plane apps/rbpa/shared apps/stream rbpa/plane"
  "apps/report: apps/io apps/io/bytes apps/io/text rbpa/base rbpa/plane rbpa/space/persistence"
  "apps/stream: apps/io apps/io/bytes apps/io/cloud apps/io/mesh apps/io/polygon rbpa/base rbpa/plane"
  "apps/triangulation: apps/io apps/io/bytes apps/io/mesh rbpa/base rbpa/space/repair rbpa/space/simplify rbpa/space/surface")
# Rooms, from the ground floor up: no folder may include one of a room above its own, and the plane and space are siblings.
set(floors meshops rbpa/base rbpa/plane rbpa/fill rbpa/paper rbpa/space/predicate rbpa/space/cells rbpa/space/surface rbpa/space/solid
  rbpa/space/normals rbpa/space/simplify rbpa/space/repair rbpa/space/persistence rbpa/space/balls rbpa apps)
function(floor_of folder result)
  if(folder MATCHES "^(meshops|apps|rbpa$)")
    set(room ${CMAKE_MATCH_1})
  else()
    string(REGEX MATCH "^rbpa/(space/)?[a-z_]+" room ${folder})
  endif()
  list(FIND floors "${room}" floor)
  if(floor LESS 0)
    message(FATAL_ERROR "${folder} is in no room of the list of floors")
  endif()
  set(${result} ${floor} PARENT_SCOPE)
endfunction()
set(arrows "")
foreach(line ${allowed})
  string(REGEX MATCHALL "[^: \n]+" folders "${line}")
  list(POP_FRONT folders from)
  floor_of(${from} upper)
  foreach(to ${folders})
    list(APPEND arrows "${from}>${to}")
    floor_of(${to} lower)
    if(lower GREATER upper OR (from MATCHES "^rbpa/(plane|fill|paper)" AND to MATCHES "^rbpa/space") OR
       (from MATCHES "^rbpa/space" AND to MATCHES "^rbpa/(plane|fill|paper)"))
      message(FATAL_ERROR "${from} must not be allowed to include ${to}")
    endif()
  endforeach()
endforeach()

include(${ROOT}/librbpa/cmake/PublicHeaders.cmake)
set(checked 0)
set(bad "")
foreach(root libmeshops librbpa apps)
  file(GLOB_RECURSE files RELATIVE ${ROOT}/${root} ${ROOT}/${root}/*.h ${ROOT}/${root}/*.cpp)
  foreach(file ${files})
    get_filename_component(from ${file} DIRECTORY)
    if(root STREQUAL apps)
      set(from apps/${from})
    endif()
    file(STRINGS ${ROOT}/${root}/${file} includes REGEX "^#include \"")
    foreach(line ${includes})
      string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included ${line})
      get_filename_component(to ${included} DIRECTORY)
      if(root STREQUAL apps)
        # Programs see the folders of apps/ and of apps/rbpa/, and of librbpa what is installed.
        if(EXISTS ${ROOT}/apps/${included})
          set(to apps/${to})
        elseif(EXISTS ${ROOT}/apps/rbpa/${included})
          set(to apps/rbpa/${to})
        elseif(included MATCHES "^rbpa/" AND NOT included IN_LIST rbpa_public_headers)
          string(APPEND bad "\n  ${file} includes ${included}, which is inside librbpa")
        endif()
      elseif("${root}/${file}" MATCHES "^librbpa/" AND file IN_LIST rbpa_public_headers AND included MATCHES "^rbpa/" AND
             NOT included IN_LIST rbpa_public_headers)
        string(APPEND bad "\n  ${file} is public and includes ${included}, which is not")
      endif()
      math(EXPR checked "${checked} + 1")
      if(NOT from STREQUAL to AND NOT "${from}>${to}" IN_LIST arrows)
        string(APPEND bad "\n  ${root}/${file} includes ${included}")
      endif()
    endforeach()
  endforeach()
endforeach()
list(LENGTH rbpa_public_headers count)
if(count LESS 60)
  message(FATAL_ERROR "only ${count} public headers found in librbpa")
endif()

# A base name once in each library; and no header of a program hides one of librbpa.
foreach(library libmeshops librbpa)
  file(GLOB_RECURSE headers RELATIVE ${ROOT}/${library} ${ROOT}/${library}/*.h)
  set(names "")
  foreach(header ${headers})
    get_filename_component(name ${header} NAME)
    if(name IN_LIST names)
      string(APPEND bad "\n  ${library}/${header} has the name of another header")
    endif()
    list(APPEND names ${name})
    if(EXISTS ${ROOT}/apps/${header})
      string(APPEND bad "\n  apps/${header} hides ${library}/${header}")
    endif()
  endforeach()
endforeach()

if(checked LESS 500)
  message(FATAL_ERROR "only ${checked} includes found under ${ROOT}: the check looks in the wrong place")
endif()
if(bad)
  message(FATAL_ERROR "includes against the layering:${bad}")
endif()
message(STATUS "${checked} includes go one way")
