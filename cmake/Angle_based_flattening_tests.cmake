# Copyright (c) 2026 The Angle_based_flattening authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# What the tests of the packages, of the program and of the Python module have in common

find_package(Boost REQUIRED COMPONENTS unit_test_framework)

# Where the tests find what they need, as environment variables.
set(places "ABF_EXAMPLES_DIR=${ABF_PACKAGE_DIR}/examples/Angle_based_flattening/data")
if(TARGET flatten_mesh)
  list(APPEND places "ABF_FLATTEN_MESH=$<TARGET_FILE:flatten_mesh>")
endif()

# CGAL's own meshes, and the seams of its examples on them, from Debian's package libcgal-demo (scripts/test puts a copy into
# build/ where the package comes without its documentation folder).
set(folders_with_archives /usr/share/doc/libcgal-dev /usr/share/doc/libcgal-demo ${ABF_PACKAGE_DIR}/build)
find_file(ABF_CGAL_DATA_ARCHIVE data.tar.gz NO_DEFAULT_PATH PATHS ${folders_with_archives})
find_file(ABF_CGAL_EXAMPLES_ARCHIVE examples.tar.gz NO_DEFAULT_PATH PATHS ${folders_with_archives})
function(abf_unpack archive folder variable)
  if(NOT EXISTS ${CMAKE_BINARY_DIR}/${folder})
    set(half ${CMAKE_BINARY_DIR}/unpacking) # until all is there
    file(REMOVE_RECURSE ${half})
    file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${half} PATTERNS "${folder}/*")
    get_filename_component(parent ${CMAKE_BINARY_DIR}/${folder} DIRECTORY)
    file(MAKE_DIRECTORY ${parent})
    file(RENAME ${half}/${folder} ${CMAKE_BINARY_DIR}/${folder})
  endif()
  set(places ${places} "${variable}=${CMAKE_BINARY_DIR}/${folder}" PARENT_SCOPE)
endfunction()
if(ABF_CGAL_DATA_ARCHIVE AND ABF_CGAL_EXAMPLES_ARCHIVE)
  abf_unpack(${ABF_CGAL_DATA_ARCHIVE} data/meshes ABF_DATA_DIR)
  abf_unpack(${ABF_CGAL_EXAMPLES_ARCHIVE} examples/Surface_mesh_parameterization/data ABF_CGAL_EXAMPLES_DIR)
else()
  message(STATUS "CGAL's demo meshes (libcgal-demo) not found: tests of them are skipped")
endif()

get_filename_component(shared_data ${ABF_PACKAGE_DIR}/../shared/data ABSOLUTE)
if(EXISTS ${shared_data})
  list(APPEND places "ABF_SHARED_DATA_DIR=${shared_data}")
endif()

# A test that cannot be built is there all the same, and reported as skipped.
function(abf_add_skipped_test name reason)
  add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E echo "skipped: ${reason}")
  set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
endfunction()

# Makes a program of test files, which are given without `.cpp`. Most of the time goes into compiling what they include and
# instantiate, and so they are one translation unit. Each is a test suite of its own name, and a test.
function(abf_add_tests program)
  set(grouped_tests ${grouped_tests} ${ARGN} PARENT_SCOPE)
  set(tests)
  foreach(test ${ARGN})
    abf_is_wanted(${test} wanted)
    if(wanted)
      list(APPEND tests ${test})
    endif()
  endforeach()
  if(ABF_SANITIZE) # of these, most is code of CGAL's, which takes minutes to compile with sanitizers
    list(FILTER tests EXCLUDE REGEX "test_(SuperLU_in_|kernels|property_maps)")
  endif()
  if(NOT tests)
    return()
  endif()
  set(files ${tests})
  list(TRANSFORM files APPEND .cpp)
  add_executable(${program} ${files})
  if(ARGC GREATER 2 AND (CMAKE_UNITY_BUILD OR NOT DEFINED CMAKE_UNITY_BUILD))
    set_target_properties(${program} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
  target_include_directories(${program} PRIVATE ${ABF_PACKAGE_DIR}/test/Angle_based_flattening
    ${ABF_PACKAGE_DIR}/test/Texture_atlas)
  target_link_libraries(${program} PRIVATE
    CGAL::Angle_based_flattening abf_cholmod Boost::unit_test_framework)
  target_compile_definitions(${program} PRIVATE BOOST_TEST_MODULE=${program} BOOST_TEST_DYN_LINK)
  if(program STREQUAL "test_rounding")
    target_compile_options(${program} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang>:-O2>)
  elseif(program IN_LIST heavy_programs)
    abf_optimize_a_little(${program})
  else()
    abf_compile_quickly(${program})
  endif()
  foreach(test ${tests})
    set(others)
    foreach(suite ${suites_of_${test}})
      list(APPEND others --run_test=!${test}/${suite})
      add_test(NAME ${test}_${suite} COMMAND ${program} --run_test=${test}/${suite}
        WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
      set_tests_properties(${test}_${suite} PROPERTIES TIMEOUT 1800 ENVIRONMENT "${places}"
        SKIP_REGULAR_EXPRESSION "skipped: no folder")
      if(suite STREQUAL of_large_surfaces)
        set_tests_properties(${test}_${suite} PROPERTIES LABELS large)
      endif()
    endforeach()
    if(NOT test STREQUAL test_reference_meshes) # which has nothing else
      add_test(NAME ${test} COMMAND ${program} --run_test=${test} ${others} WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
      set_tests_properties(${test} PROPERTIES TIMEOUT 1800 ENVIRONMENT "${places}"
        FAIL_REGULAR_EXPRESSION "skipped: no folder")
    endif()
  endforeach()
endfunction()

# Fails if no program is made of a test in the folder.
function(abf_check_tests)
  file(GLOB forgotten_tests CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} test_*.cpp)
  list(TRANSFORM forgotten_tests REPLACE "[.]cpp$" "")
  list(REMOVE_ITEM forgotten_tests ${grouped_tests})
  if(forgotten_tests)
    message(FATAL_ERROR "No program is made of ${forgotten_tests}: add it to one of those above")
  endif()
endfunction()
