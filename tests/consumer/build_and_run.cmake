# Configures, builds and runs the project SOURCE in WORK. It finds the libraries in PREFIX, or their sources in
# RBPA_SOURCE, and compiles several of these at a time. The configuration must not warn, as users could do nothing about
# it.
cmake_minimum_required(VERSION 3.22)
file(REMOVE_RECURSE "${WORK}")
if(LAUNCHER)
  set(cached "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}" "-DCMAKE_POSITION_INDEPENDENT_CODE=${PIC}"
    "-DRBPA_WARNINGS_AS_ERRORS=${WARNINGS_AS_ERRORS}")
endif()
execute_process(
  COMMAND ${CMAKE_COMMAND} --no-warn-unused-cli -S "${SOURCE}" -B "${WORK}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
    "-DCMAKE_CXX_FLAGS=${FLAGS}" -DCMAKE_CXX_FLAGS_DEBUG= "-DCMAKE_PREFIX_PATH=${PREFIX}" "-DRBPA_SOURCE=${RBPA_SOURCE}"
    "-DBUILD_SHARED_LIBS=${SHARED}" -DRBPA_COMPILE_TOGETHER=ON ${cached}
  OUTPUT_VARIABLE said ERROR_VARIABLE warned ECHO_OUTPUT_VARIABLE ECHO_ERROR_VARIABLE COMMAND_ERROR_IS_FATAL ANY)
if("${said}${warned}" MATCHES "CMake (Deprecation )?Warning.*")
  message(FATAL_ERROR "the configuration of a user's project warns:\n${CMAKE_MATCH_0}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build "${WORK}" --parallel 2 COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${WORK}/consumer" COMMAND_ERROR_IS_FATAL ANY)
