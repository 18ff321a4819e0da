# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Copies the libraries of the module `core` into the wheel, but for those of the compiler and of the system, which each
# system with Python has.
file(GET_RUNTIME_DEPENDENCIES MODULES ${core} RESOLVED_DEPENDENCIES_VAR libraries
  PRE_EXCLUDE_REGEXES "^lib(c|m|dl|rt|pthread|util|stdc[+][+]|gcc_s|python3.*)[.]so" "^ld-linux")
set(folder $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/angle_based_flattening.libs)
file(MAKE_DIRECTORY ${folder}/copyright)
find_program(DPKG_QUERY dpkg-query)
foreach(library ${libraries})
  get_filename_component(name ${library} NAME)
  file(REAL_PATH ${library} file) # wheels have no symbolic links
  message(STATUS "Copying ${name} of ${file}")
  file(COPY_FILE ${file} ${folder}/${name})
  if(DPKG_QUERY) # Debian's packages have their licences at a known place
    execute_process(COMMAND ${DPKG_QUERY} -S ${file} OUTPUT_VARIABLE package RESULT_VARIABLE result ERROR_QUIET)
    string(REGEX REPLACE "^([^:]*):.*" "\\1" package "${package}")
    if(result EQUAL 0 AND EXISTS /usr/share/doc/${package}/copyright)
      file(COPY_FILE /usr/share/doc/${package}/copyright ${folder}/copyright/${package})
    endif()
  endif()
endforeach()
