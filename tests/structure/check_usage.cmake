# Fails unless every script and every program of ours prints its usage for --help, and refuses any other argument that
# begins with - before it does anything. usage: cmake -DROOT=... -DWORK=... "-DPROGRAMS=..." -P check_usage.cmake
file(GLOB scripts "${ROOT}/*/*.sh" "${ROOT}/docs/*/*.sh" "${ROOT}/tests/*/*.sh" "${ROOT}/packaging/*/*.sh")
list(FILTER scripts EXCLUDE REGEX "/(build_environment|refuse_options)\\.sh$")  # sourced
list(LENGTH scripts count)
if(count LESS 7)
  message(FATAL_ERROR "found only ${count} scripts")
endif()
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")

function(check name)  # COMMAND...
  foreach(given --help --no-such-option)
    execute_process(COMMAND ${ARGN} ${given} WORKING_DIRECTORY "${WORK}" RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE error
                    TIMEOUT 20)
    file(GLOB made "${WORK}/*")
    if(made)
      message(FATAL_ERROR "${name} ${given} made ${made}")
    endif()
    if(given STREQUAL --help AND NOT (status EQUAL 0 AND output MATCHES "^usage: "))
      message(FATAL_ERROR "${name} --help: found ${status} and \"${output}${error}\", expected 0 and the usage")
    elseif(given STREQUAL --no-such-option AND NOT (status EQUAL 2 AND error MATCHES "--no-such-option|usage: "))
      message(FATAL_ERROR "${name} --no-such-option: found ${status} and \"${error}\", expected 2 and what is wrong")
    endif()
  endforeach()
endfunction()

foreach(script IN LISTS scripts)
  # A script that does not check its arguments is not run, as it would build or install something.
  file(READ "${script}" text)
  if(NOT text MATCHES "refuse_options\\.sh|--help\\)")
    message(FATAL_ERROR "${script} does not look at its arguments (source tests/refuse_options.sh)")
  endif()
  check("${script}" bash "${script}")
endforeach()
foreach(program IN LISTS PROGRAMS)
  if(EXISTS "${program}")  # some are built nightly only
    check("${program}" "${program}")
  endif()
endforeach()
