# WebAssembly has only one kind of vector unit, so that the library of Highway, which chooses among several, is not
# linked.
if(NOT TARGET hwy::hwy)
  add_library(hwy::hwy INTERFACE IMPORTED)
endif()
