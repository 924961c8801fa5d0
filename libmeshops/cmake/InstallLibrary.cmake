# Common settings of both libraries: hidden symbols unless marked, a versioned shared object, a relocatable
# installation.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Before 1.0 a minor version may break compatibility: packages must agree in it, and it is part of the shared object's
# name.
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(rbpa_compatibility SameMinorVersion)
  set(rbpa_soversion 0.${PROJECT_VERSION_MINOR})
else()
  set(rbpa_compatibility SameMajorVersion)
  set(rbpa_soversion ${PROJECT_VERSION_MAJOR})
endif()

# A shared library searches the other one beside itself: the path in a user's program does not apply to indirect
# dependencies.
function(rbpa_library_properties target)
  set_target_properties(${target} PROPERTIES
    VERSION ${PROJECT_VERSION}
    SOVERSION ${rbpa_soversion}
    INSTALL_RPATH $ORIGIN)
endfunction()

# Installs programs that find the shared libraries even if the tree is moved.
function(rbpa_install_programs)
  if(BUILD_SHARED_LIBS)
    file(RELATIVE_PATH libraries /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
    set_target_properties(${ARGN} PROPERTIES INSTALL_RPATH $ORIGIN/${libraries})
  endif()
  install(TARGETS ${ARGN} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
endfunction()

function(rbpa_hide_symbols target)
  set_target_properties(${target} PROPERTIES
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
  if(BUILD_SHARED_LIBS OR RBPA_BUILD_PYTHON OR RBPA_POSITION_INDEPENDENT)  # otherwise CMAKE_POSITION_INDEPENDENT_CODE decides
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
endfunction()

# Installs the library, and <name>Config.cmake and <name>.pc from the caller's folder cmake/. The caller installs
# headers.
function(rbpa_install_library name)
  set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/${name})
  set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  file(RELATIVE_PATH prefix_from_pkgconfig /${pkgconfig_dir} /)
  string(REGEX REPLACE "/$" "" prefix_from_pkgconfig ${prefix_from_pkgconfig})

  install(TARGETS ${name} EXPORT ${name}Targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT ${name}Targets NAMESPACE ${name}:: DESTINATION ${config_dir} COMPONENT development)
  configure_package_config_file(cmake/${name}Config.cmake.in ${name}Config.cmake INSTALL_DESTINATION ${config_dir})
  write_basic_package_version_file(${name}ConfigVersion.cmake COMPATIBILITY ${rbpa_compatibility})
  configure_file(cmake/${name}.pc.in ${name}.pc @ONLY)
  install(FILES
    ${CMAKE_CURRENT_BINARY_DIR}/${name}Config.cmake ${CMAKE_CURRENT_BINARY_DIR}/${name}ConfigVersion.cmake
    DESTINATION ${config_dir} COMPONENT development)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc DESTINATION ${pkgconfig_dir} COMPONENT development)
  install(FILES ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT development)
endfunction()
