# Copyright (c) 2026 The Angle_based_flattening authors.
# All rights reserved.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

# Finds the sequential library SuperLU.
#
# Result variables: SuperLU_FOUND, SuperLU_VERSION, SuperLU_INCLUDE_DIR, SuperLU_LIBRARY
# Imported target:  SuperLU::SuperLU
#
# Hints: the variable or environment variable SuperLU_ROOT

# A package configuration, as Debian has it, knows of the BLAS the library was linked with.
find_package(superlu CONFIG QUIET)
if(TARGET superlu::superlu)
  get_target_property(_superlu_include_dirs superlu::superlu INTERFACE_INCLUDE_DIRECTORIES)
  if(NOT _superlu_include_dirs)
    set(_superlu_include_dirs)
  endif()
endif()

find_path(SuperLU_INCLUDE_DIR
  NAMES slu_ddefs.h
  HINTS ${_superlu_include_dirs}
  PATH_SUFFIXES superlu SuperLU SRC)
find_library(SuperLU_LIBRARY NAMES superlu)
mark_as_advanced(SuperLU_INCLUDE_DIR SuperLU_LIBRARY)
unset(_superlu_include_dirs)

set(SuperLU_VERSION)
if(SuperLU_INCLUDE_DIR AND EXISTS "${SuperLU_INCLUDE_DIR}/slu_util.h")
  foreach(_superlu_part MAJOR MINOR PATCH)
    file(STRINGS "${SuperLU_INCLUDE_DIR}/slu_util.h" _superlu_line
      REGEX "^#define[ \t]+SUPERLU_${_superlu_part}_VERSION[ \t]+[0-9]+")
    if(_superlu_line MATCHES "VERSION[ \t]+([0-9]+)")
      list(APPEND SuperLU_VERSION ${CMAKE_MATCH_1})
    endif()
  endforeach()
  string(REPLACE ";" "." SuperLU_VERSION "${SuperLU_VERSION}")
  unset(_superlu_line)
  unset(_superlu_part)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuperLU
  REQUIRED_VARS SuperLU_LIBRARY SuperLU_INCLUDE_DIR
  VERSION_VAR SuperLU_VERSION)

if(SuperLU_FOUND AND NOT TARGET SuperLU::SuperLU)
  add_library(SuperLU::SuperLU INTERFACE IMPORTED)
  set_target_properties(SuperLU::SuperLU PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${SuperLU_INCLUDE_DIR}")
  if(TARGET superlu::superlu)
    set_target_properties(SuperLU::SuperLU PROPERTIES INTERFACE_LINK_LIBRARIES superlu::superlu)
  else()
    set(_superlu_libraries "${SuperLU_LIBRARY}")
    # a static library does not bring its BLAS along
    if(SuperLU_LIBRARY MATCHES "\\.(a|lib)$")
      find_package(BLAS QUIET)
      if(BLAS_FOUND) # otherwise, what SuperLU calls of it is inside
        list(APPEND _superlu_libraries ${BLAS_LIBRARIES})
      endif()
    endif()
    set_target_properties(SuperLU::SuperLU PROPERTIES INTERFACE_LINK_LIBRARIES "${_superlu_libraries}")
    unset(_superlu_libraries)
  endif()
endif()
