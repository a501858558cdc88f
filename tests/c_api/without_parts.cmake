# Builds the C library without plants, files and devices: it has the same functions, and those of the missing parts return
# WINDROW_UNSUPPORTED. The host runs with it, and so does a project in C after installation.
include(${CMAKE_CURRENT_LIST_DIR}/../package/run.cmake)

file(REMOVE_RECURSE ${WORK})
run("Configuring" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${WINDROW} -B ${WORK}/build -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_BUILD_TYPE=Release
  -D WINDROW_COUPLING=OFF -D WINDROW_VDB=OFF -D WINDROW_VULKAN=OFF -D WINDROW_IMAGES=OFF -D WINDROW_VEGETATION=OFF -D WINDROW_CLI=OFF
  -D WINDROW_EXAMPLES=OFF -D WINDROW_TESTS=OFF -D WINDROW_UNITY=8)
run("Building" ${CMAKE_COMMAND} --build ${WORK}/build --target windrow_c)
file(GLOB host_files ${CMAKE_CURRENT_LIST_DIR}/host*.c)
file(MAKE_DIRECTORY ${WORK}/files)
run("Compiling the host" ${CC} -std=c89 -I ${WORK}/build/include ${host_files} -o ${WORK}/host -L ${WORK}/build/c_api -lwindrow -lm
  -Wl,-rpath,${WORK}/build/c_api)
run("Running the host" ${WORK}/host ${WORK}/files)
run("Comparing with the headers" ${PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/library_test.py ${WINDROW}/c_api ${WORK}/build/c_api/libwindrow.so)
run("Reading what it needs" readelf --dynamic --wide ${WORK}/build/c_api/libwindrow.so)
if(output MATCHES "openvdb|vulkan|tbb")
  message(FATAL_ERROR "The library without parts needs:\n${output}")
endif()
