# WebAssembly has one kind of vector unit, so that nothing of Highway is linked.
if(NOT TARGET hwy::hwy)
  add_library(hwy::hwy INTERFACE IMPORTED)
endif()
