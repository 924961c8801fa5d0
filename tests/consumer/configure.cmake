# Configures the project SOURCE in WORK with the sources in RBPA_SOURCE. It must succeed without a warning; or, if
# REFUSED is given, fail with a message that contains this text.
cmake_minimum_required(VERSION 3.22)
file(REMOVE_RECURSE "${WORK}")
execute_process(
  COMMAND ${CMAKE_COMMAND} --no-warn-unused-cli -S "${SOURCE}" -B "${WORK}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
    "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DRBPA_SOURCE=${RBPA_SOURCE}"
  OUTPUT_VARIABLE said ERROR_VARIABLE warned RESULT_VARIABLE code)
string(REGEX REPLACE "[ \n]+" " " warned "${warned}")
if(REFUSED)
  string(FIND "${warned}" "${REFUSED}" at)
  if(code EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "expected a refusal that has '${REFUSED}', found code ${code} and\n${warned}")
  endif()
elseif(NOT code EQUAL 0 OR warned MATCHES "CMake (Deprecation )?Warning")
  message(FATAL_ERROR "expected a configuration without a warning, found code ${code} and\n${warned}")
endif()
