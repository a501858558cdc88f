# WebAssembly by Emscripten (Debian: emscripten), programs run by node.
#
# WINDROW_WASM_SIMD=OFF: for browsers without SIMD of 128 bits. No threads: a page would need headers of its server for them.
set(EMSCRIPTEN_ROOT_PATH /usr/share/emscripten CACHE PATH "Where Emscripten is")
set(EMSCRIPTEN_SYSTEM_PROCESSOR wasm32)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
include(${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake)
option(WINDROW_WASM_SIMD "Vector instructions of 128 bits" ON)
set(windrow_wasm_flags "-include ${CMAKE_CURRENT_LIST_DIR}/emscripten_library.h")
if(WINDROW_WASM_SIMD)
  string(APPEND windrow_wasm_flags " -msimd128")
endif()
set(CMAKE_CXX_FLAGS_INIT "${windrow_wasm_flags}")
# No exceptions: the library throws only where memory is missing. There a module aborts.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-sALLOW_MEMORY_GROWTH=1 -sTOTAL_STACK=1048576 -sENVIRONMENT=node,web,worker")
set(glm_DIR ${CMAKE_CURRENT_LIST_DIR}/glm)
set(nlohmann_json_DIR ${CMAKE_CURRENT_LIST_DIR}/nlohmann_json)
set(WINDROW_VDB OFF CACHE BOOL "")
set(WINDROW_VULKAN OFF CACHE BOOL "")
set(WINDROW_IMAGES OFF CACHE BOOL "")
# Debian's JavaScript packages, which the linker calls, are where node does not look.
set(CMAKE_CXX_LINKER_LAUNCHER ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs)
find_program(WINDROW_NODE NAMES node nodejs REQUIRED)
# The loader of this Emscripten takes a fetch of node's for a browser's.
set(CMAKE_CROSSCOMPILING_EMULATOR ${WINDROW_NODE} --no-experimental-fetch)
