cmake_minimum_required(VERSION 3.22)
# Fails when a file includes one of a folder that its own folder must not know.
# An allowed arrow is written "from>to"; a folder always knows itself.
set(arrows
  meshops>meshops/core meshops>meshops/front meshops>meshops/graph meshops>meshops/handle meshops>meshops/stellar
  meshops>meshops/topology meshops>meshops/patch
  meshops/handle>meshops/core
  meshops/patch>meshops/core
  meshops/front>meshops/core meshops/front>meshops/handle meshops/front>meshops/patch
  meshops/stellar>meshops/core
  meshops/graph>meshops/core
  meshops>meshops/history
  meshops/history>meshops/core meshops/history>meshops/handle meshops/history>meshops/stellar
  meshops/topology>meshops/core meshops/topology>meshops/front meshops/topology>meshops/handle
  meshops/topology>meshops/stellar meshops/topology>meshops/graph
  rbpa/core>meshops/core
  rbpa/predicate>rbpa/core
  rbpa/search>rbpa/core rbpa/search>rbpa/predicate rbpa/search>meshops/core
  rbpa/paper>rbpa/core rbpa/paper>rbpa/predicate rbpa/paper>rbpa/run rbpa/paper>meshops/front rbpa/paper>meshops/patch
  rbpa/shape>rbpa rbpa/shape>rbpa/core rbpa/shape>rbpa/predicate
  rbpa/shape>meshops/core rbpa/shape>meshops/front rbpa/shape>meshops/topology
  rbpa/fill>rbpa rbpa/fill>rbpa/core rbpa/fill>rbpa/predicate rbpa/fill>rbpa/search rbpa/fill>rbpa/run rbpa/fill>rbpa/shape
  rbpa/fill>meshops/core rbpa/fill>meshops/front rbpa/fill>meshops/patch rbpa/fill>meshops/stellar
  rbpa/fill>meshops/topology
  rbpa/run>rbpa/core rbpa/run>rbpa/predicate rbpa/run>rbpa/search
  rbpa/run>rbpa
  rbpa/run>meshops/core rbpa/run>meshops/front rbpa/run>meshops/patch
  rbpa/hierarchy>rbpa/core rbpa/hierarchy>rbpa/predicate rbpa/hierarchy>rbpa/search
  rbpa/hierarchy>rbpa/patches rbpa/hierarchy>rbpa/parallel
  rbpa/hierarchy>rbpa/run rbpa/hierarchy>meshops/core rbpa/hierarchy>meshops/front
  rbpa/hierarchy>meshops/patch
  rbpa>rbpa/core rbpa>rbpa/predicate rbpa>rbpa/search rbpa>rbpa/paper rbpa>rbpa/run rbpa>rbpa/hierarchy
  rbpa/tile>rbpa/core rbpa/tile>rbpa/predicate rbpa/tile>rbpa/search rbpa/tile>meshops/patch
  rbpa/pivots>rbpa/tile rbpa/pivots>rbpa/predicate
  rbpa/enumeration>rbpa/tile rbpa/enumeration>rbpa/predicate
  rbpa/divide>rbpa/core rbpa/divide>rbpa/predicate rbpa/divide>rbpa/parallel rbpa/divide>meshops/patch
  rbpa/patches>rbpa/tile rbpa/patches>rbpa/pivots rbpa/patches>rbpa/enumeration rbpa/patches>rbpa/remainder
  rbpa/patches>meshops/patch rbpa>rbpa/patches
  rbpa/tile>rbpa/parallel rbpa/search>rbpa/parallel rbpa/run>rbpa/parallel rbpa>rbpa/parallel
  rbpa/remainder>rbpa/core rbpa/remainder>rbpa/predicate rbpa/remainder>rbpa/search rbpa/remainder>meshops/patch
  rbpa/remainder>rbpa/parallel rbpa/remainder>rbpa/tile rbpa/remainder>rbpa/divide
  rbpa/enumeration>rbpa/vector rbpa/pivots>rbpa/vector
  rbpa/arrays>rbpa rbpa/arrays>rbpa/predicate rbpa/arrays>rbpa/parallel rbpa/arrays>meshops/core
  rbpa/arrays>meshops/patch rbpa>rbpa/arrays
  rbpa/filtration>rbpa rbpa/filtration>rbpa/core rbpa/filtration>rbpa/predicate rbpa/filtration>meshops/core
  rbpa/partial>rbpa rbpa/partial>rbpa/core rbpa/partial>rbpa/predicate rbpa/partial>rbpa/run rbpa/partial>rbpa/shape
  rbpa/partial>meshops/core rbpa/partial>meshops/topology
  rbpa/space>rbpa/core rbpa/space>rbpa/run rbpa/space>meshops/core rbpa/space>meshops/patch
  rbpa/space>rbpa/parallel rbpa/space>rbpa/space/star rbpa/space>rbpa/space/search rbpa/space>rbpa/space/predicate
  rbpa/space/star>rbpa/core rbpa/space/star>rbpa/parallel rbpa/space/star>rbpa/vector rbpa/space/star>rbpa/space/pivot
  rbpa/space/star>rbpa/space/predicate rbpa/space/star>rbpa/space/search
  rbpa/space/pivot>rbpa/core rbpa/space/pivot>rbpa/space/predicate rbpa/space/search>rbpa/parallel
  rbpa/space>rbpa/space/pivot rbpa/space>rbpa/shape rbpa/space>rbpa/space/levels rbpa/space>rbpa/space/search rbpa/space/levels>rbpa/core
  rbpa/space/levels>rbpa/space rbpa/space/levels>rbpa/space/predicate rbpa/space/levels>rbpa/space/search
  rbpa/space/predicate>rbpa/core rbpa/space/predicate>rbpa/predicate
  rbpa/space/search>rbpa/core rbpa/space/search>rbpa/predicate
  rbpa/space>rbpa/space/normals rbpa/space>rbpa/space/spacing rbpa/space/spacing>rbpa/core
  rbpa/space/normals>rbpa/core rbpa/space/normals>rbpa/parallel rbpa/space/normals>rbpa/space
  rbpa/space/normals>rbpa/space/search
  rbpa>meshops/core rbpa>meshops/handle rbpa>meshops/front rbpa>meshops/topology

  # Programs: folders of ours first, then what each uses of the libraries.
  picture>io picture>triangulation triangulation>io program>io
  cli>io cli>picture cli>program cli>report cli>triangulation
  meshtopo>io meshtopo>program
  cli>io/points io/points>io io/points>io/table io/points>io/las io/points>io/gis io/points>rbpa/core
  io/table>io io/table>io/gis io/las>io io/las>rbpa/core io/gis>io io/gis>rbpa/core io/gis>rbpa/shape cli>io/gis
  io/ogr>io io/ogr>io/gis io/points>io/ogr cli>io/ogr
  io>meshops/core io>meshops/topology io>rbpa/core
  io/space>io io/space>io/table io/space>io/las io/space>io/points io/space>rbpa/core cli>io/space cli>io/table
  io/blocks>io io/blocks>io/points io/blocks>io/las io/blocks>io/table
  stream>io stream>io/blocks stream>io/gis stream>io/points stream>rbpa/core stream>rbpa/partial stream>rbpa/shape cli>stream
  tasks>io tasks>stream tasks>rbpa/core tasks>rbpa/partial cli>tasks
  report>io report>rbpa/filtration
  picture>meshops/front picture>rbpa picture>rbpa/core picture>rbpa/filtration picture>rbpa/shape
  triangulation>rbpa triangulation>rbpa/shape
  program>meshops/topology program>rbpa/core
  python>meshops/core python>meshops/handle python>meshops/stellar python>meshops/topology python>meshops/front
  python>rbpa python>rbpa/core python>rbpa/filtration python>rbpa/partial python>rbpa/shape
  python>rbpa/space python>rbpa/space/normals
  cli>rbpa cli>rbpa/core cli>rbpa/fill cli>rbpa/filtration cli>rbpa/shape io/gis>rbpa/fill
  cli>rbpa/space cli>rbpa/space/normals picture>rbpa/space triangulation>rbpa/space triangulation>rbpa/core
  meshtopo>meshops/core meshtopo>meshops/topology meshtopo>rbpa
  examples>meshops examples>meshops/front examples>meshops/graph examples>meshops/topology examples>rbpa/space
  examples>meshops/core examples>meshops/patch)

