# Copyright (c) 2026 The Angle_based_flattening authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The targets of the package, and what they stand on. The package includes this, and so do its examples, program and tests,
# which can be built alone, as in CGAL.
include_guard(DIRECTORY)
get_filename_component(ABF_PACKAGE_DIR ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
# In a checkout of CGAL, atlases are a package of their own.
set(ABF_PACKAGES ${ABF_PACKAGE_DIR})
if(NOT EXISTS ${ABF_PACKAGE_DIR}/include/CGAL/Surface_mesh_parameterization)
  list(APPEND ABF_PACKAGES ${ABF_PACKAGE_DIR}/../Angle_based_flattening)
endif()
set(include_dirs ${ABF_PACKAGES})
list(TRANSFORM include_dirs APPEND /include)
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})

# What the headers stand on. CGAL goes first: it brings the module that finds Eigen its way.
find_package(CGAL 5.5 REQUIRED)
find_package(Eigen3 REQUIRED) # Eigen 5, which follows 3.4, is not found by those who ask for 3.4
if("${Eigen3_VERSION}" STREQUAL "")
  set(Eigen3_VERSION "${EIGEN3_VERSION}") # CGAL's module
endif()
if(Eigen3_VERSION VERSION_LESS 3.4)
  message(FATAL_ERROR "Eigen 3.4 or later is needed, and ${Eigen3_VERSION} was found")
endif()
include(CGAL_Eigen3_support)
find_package(SuperLU 5.3 REQUIRED)
include(CGAL_SuperLU_support)
find_package(TBB QUIET)
include(CGAL_TBB_support)

add_library(CGAL_Angle_based_flattening_headers INTERFACE)
add_library(CGAL::Angle_based_flattening_headers ALIAS CGAL_Angle_based_flattening_headers)
set_target_properties(CGAL_Angle_based_flattening_headers PROPERTIES EXPORT_NAME Angle_based_flattening_headers)
target_compile_features(CGAL_Angle_based_flattening_headers INTERFACE cxx_std_17)
target_include_directories(CGAL_Angle_based_flattening_headers INTERFACE
  "$<BUILD_INTERFACE:${include_dirs}>" $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(CGAL_Angle_based_flattening_headers INTERFACE
  CGAL::CGAL CGAL::Eigen3_support $<BUILD_INTERFACE:CGAL::SuperLU_support>)
if(TARGET CGAL::TBB_support) # the installed package looks for both itself
  target_link_libraries(CGAL_Angle_based_flattening_headers INTERFACE $<BUILD_INTERFACE:CGAL::TBB_support>)
endif()

if(ABF_CGAL_INCLUDE_DIR)
  file(STRINGS ${ABF_CGAL_INCLUDE_DIR}/CGAL/version.h version REGEX "#define CGAL_VERSION +[0-9.]+")
  string(REGEX MATCH "[0-9.]+" version "${version}")
  message(STATUS "Using the headers of CGAL ${version} in ${ABF_CGAL_INCLUDE_DIR}")
  target_include_directories(CGAL_Angle_based_flattening_headers SYSTEM BEFORE INTERFACE
    $<BUILD_INTERFACE:${ABF_CGAL_INCLUDE_DIR}>)
endif()

# The libraries above are system headers to the compiler, so it warns of our code only.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  add_compile_options(-Wall -Wextra)
endif()
# Of the number types behind exact predicates, those of GMP are quicker to compile. All that is linked together has to
# agree on them, users' programs with an installed library, too.
if(ABF_TOP_LEVEL AND NOT ABF_INSTALL_CORE)
  add_compile_definitions(CGAL_DO_NOT_USE_BOOST_MP)
endif()
if(ABF_SANITIZE)
  # What the address sanitizer sees anyway is not checked twice, for that takes half of the time to compile. CGAL's
  # MP_Float shifts negative numbers to the left, which is defined from C++20 on only.
  add_compile_options(-fsanitize=${ABF_SANITIZE} -fno-sanitize=null,alignment,object-size,vptr,shift-base
                      -fno-sanitize-recover=undefined -fno-omit-frame-pointer -g1 -O1 -D_GLIBCXX_ASSERTIONS)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    if(ABF_SANITIZE MATCHES address)
      add_compile_definitions(__SANITIZE_ADDRESS__) # as g++ does
    endif()
    add_compile_options(-fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/unchecked_by_sanitizers.txt)
  endif()
  add_link_options(-fsanitize=${ABF_SANITIZE})
endif()

add_library(abf_cholmod INTERFACE) # empty without CHOLMOD
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY)
if(CHOLMOD_INCLUDE_DIR AND CHOLMOD_LIBRARY)
  target_include_directories(abf_cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE_DIR})
  target_link_libraries(abf_cholmod INTERFACE ${CHOLMOD_LIBRARY})
  target_compile_definitions(abf_cholmod INTERFACE ABF_WITH_CHOLMOD)
