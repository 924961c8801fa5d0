cmake_minimum_required(VERSION 3.22)
# Fails if clang-tidy finds anything that .clang-tidy forbids in HEADERS, a file that includes all headers.
find_program(tidy NAMES clang-tidy-14)
if(NOT tidy)
  message(STATUS "SKIPPED: there is no clang-tidy-14")
  return()
endif()
execute_process(COMMAND ${tidy} --quiet --warnings-as-errors=* --config-file=${ROOT}/.clang-tidy -p ${BUILD} ${HEADERS}
                RESULT_VARIABLE failed OUTPUT_VARIABLE findings ERROR_VARIABLE said)
if(failed)
  message(FATAL_ERROR "not as .clang-tidy says:\n${findings}${said}")
endif()
message(STATUS "nothing that .clang-tidy forbids")
