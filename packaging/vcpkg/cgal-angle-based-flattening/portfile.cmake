# An overlay port: `vcpkg install cgal-angle-based-flattening --overlay-ports=packaging/vcpkg`, in the folder of the sources.
# It was written after vcpkg's documentation, and has not been tested with vcpkg.
set(VCPKG_BUILD_TYPE release) # headers only

get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DABF_BUILD_EXAMPLES=OFF
    -DABF_BUILD_PROGRAM=OFF
    -DABF_BUILD_TESTS=OFF
    -DABF_INSTALL_CORE=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(
  PACKAGE_NAME CGAL_Angle_based_flattening
  CONFIG_PATH share/cmake/CGAL_Angle_based_flattening)

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib" "${CURRENT_PACKAGES_DIR}/share/doc")
vcpkg_install_copyright(FILE_LIST
  "${SOURCE_PATH}/LICENSE.md" "${SOURCE_PATH}/LICENSE.GPL" "${SOURCE_PATH}/LICENSE.LGPL")