# The inside of librbpa: not installed, hidden in a shared library, exact under the flags of this project only.
set(inside "rbpa/(arrays|divide|enumeration|hierarchy|paper|parallel|patches|pivots|predicate|remainder|run|search|tile|vector|space/(levels|pivot|predicate|search|spacing|star))/")

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

# Headers that users see, and programs, which are users too, know nothing of the inside. What docs/drawings draws is there.
file(GLOB public RELATIVE ${ROOT} ${ROOT}/librbpa/rbpa/*.h ${ROOT}/librbpa/rbpa/core/*.h)
file(GLOB_RECURSE programs RELATIVE ${ROOT} ${ROOT}/apps/*.h ${ROOT}/apps/*.cpp)
foreach(file ${public} ${programs})
  if(file MATCHES "librbpa/(${inside})")
    continue()
  endif()
  file(STRINGS ${ROOT}/${file} includes REGEX "^#include \"${inside}")
  foreach(line ${includes})
    string(APPEND bad "\n  ${file}: ${line}, which is inside librbpa")
  endforeach()
endforeach()

if(checked LESS 500)
  message(FATAL_ERROR "only ${checked} includes found under ${ROOT}: the check looks in the wrong place")
endif()
if(bad)
  message(FATAL_ERROR "includes against the layering:${bad}")
endif()
message(STATUS "${checked} includes go one way")
