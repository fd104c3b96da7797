# Installs the package into an empty folder, then configures, builds and runs a user's project
# that knows nothing but that folder.

set(prefix "${WORK_DIR}/prefix")
file(REMOVE_RECURSE "${WORK_DIR}")

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "exit status ${status}: ${ARGV}")
  endif()
endfunction()

run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}" --component development)
run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
    "-DCMAKE_PREFIX_PATH=${prefix}" -DCMAKE_BUILD_TYPE=None
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_CXX_COMPILER_LAUNCHER=${CXX_COMPILER_LAUNCHER}"
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS} -O0"  # the time goes into compiling "-DCGAL_DIR=${CGAL_DIR}"
    "-DPoint_set_consolidation_3_WITH_TBB=${WITH_TBB}")
file(STRINGS "${WORK_DIR}/build/CMakeCache.txt" found
     REGEX "^Point_set_consolidation_3_DIR:PATH=${prefix}/")
if(NOT found)
  message(FATAL_ERROR "another copy of the package was found than the installed one")
endif()
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build")
run("${WORK_DIR}/build/user_program" "${WITH_TBB}" "${WITH_CORE}" "${WORK_DIR}/deep_points.txt")
if(SAME_AS)
  run("${CMAKE_COMMAND}" -E compare_files "${WORK_DIR}/deep_points.txt" "${SAME_AS}/deep_points.txt")
endif()
