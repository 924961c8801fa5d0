# Headers at the paths that they had up to version 0.1: each includes the new one, for version 0.2 only. They are
# written into the build folder, so that the sources have one place for each thing.
#   rbpa_forward_headers(library old>new...)
function(rbpa_forward_headers library)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/forwarding)
  file(REMOVE_RECURSE ${folder})  # what an earlier version of the list has left
  foreach(pair ${ARGN})
    string(REGEX MATCH "^(.*)>(.*)$" _ ${pair})
    if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${CMAKE_MATCH_2} OR EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${CMAKE_MATCH_1})
      message(FATAL_ERROR "${pair}: expected a header that is there behind >, and before it a path where none is")
    endif()
    set(content "// Moved to \"${CMAKE_MATCH_2}\", where version 0.3 will have it only.\n#pragma once\n\n#include \"${CMAKE_MATCH_2}\"\n")
    file(CONFIGURE OUTPUT ${folder}/${CMAKE_MATCH_1} CONTENT "${content}" @ONLY)
  endforeach()
  target_include_directories(${library} PUBLIC $<BUILD_INTERFACE:${folder}>)
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
endfunction()
