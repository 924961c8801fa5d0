# An overlay port of the sources that contain it.
set(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../..")

vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DRBPA_BUILD_APPS=OFF
    -DRBPA_BUILD_PYTHON=OFF
    -DRBPA_BUILD_TESTS=OFF
    -DRBPA_POSITION_INDEPENDENT=ON)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME meshops CONFIG_PATH lib/cmake/meshops DO_NOT_DELETE_PARENT_CONFIG_PATH)
vcpkg_cmake_config_fixup(PACKAGE_NAME rbpa CONFIG_PATH lib/cmake/rbpa)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
