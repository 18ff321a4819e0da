# Copyright (c) 2026 The Angle_based_flattening authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# What the tests of the packages, of the program and of the Python module have in common
find_package(Boost REQUIRED COMPONENTS unit_test_framework)
find_package(assimp QUIET)

# Where the tests find what they need, as environment variables
set(places "ABF_EXAMPLES_DIR=${ABF_PACKAGE_DIR}/examples/Angle_based_flattening/data")
if(TARGET flatten_mesh)
  list(APPEND places "ABF_FLATTEN_MESH=$<TARGET_FILE:flatten_mesh>")
endif()
if(EXISTS ${ABF_PACKAGE_DIR}/../shared/data)
  get_filename_component(shared_data ${ABF_PACKAGE_DIR}/../shared/data ABSOLUTE)
  list(APPEND places "ABF_SHARED_DATA_DIR=${shared_data}")
endif()
# CGAL's own meshes, and the seams of its examples on them, from Debian's package libcgal-demo (scripts/test puts a
# copy into build/ where the package comes without its documentation folder)
foreach(place ABF_DATA_DIR=data/meshes ABF_CGAL_EXAMPLES_DIR=examples/Surface_mesh_parameterization/data)
  string(REGEX MATCH "=(([a-z]+)/.*)" folder ${place})
  set(folder ${CMAKE_MATCH_1})
  find_file(ABF_CGAL_${CMAKE_MATCH_2} ${CMAKE_MATCH_2}.tar.gz NO_DEFAULT_PATH
    PATHS /usr/share/doc/libcgal-dev /usr/share/doc/libcgal-demo ${ABF_PACKAGE_DIR}/build)
  if(NOT ABF_CGAL_${CMAKE_MATCH_2})
    message(STATUS "CGAL's demo meshes (libcgal-demo) not found: tests of them are skipped")
    continue()
  elseif(NOT EXISTS ${CMAKE_BINARY_DIR}/${folder}/all_is_there)
    file(ARCHIVE_EXTRACT INPUT ${ABF_CGAL_${CMAKE_MATCH_2}} DESTINATION ${CMAKE_BINARY_DIR} PATTERNS "${folder}/*")
    file(TOUCH ${CMAKE_BINARY_DIR}/${folder}/all_is_there)
  endif()
  string(REPLACE "=" "=${CMAKE_BINARY_DIR}/" place ${place})
  list(APPEND places ${place})
endforeach()

# A test that lacks something is there all the same, and reported as skipped.
function(abf_add_skipped_test name reason)
  add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E echo "skipped: ${reason}")
  set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
endfunction()

# Adds tests in Python, in files test_NAME.py. They are skipped unless all variables in the list `needs` are true.
function(abf_add_python_tests needs)
  foreach(name ${ARGN})
    abf_is_wanted(${name} wanted)
    foreach(variable Python3_FOUND ${needs})
      if(wanted AND NOT ${variable})
        abf_add_skipped_test(${name} "${variable} is not true")
        set(wanted FALSE)
      endif()
    endforeach()
    if(wanted)
      string(REPLACE "test_" "" file ${name})
      add_test(NAME ${name}
        COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/test_${file}.py ${arguments_of_python_tests})
      set_tests_properties(${name} PROPERTIES TIMEOUT 1800 SKIP_RETURN_CODE 77 ENVIRONMENT "${places}")
    endif()
  endforeach()
endfunction()

# Makes a program of test files, which are given without `.cpp`; of all others in the folder if none is given. Most of
# the time goes into compiling what they include and instantiate, and so they are one translation unit. Each is a test
# suite of its own name, and a test. In it, suites that need other meshes (see test_data.h) and those of large surfaces
# are tests of their own.
function(abf_add_tests program)
  file(GLOB tests CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} test_*.cpp)
  list(REMOVE_ITEM tests "" ${grouped_tests})
  if(ARGN)
    list(TRANSFORM ARGN APPEND .cpp OUTPUT_VARIABLE tests)
  endif()
  set(grouped_tests ${grouped_tests} ${tests} PARENT_SCOPE)
  if(ABF_ONLY)
    list(JOIN ABF_ONLY "|" only)
    list(FILTER tests INCLUDE REGEX "^(${only}).cpp$")
  endif()
  if(ABF_SANITIZE) # of these, most is code of CGAL's, which takes minutes to compile with sanitizers
    list(FILTER tests EXCLUDE REGEX "test_(SuperLU_in_|kernels|property_maps)")
  endif()
  if(NOT tests)
    return()
  endif()
  add_executable(${program} ${tests})
  if(NOT tests STREQUAL "${program}.cpp" AND (CMAKE_UNITY_BUILD OR NOT DEFINED CMAKE_UNITY_BUILD))
    set_target_properties(${program} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
  target_include_directories(${program} PRIVATE ${ABF_PACKAGE_DIR}/test/Angle_based_flattening
    ${ABF_PACKAGE_DIR}/test/Texture_atlas)
  target_link_libraries(${program} PRIVATE CGAL::Angle_based_flattening abf_cholmod Boost::unit_test_framework
    $<TARGET_NAME_IF_EXISTS:assimp::assimp>)
  target_compile_definitions(${program} PRIVATE BOOST_TEST_MODULE=${program} BOOST_TEST_DYN_LINK
    $<$<TARGET_EXISTS:assimp::assimp>:ABF_WITH_ASSIMP>)
  # Those that compute more than others would take long without any optimization. They have no precompiled headers:
  # test_SuperLU_solver_traits defines names that are in these.
  if(program STREQUAL test_rounding)
    target_compile_options(${program} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang>:-O2>)
  elseif(program MATCHES "^tests_of_(injective|numerics|parameterizers|solvers|atlases|files|packing|seams)" OR
         program MATCHES "^test_(CGAL_programs|SuperLU_solver_traits|cones|polygons)$")
    abf_optimize_a_little(${program})
  else()
    abf_compile_quickly(${program})
  endif()
  foreach(file ${tests})
    get_filename_component(test ${file} NAME_WE)
    file(STRINGS ${file} lines REGEX "TEST_SUITE\\(of_(CGAL_meshes|reference_disks|large_surfaces)")
    string(REGEX MATCHALL "of_[A-Za-z_]+" suites "${lines}")
    list(REMOVE_ITEM suites "" ${suites_that_are_left_out})
    list(TRANSFORM suites REPLACE "(.+)" "--run_test=!${test}/\\1" OUTPUT_VARIABLE others)
    if(NOT test STREQUAL test_reference_meshes) # which has nothing else
      add_test(NAME ${test} COMMAND ${program} --run_test=${test} ${others})
      set_tests_properties(${test} PROPERTIES TIMEOUT 1800 ENVIRONMENT "${places}"
        FAIL_REGULAR_EXPRESSION "skipped: no folder")
    endif()
    foreach(suite ${suites})
      add_test(NAME ${test}_${suite} COMMAND ${program} --run_test=${test}/${suite})
      string(REGEX MATCH "large" label ${suite})
      set_tests_properties(${test}_${suite} PROPERTIES TIMEOUT 1800 ENVIRONMENT "${places}"
        SKIP_REGULAR_EXPRESSION "skipped: no folder" LABELS "${label}")
    endforeach()
  endforeach()
endfunction()
