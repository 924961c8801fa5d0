# Finds OpenMesh's core library. Not every OpenMesh comes with a CMake configuration, and where one does, its targets have
# no namespace and name the exact file of one version. Gives the imported target OpenMeshCore::OpenMeshCore.
find_path(OpenMeshCore_INCLUDE_DIR OpenMesh/Core/Mesh/PolyConnectivity.hh)
find_library(OpenMeshCore_LIBRARY OpenMeshCore)
mark_as_advanced(OpenMeshCore_INCLUDE_DIR OpenMeshCore_LIBRARY)

include(FindPackageHandleStandardArgs)
# meshopsConfig.cmake includes this file, so that the package that is looked for has another name.
find_package_handle_standard_args(OpenMeshCore REQUIRED_VARS OpenMeshCore_LIBRARY OpenMeshCore_INCLUDE_DIR
  NAME_MISMATCHED)

if(OpenMeshCore_FOUND AND NOT TARGET OpenMeshCore::OpenMeshCore)
  add_library(OpenMeshCore::OpenMeshCore UNKNOWN IMPORTED)
  set_target_properties(OpenMeshCore::OpenMeshCore PROPERTIES
    IMPORTED_LOCATION ${OpenMeshCore_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${OpenMeshCore_INCLUDE_DIR})
endif()
