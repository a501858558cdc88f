# Installs this build into an empty prefix, moves the prefix, and builds and runs a project in C against it.
include(${CMAKE_CURRENT_LIST_DIR}/../package/run.cmake)

file(REMOVE_RECURSE ${WORK})
run("Installing" ${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${WORK}/first)
file(RENAME ${WORK}/first ${WORK}/prefix)
run("Configuring" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${CMAKE_CURRENT_LIST_DIR}/package -B ${WORK}/build -D CMAKE_C_COMPILER=${CC}
  -D CMAKE_PREFIX_PATH=${WORK}/prefix -D SOURCE=${SOURCE})
run("Building" ${CMAKE_COMMAND} --build ${WORK}/build)
run("Running" ${WORK}/build/outside)
if(NOT output MATCHES "^[0-9.]+ m/s at the leaf\n$")
  message(FATAL_ERROR "The outside program prints: ${output}")
endif()
# The installed library alone, and the one with OpenVDB beside it.
file(GLOB_RECURSE library ${WORK}/prefix/libwindrow.so ${WORK}/prefix/libwindrow.dylib)
run("Loading the installed library" ${PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/library_test.py --guest ${CMAKE_CURRENT_LIST_DIR}/../../c_api ${library})
# The same without CMake.
file(GLOB_RECURSE pc ${WORK}/prefix/windrow-c.pc)
cmake_path(GET pc PARENT_PATH pc)
set(ENV{PKG_CONFIG_PATH} ${pc})
run("Asking pkg-config" pkg-config --cflags --libs windrow-c)
separate_arguments(flags UNIX_COMMAND "${output}")
run("Building by pkg-config" ${CC} -std=c89 ${SOURCE} ${flags} -o ${WORK}/by_pkg_config)
run("Running it" ${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${pc}/.. ${WORK}/by_pkg_config)
run("Reading what it needs" readelf --dynamic --wide ${WORK}/build/outside)
if(NOT output MATCHES "NEEDED[^\n]*libwindrow\\.so\\.0\\.1\\]" OR output MATCHES "libstdc")
  message(FATAL_ERROR "The outside program needs:\n${output}")
endif()
