# Takes Windrow in as a subdirectory of an outside project, as shared libraries, with none of the optional parts, on a machine
# where none of their libraries can be found; then reads from the files which libraries the core asks for.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK})
# Each file by itself and with debug information, as outside projects compile them, takes three times as long: that is left to
# ./dev test all.
if(NOT "$ENV{WINDROW_TIER}" STREQUAL "all")
  set(quick -D WINDROW_UNITY=8 -D CMAKE_CXX_FLAGS_DEBUG=-O0)
endif()
set(configure ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE} -D CMAKE_CXX_COMPILER=${CXX}
  -D BUILD_SHARED_LIBS=ON -D WINDROW=${WINDROW} -D WINDROW_COUPLING=OFF -D WINDROW_VDB=OFF -D WINDROW_VULKAN=OFF -D WINDROW_IMAGES=OFF
  -D CMAKE_DISABLE_FIND_PACKAGE_OpenVDB=ON -D CMAKE_DISABLE_FIND_PACKAGE_OpenImageIO=ON
  -D CMAKE_DISABLE_FIND_PACKAGE_VulkanHeaders=ON -D CMAKE_DISABLE_FIND_PACKAGE_GTest=ON -D CMAKE_DISABLE_FIND_PACKAGE_CLI11=ON
  -D WINDROW_PROFILER_HEADER=${SOURCE}/zones.h ${quick})
run("Configuring without a build type" ${configure} -B ${WORK}/untyped)
run("Configuring" ${configure} -B ${WORK}/build -D CMAKE_BUILD_TYPE=Debug)
run("Building" ${CMAKE_COMMAND} --build ${WORK}/build)
run("Running" ${WORK}/build/core)

file(GLOB_RECURSE libraries ${WORK}/build/libwindrow_*.so)
if(NOT libraries MATCHES "^[^;]*/libwindrow_fluid\\.so$")
  message(FATAL_ERROR "The core alone should be libwindrow_fluid.so, but there is: ${libraries}")
endif()
run("Reading what it exports" nm --dynamic --defined-only --demangle ${libraries})
string(REGEX REPLACE "\n[0-9a-f]+ . (windrow::|(vtable|typeinfo|typeinfo name) for windrow)[^\n]*" "" others "\n${output}")
if(NOT output MATCHES "windrow::Wind::create" OR output MATCHES "windrow::cpu::Cells::step|Workspace::State::" OR others MATCHES "[^\n]")
  message(FATAL_ERROR "${libraries} exports what is no part of the API, or not the API:\n${others}\n${output}")
endif()
foreach(file IN ITEMS ${libraries} ${WORK}/build/core)
  run("Reading ${file}" readelf --dynamic --wide ${file})
  string(REGEX MATCHALL "\\(NEEDED\\)[^\n]*" needed "${output}")
  if(NOT needed)
    message(FATAL_ERROR "readelf names no library for ${file}:\n${output}")
  endif()
  list(TRANSFORM needed REPLACE ".*\\[(.*)\\].*" "\\1")
  message(STATUS "  needs ${needed}")
  foreach(library IN LISTS needed)
    if(NOT library MATCHES "^(libwindrow_fluid|libstdc\\+\\+|libm|libgcc_s|libc|libpthread|ld-linux-.*)\\.so")
      message(FATAL_ERROR "${file} needs ${library}; the core may need nothing beyond the language's own libraries")
    endif()
  endforeach()
endforeach()
