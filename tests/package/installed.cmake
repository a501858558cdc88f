# Installs this build into an empty prefix, moves the prefix, and builds and runs an outside program against it.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK})
run("Installing" ${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${WORK}/first)
# A package that holds the path of its prefix works only where it was made.
file(RENAME ${WORK}/first ${WORK}/prefix)

file(GLOB_RECURSE headers RELATIVE ${WORK}/prefix/include/windrow ${WORK}/prefix/include/windrow/*.h)
if(NOT "fluid/wind.h" IN_LIST headers)
  message(FATAL_ERROR "fluid/wind.h is not installed")
endif()
# Neither headers nor formulas of the renderer are.
file(GLOB_RECURSE installed RELATIVE ${WORK}/prefix ${WORK}/prefix/include/* ${WORK}/prefix/lib*/* ${WORK}/prefix/share/windrow/shaders/*)
if(installed MATCHES "[^;]*(vegetation|grass|strand_field|tree_levels|cloud|sky)[^;]*")
  message(FATAL_ERROR "${CMAKE_MATCH_0} of the renderer is installed")
endif()
run("Compiling a host's shader" ${GLSLANG} --quiet -V --target-env vulkan1.2 -I${WORK}/prefix/share/windrow/shaders
  -o ${WORK}/plant.spv ${SOURCE}/plant.vert)
# windrow::vulkan takes all calls from the host: it opens no library and needs no symbol of a loader.
if(VULKAN)
  file(GLOB_RECURSE library ${WORK}/prefix/libwindrow_vulkan.*)
  list(GET library 0 library)
  run("Reading what windrow::vulkan needs" nm --undefined-only ${library})
  if(output MATCHES " U (dl[a-z]+|vk[A-Z][A-Za-z]+)")
    message(FATAL_ERROR "${library} needs ${CMAKE_MATCH_1}")
  endif()
endif()

# The README's program, word for word.
file(READ ${README} text)
string(FIND "${text}" "```cpp\n" begin)
if(begin EQUAL -1)
  message(FATAL_ERROR "${README} shows no program to embed")
endif()
math(EXPR begin "${begin} + 7")
string(SUBSTRING "${text}" ${begin} -1 text)
string(FIND "${text}" "\n```" end)
string(SUBSTRING "${text}" 0 ${end} text)
file(WRITE ${WORK}/readme.cpp "${text}\n")

set(components fluid)
if(COUPLING)
  list(APPEND components coupling)
endif()
if(VDB)
  list(APPEND components vdb)
endif()
if(VULKAN)
  list(APPEND components vulkan)
endif()
if(COUPLING AND VULKAN)
  list(APPEND components coupling_vulkan)
endif()
set(configure ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE} -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_BUILD_TYPE=${CONFIG}
              -D CMAKE_CXX_FLAGS_RELEASE=-O0 # a consumer is compiled to see that it compiles
              -D CMAKE_PREFIX_PATH=${WORK}/prefix)

# Each installed header by itself takes two minutes: ./dev test all has them all, other runs every eighth.
if(NOT "$ENV{WINDROW_TIER}" STREQUAL "all")
  set(some "")
  set(number 0)
  foreach(header IN LISTS headers)
    math(EXPR turn "${number} % 8")
    if(turn EQUAL 0)
      list(APPEND some ${header})
    endif()
    math(EXPR number "${number} + 1")
  endforeach()
  set(headers ${some})
endif()

# Lists travel with commas, since a semicolon would part them on the way.
list(JOIN components "," components)
list(JOIN headers "," headers)
run("Configuring a consumer" ${configure} -B ${WORK}/build -D VERSION=${VERSION} -D COMPONENTS=${components} -D HEADERS=${headers}
  -D README=${WORK}/readme.cpp)
run("Building it" ${CMAKE_COMMAND} --build ${WORK}/build)
run("Running it" ${CMAKE_COMMAND} -E chdir ${WORK} ${WORK}/build/consumer)
run("Running the README's program" ${WORK}/build/readme)
run("Running an engine with a plug-in" ${WORK}/build/engine ${WORK}/build/libplugin.so)
run("Reading what the plug-in exports" nm --dynamic --defined-only ${WORK}/build/libplugin.so)
if(output MATCHES " [TDB] _ZN[A-Z]*7windrow")
  message(FATAL_ERROR "The plug-in exports the library that it links, so that two plug-ins would share one:\n${output}")
endif()

# The same program without CMake.
file(GLOB_RECURSE pc ${WORK}/prefix/windrow-fluid.pc)
cmake_path(GET pc PARENT_PATH pc)
set(ENV{PKG_CONFIG_PATH} ${pc})
run("Asking pkg-config" pkg-config --cflags --libs windrow-fluid)
separate_arguments(flags UNIX_COMMAND "${output}")
run("Building by pkg-config" ${CXX} -std=c++20 ${WORK}/readme.cpp ${flags} -o ${WORK}/by_pkg_config)
run("Running it" ${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${pc}/.. ${WORK}/by_pkg_config)

# What would crash a host is a sentence for it.
set(compile ${CXX} ${flags} -fsyntax-only ${WORK}/readme.cpp)
run_expecting_failure("A host below C++20" "error: #error .?Windrow needs C\\+\\+20" ${compile} -std=c++17)
run_expecting_failure("A host whose vectors begin as 0" "Windrow is built without GLM_FORCE_CTOR_INIT" ${compile} -std=c++20 -DGLM_FORCE_CTOR_INIT)
run_expecting_failure("A host whose vectors are aligned" "Windrow is built without GLM_FORCE_DEFAULT_ALIGNED_GENTYPES"
  ${compile} -std=c++20 -DGLM_FORCE_DEFAULT_ALIGNED_GENTYPES -DGLM_FORCE_INTRINSICS)
run_expecting_failure("A host whose quaternions begin with w" "Windrow is built without GLM_FORCE_QUAT_DATA_WXYZ"
  ${compile} -std=c++20 -DGLM_FORCE_QUAT_DATA_WXYZ)

foreach(file IN ITEMS share/man/man1/windrow.1 share/bash-completion/completions/windrow share/zsh/site-functions/_windrow
                      share/windrow/scenes/scene.schema.json share/windrow/scenes/walk.json share/doc/windrow/README.md
                      share/doc/windrow/docs/how_it_works.md share/doc/windrow/NOTICE)
  if(NOT EXISTS ${WORK}/prefix/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
# Whatever a scene names is there.
file(GLOB_RECURSE scenes ${WORK}/prefix/share/windrow/scenes/*.json)
list(FILTER scenes EXCLUDE REGEX "schema[.]json$")
list(LENGTH scenes count)
if(count LESS 40)
  message(FATAL_ERROR "${count} scenes are installed")
endif()
set(number 0)
foreach(scene IN LISTS scenes)
  math(EXPR number "${number} + 1")
  math(EXPR turn "${number} % 4") # ./dev test all runs them all
  cmake_path(GET scene PARENT_PATH folder)
  file(READ ${scene} text)
  string(REGEX MATCHALL "\"[^\"\n]+[.](obj|mtl|gltf|glb|vox|pgm|ppm|png|tiff?|raw|asc|csv)\"" names "${text}")
  foreach(name IN LISTS names)
    string(REPLACE "\"" "" name ${name})
    if(NOT EXISTS ${folder}/${name})
      message(FATAL_ERROR "${scene} names ${name}, which is not installed")
    endif()
  endforeach()
  if(EXISTS ${WORK}/prefix/bin/windrow AND (turn EQUAL 0 OR "$ENV{WINDROW_TIER}" STREQUAL "all"))
    execute_process(COMMAND ${WORK}/prefix/bin/windrow run ${scene} --frames 1 OUTPUT_QUIET ERROR_VARIABLE output RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
      message(FATAL_ERROR "${scene} does not run where it is installed (${result}):\n${output}")
    endif()
  endif()
endforeach()
if(VDB AND NOT EXISTS ${WORK}/wind.vdb)
  message(FATAL_ERROR "The consumer wrote no wind.vdb:\n${output}")
endif()

run_expecting_failure("A component that there is not" "windrow has no component 'ocean'; it has fluid"
  ${configure} -B ${WORK}/rejected -D VERSION=${VERSION} -D COMPONENTS=fluid,ocean)
run_expecting_failure("Another minor version" "version \"0\\.9\""
  ${configure} -B ${WORK}/rejected -D VERSION=0.9 -D COMPONENTS=fluid)
