# Installs the package into its build tree, then builds and runs the project in this folder against it.
# Called by ctest with BUILD_DIR, GENERATOR, COMPILER, CONFIG.
set(prefix ${BUILD_DIR}/installed)
set(project ${BUILD_DIR}/installed_project)
file(REMOVE_RECURSE ${prefix} ${project})

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix} --config ${CONFIG})
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${project} -G ${GENERATOR}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${project} --config ${CONFIG} --target run)