endif()

# Whether a program is built: `out` becomes true or false.
function(abf_is_wanted name out)
  set(${out} TRUE PARENT_SCOPE)
  if(ABF_ONLY AND NOT name IN_LIST ABF_ONLY)
    set(${out} FALSE PARENT_SCOPE)
  endif()
endfunction()

# The numerics and the default solver, compiled once: most of our programs link with it, so that none of them has to
# compile them again.
set(sources)
foreach(package ${ABF_PACKAGES})
  file(GLOB more CONFIGURE_DEPENDS ${package}/src/*/*.cpp)
  list(APPEND sources ${more})
endforeach()
add_library(CGAL_Angle_based_flattening STATIC EXCLUDE_FROM_ALL ${sources})
add_library(CGAL::Angle_based_flattening ALIAS CGAL_Angle_based_flattening)
set_target_properties(CGAL_Angle_based_flattening PROPERTIES EXPORT_NAME Angle_based_flattening)
target_link_libraries(CGAL_Angle_based_flattening PUBLIC CGAL::Angle_based_flattening_headers)
target_compile_definitions(CGAL_Angle_based_flattening PUBLIC CGAL_ANGLE_BASED_FLATTENING_COMPILED)
# What most of their units include from elsewhere is parsed once for the library and the program.
target_precompile_headers(CGAL_Angle_based_flattening PRIVATE
  <algorithm> <array> <iostream> <map> <optional> <sstream> <string> <vector>
  <CGAL/Exact_predicates_inexact_constructions_kernel.h> <CGAL/Simple_cartesian.h> <CGAL/Surface_mesh.h>
  <CGAL/boost/graph/Euler_operations.h>
  <CGAL/Polygon_mesh_processing/connected_components.h> <CGAL/Polygon_mesh_processing/measure.h> <Eigen/Core>)

# Most tests and examples take longer to compile than to run. So they are not optimized, and share precompiled headers
# of their own, for g++ takes the level of optimization from precompiled headers.
get_target_property(ABF_PRECOMPILED_HEADERS CGAL_Angle_based_flattening PRECOMPILE_HEADERS)
set(ABF_QUICK_OPTIONS $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang>>:-O0>)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/quick_to_compile.cpp CONTENT "")
add_library(abf_quick_to_compile OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/quick_to_compile.cpp)
target_compile_options(abf_quick_to_compile PRIVATE ${ABF_QUICK_OPTIONS})
target_link_libraries(abf_quick_to_compile PRIVATE CGAL::Angle_based_flattening)
target_precompile_headers(abf_quick_to_compile PRIVATE ${ABF_PRECOMPILED_HEADERS}
  <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
  <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
  <CGAL/Texture_atlas/make_atlas.h> <CGAL/Surface_mesh_parameterization/parameterize.h>)

function(abf_compile_quickly target)
  target_compile_options(${target} PRIVATE ${ABF_QUICK_OPTIONS})
  target_precompile_headers(${target} REUSE_FROM abf_quick_to_compile)
endfunction()

# For those that would run too long then
function(abf_optimize_a_little target)
  target_compile_options(${target} PRIVATE $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang>>:-O1>)
endfunction()

# Makes a short example, and a test of what it prints. Examples have the compiled library, but for one that shows the
# headers alone. Sanitized builds have none, because the sanitizers see all of it in the tests.
function(abf_add_example name output)
  abf_is_wanted(${name} wanted)
  if(ABF_SANITIZE OR NOT wanted)
    return()
  endif()
  add_executable(${name} ${name}.cpp)
  if(name STREQUAL "abf_plus_plus_polyhedron")
    target_link_libraries(${name} PRIVATE CGAL::Angle_based_flattening_headers ${ARGN})
    target_compile_options(${name} PRIVATE ${ABF_QUICK_OPTIONS})
  else()
    target_link_libraries(${name} PRIVATE CGAL::Angle_based_flattening ${ARGN})
    if(name STREQUAL "compare_parameterizers")
      abf_optimize_a_little(${name})
    else()
      abf_compile_quickly(${name})
    endif()
  endif()
  add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  set_tests_properties(${name} PROPERTIES TIMEOUT 600 PASS_REGULAR_EXPRESSION "${output}")
endfunction()
