# Checks that refused_policies.cpp does not compile, and that each of its six errors has the right message.
# usage: cmake -DCOMPILER=... -DLIBRARY=... -DSOURCE=... -P check_refused_policies.cmake
execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -I${LIBRARY} ${SOURCE} RESULT_VARIABLE status ERROR_VARIABLE messages)
if(status EQUAL 0)
  message(FATAL_ERROR "${SOURCE} compiles")
endif()
foreach(expected IN ITEMS
    "a member key that is ignored: expected key(const Front&, Halfedge)"
    "a member glues that is ignored: expected bool glues(const Front&, Halfedge, Site)"
    "a member rekeys_neighbors that is ignored: expected static constexpr bool"
    "events of curves that are ignored: expected it to derive from CurveVisitor"
    "the visitor has no event, or a member with nearly the name of one"
    "policy.propose(front, h)")
  string(FIND "${messages}" "${expected}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "no message says \"${expected}\":\n${messages}")
  endif()
endforeach()
