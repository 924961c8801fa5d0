# The public headers of librbpa, by depth: at the root, in base/, plane/ and fill/, and in the suites of space/. What lies one folder
# deeper is internal and not installed, as are space/predicate/ and space/cells/.
#   include(.../PublicHeaders.cmake), then ${rbpa_public_headers}: paths as #include has them
get_filename_component(rbpa_headers_root ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
file(GLOB rbpa_public_headers RELATIVE ${rbpa_headers_root}
  ${rbpa_headers_root}/rbpa/*.h ${rbpa_headers_root}/rbpa/base/*.h ${rbpa_headers_root}/rbpa/plane/*.h
  ${rbpa_headers_root}/rbpa/fill/*.h ${rbpa_headers_root}/rbpa/space/*/*.h)
list(FILTER rbpa_public_headers EXCLUDE REGEX "^rbpa/space/(predicate|cells)/")
