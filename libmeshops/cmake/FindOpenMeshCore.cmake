# Finds OpenMesh's core library and defines the imported target OpenMeshCore::OpenMeshCore. Not every OpenMesh comes
# with a CMake configuration, and the targets of one that does have no namespace and name the exact file of one version.
find_path(OpenMeshCore_INCLUDE_DIR OpenMesh/Core/Mesh/PolyConnectivity.hh)
find_library(OpenMeshCore_LIBRARY OpenMeshCore)
mark_as_advanced(OpenMeshCore_INCLUDE_DIR OpenMeshCore_LIBRARY)

include(FindPackageHandleStandardArgs)
# meshopsConfig.cmake includes this file; the package that it is finding then has another name.
find_package_handle_standard_args(OpenMeshCore REQUIRED_VARS OpenMeshCore_LIBRARY OpenMeshCore_INCLUDE_DIR
  NAME_MISMATCHED)

if(OpenMeshCore_FOUND AND NOT TARGET OpenMeshCore::OpenMeshCore)
  add_library(OpenMeshCore::OpenMeshCore UNKNOWN IMPORTED)
  set_target_properties(OpenMeshCore::OpenMeshCore PROPERTIES
    IMPORTED_LOCATION ${OpenMeshCore_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${OpenMeshCore_INCLUDE_DIR})
endif()
