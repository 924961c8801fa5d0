# Checks that every aggregate T of a public header can be made by T{}, with the compiler of the build and with clang:
# OpenMesh's handles have an explicit default constructor, so that a handle without an initializer forbids it.
# usage: cmake -DSOURCE=... -DWORK=... -DCOMPILERS=... -P check_aggregates.cmake
file(GLOB_RECURSE headers RELATIVE "${SOURCE}/libmeshops" "${SOURCE}/libmeshops/meshops/*.h")
include("${SOURCE}/librbpa/cmake/PublicHeaders.cmake")
set(includes "#include <type_traits>\n")
set(calls "")
set(count 0)
foreach(header IN LISTS headers rbpa_public_headers)
  set(path "${SOURCE}/libmeshops/${header}")
  set(namespace meshops)
  if(header MATCHES "^rbpa/")
    set(path "${SOURCE}/librbpa/${header}")
    set(namespace rbpa)
  endif()
  file(STRINGS "${path}" lines)
  set(outer "")
  set(is_hidden FALSE)
  set(before "")
  foreach(line IN LISTS lines)
    if(line MATCHES "^namespace (.*) {" AND NOT CMAKE_MATCH_1 STREQUAL namespace)
      set(is_hidden TRUE)
    elseif(line MATCHES "^}.*namespace (.*)" AND NOT CMAKE_MATCH_1 STREQUAL namespace)
      set(is_hidden FALSE)
    elseif(line MATCHES "^class|^}")
      set(outer "")
    endif()
    set(name "")
    if(NOT is_hidden AND NOT before MATCHES "^(template|requires)" AND line MATCHES "^struct ([A-Za-z0-9]+) [:{]")
      set(outer "${namespace}::${CMAKE_MATCH_1}")
      set(name "${outer}")
    elseif(outer AND line MATCHES "^  struct ([A-Za-z0-9]+) {")
      set(name "${outer}::${CMAKE_MATCH_1}")
    endif()
    if(name)
      string(APPEND calls "  make<${name}>();\n")
      math(EXPR count "${count} + 1")
    endif()
    set(before "${line}")
  endforeach()
  string(APPEND includes "#include \"${header}\"\n")
endforeach()
if(count LESS 100)
  message(FATAL_ERROR "found only ${count} types in the public headers")
endif()
set(file "${WORK}/aggregates.cpp")
file(WRITE "${file}" "${includes}
template <typename T>
void make() {
  if constexpr (std::is_aggregate_v<T> && std::is_default_constructible_v<T>) {
    T braces{};
    T assigned = {};
    static_cast<void>(braces);
    static_cast<void>(assigned);
  }
}
int main() {
${calls}}
")
foreach(compiler IN LISTS COMPILERS)
  execute_process(COMMAND ${compiler} -std=c++20 -fsyntax-only "-I${SOURCE}/libmeshops" "-I${SOURCE}/librbpa" "${file}"
                  RESULT_VARIABLE status ERROR_VARIABLE messages)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${compiler}: an aggregate is not made by braces\n${messages}")
  endif()
endforeach()
