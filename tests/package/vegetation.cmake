# Installs this build into an empty prefix, moves the prefix, and builds and runs an outside program that draws grass with it.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK})
run("Installing" ${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${WORK}/first)
file(RENAME ${WORK}/first ${WORK}/prefix)

# The wind's own folder of shaders holds only what the wind uses.
file(GLOB_RECURSE wind_shaders RELATIVE ${WORK}/prefix/share/windrow/shaders ${WORK}/prefix/share/windrow/shaders/*)
if(wind_shaders MATCHES "grass|strand_field|tree_levels|cloud|sky")
  message(FATAL_ERROR "share/windrow/shaders holds formulas of the vegetation: ${wind_shaders}")
endif()

run("Configuring" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE} -B ${WORK}/build -D CMAKE_CXX_COMPILER=${CXX}
  -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_PREFIX_PATH=${WORK}/prefix -D VERSION=${VERSION} -D GLSLANG=${GLSLANG})
run("Building" ${CMAKE_COMMAND} --build ${WORK}/build)
run("Drawing grass" ${WORK}/build/outside ${WORK}/grass.ppm)
run("Drawing bare ground" ${WORK}/build/outside ${WORK}/bare.ppm bare)
run("Comparing the pictures" ${PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/vegetation_pictures.py ${WORK}/grass.ppm ${WORK}/bare.ppm)

# The program needs no library for files: neither pictures, meshes nor JSON.
run("Reading what it needs" readelf --dynamic --wide ${WORK}/build/outside)
if(output MATCHES "OpenImageIO|assimp|openvdb")
  message(FATAL_ERROR "The outside program needs a library for files:\n${output}")
endif()
