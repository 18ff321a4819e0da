# Installs the package into its build tree, then builds and runs the project in this folder against it.
# Called by ctest with BUILD_DIR, NAME, GENERATOR, COMPILER, STANDARD, CONFIG and its FLAGS. COMPONENTS is what the
# project asks for. With WITHOUT_TBB and WITHOUT_SUPERLU, it does not find these. With DPKG_DEB, a Debian package is
# installed, which has the same files: the project only finds it.
set(root ${BUILD_DIR}/${NAME}_root)
set(project ${BUILD_DIR}/${NAME})
file(REMOVE_RECURSE ${root} ${project})

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

if(DPKG_DEB)
  run(${CMAKE_CPACK_COMMAND} -G DEB -C ${CONFIG} --config ${BUILD_DIR}/CPackConfig.cmake -B ${root})
  file(GLOB package ${root}/*.deb)
  run(${DPKG_DEB} --extract ${package} ${root})
  execute_process(COMMAND ${DPKG_DEB} --field ${package} OUTPUT_VARIABLE fields COMMAND_ERROR_IS_FATAL ANY)
  foreach(field "Architecture: all" "Depends: libcgal-dev .*, libeigen3-dev .*, libsuperlu-dev ")
    if(NOT fields MATCHES "${field}")
      message(FATAL_ERROR "${package} lacks '${field}':\n${fields}")
    endif()
  endforeach()
  set(prefix ${root}/usr)
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${root}/installed --config ${CONFIG})
  run(${CMAKE_COMMAND} -E env diff --recursive ${prefix} ${root}/installed)
else()
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${root} --config ${CONFIG})
  set(prefix ${root})
endif()

set(configure ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${project} -G ${GENERATOR}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_STANDARD=${STANDARD} -D CMAKE_BUILD_TYPE=${CONFIG}
  -D CMAKE_CXX_FLAGS_RELEASE=${FLAGS} -D CMAKE_PREFIX_PATH=${prefix}
  -D CMAKE_DISABLE_FIND_PACKAGE_TBB=${WITHOUT_TBB} -D WITHOUT_TBB=${WITHOUT_TBB}
  -D CMAKE_DISABLE_FIND_PACKAGE_SuperLU=${WITHOUT_SUPERLU} -D WITHOUT_SUPERLU=${WITHOUT_SUPERLU})
if(NOT COMPONENTS) # who asks for the compiled library is told how to get it
  execute_process(COMMAND ${configure} -D COMPONENTS=core RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE message)
  if(result EQUAL 0 OR NOT message MATCHES "Install.*the.*package.*with.*-DABF_INSTALL_CORE=ON")
    message(FATAL_ERROR "the compiled library is found, or nothing says how to get it:\n${message}")
  endif()
endif()
run(${configure} -D COMPONENTS=${COMPONENTS})
if(NOT DPKG_DEB)
  run(${CMAKE_COMMAND} --build ${project} --config ${CONFIG} --target run)
endif()
