# Drops both packages into a checkout of CGAL, and then configures their examples and tests alone, and builds and runs
# an example of each.
# Called by ctest with SOURCE_DIR, BASH, CGAL_DIR and CGAL_INCLUDE_DIR of the CGAL that the checkout is made of,
# BUILD_DIR, GENERATOR, COMPILER, CONFIG and its FLAGS.
set(checkout ${BUILD_DIR}/CGAL_checkout)
set(build ${BUILD_DIR}/CGAL_checkout_build)
file(REMOVE_RECURSE ${checkout} ${build})

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The folders by which CGAL finds out that it is a checkout: then each of its packages has headers of its own.
set(installation ${checkout}/Installation)
file(MAKE_DIRECTORY ${installation}/package_info/Installation ${installation}/include)
file(CREATE_LINK ${CGAL_INCLUDE_DIR}/CGAL ${installation}/include/CGAL SYMBOLIC)
file(GLOB modules ${CGAL_DIR}/*.cmake)
file(COPY ${modules} DESTINATION ${installation}/cmake/modules)
file(COPY ${modules} DESTINATION ${installation}/lib/cmake/CGAL)

file(MAKE_DIRECTORY ${checkout}/Solver_interface/package_info/Solver_interface)

run(${BASH} ${SOURCE_DIR}/scripts/drop-into-cgal ${checkout})
file(READ ${checkout}/Texture_atlas/include/CGAL/Texture_atlas/make_atlas.h header)
string(CONCAT head "^// Copyright[^\n]*\n// All rights reserved.\n//\n// This file is part of CGAL \\(www.cgal.org\\).\n"
  "//\n// \\$URL\\$\n// \\$Id\\$\n// SPDX-[^\n]*\n//\n//\n// Author\\(s\\)     : [^\n]*\n\n#ifndef")
if(NOT header MATCHES "${head}")
  message(FATAL_ERROR "make_atlas.h does not begin as headers of CGAL do")
endif()

foreach(part Angle_based_flattening/examples Angle_based_flattening/test Texture_atlas/examples)
  get_filename_component(package ${part} DIRECTORY)
  run(${CMAKE_COMMAND} -S ${checkout}/${part}/${package} -B ${build}/${part} -G ${GENERATOR}
    -D CGAL_DIR=${installation}/lib/cmake/CGAL
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_CXX_FLAGS_RELEASE=${FLAGS})
endforeach()

foreach(example Angle_based_flattening/abf_plus_plus_polyhedron Texture_atlas/abf_plus_plus_seam_mesh)
  get_filename_component(package ${example} DIRECTORY)
  get_filename_component(name ${example} NAME)
  run(${CMAKE_COMMAND} --build ${build}/${package}/examples --config ${CONFIG} --target ${name})
  run(${CMAKE_CTEST_COMMAND} --test-dir ${build}/${package}/examples --build-config ${CONFIG} --no-tests=error
    --output-on-failure --tests-regex ^${name}$)
endforeach()
