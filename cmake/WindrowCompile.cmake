# How every target of the project is compiled.
option(WINDROW_PRECOMPILE "Precompile the headers that most files of a target include" ON)
# Half of the time of a whole build; after a change of one file its group is compiled. The presets dev and clang compile each file by
# itself, and so does an outside project that sets nothing.
set(WINDROW_UNITY 0 CACHE STRING "Files that are compiled as one; 0: each by itself")

option(WINDROW_PORTABLE "Link the command and the library in C for any Linux with glibc 2.34: libraries of C++ within them" OFF)

# What is small rather than quick. Emscripten's -Oz turns inlining off, which doubles what templates of the standard library take.
set(WINDROW_SMALL $<IF:$<BOOL:${EMSCRIPTEN}>,-Oz$<SEMICOLON>-finline-functions,-Os>)

# windrow_compile(TARGET [LIGHT | TEST])
#
# -ffp-contract=off: a product and a sum stay two roundings unless a kernel asks for a fused one by name, so that one
# source gives one result for each SIMD level whatever the compiler. -fno-fast-math: a host that compiles with -ffast-math does not
# change what the library computes.
# LIGHT: code around the library (the command, file readers). It is compiled far more often than its own loops run, and -O1 takes
# half the time. TEST: what calls the library and compares; -Og takes five sixths of that. Results are the same: without
# fast-math and contraction no level of optimization changes a bit, except of functions of libm whose arguments are constants.
function(windrow_compile target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "LIGHT;TEST" "" "")
  if(arg_TEST)
    set(arg_LIGHT ON)
  endif()
  set(level -O3)
  if(EMSCRIPTEN) # a page is downloaded each time it is opened; the core names the level of each file, since em++ mixes two
    set(level "$<$<NOT:$<STREQUAL:${target},windrow_fluid>>:${WINDROW_SMALL}>")
  elseif(WINDROW_PORTABLE) # what is copied to other machines is downloaded; the core names files of other levels
    set(level $<IF:$<BOOL:${arg_LIGHT}>,-Os,-O2>)
  elseif(arg_TEST)
    set(level -Og)
  elseif(arg_LIGHT)
    set(level -O1)
  endif()
  # Files of the project write "fluid/box.h", users <windrow/fluid/box.h>: what links a target gets no folder of ours but that.
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF CXX_VISIBILITY_PRESET hidden
                        VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                         -fno-fast-math -ffp-contract=off -fno-math-errno -fno-trapping-math $<$<OR:$<CONFIG:>,$<CONFIG:Release>>:${level}>
                         $<$<BOOL:${WINDROW_WERROR}>:-Werror>)
  if(WINDROW_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${WINDROW_UNITY})
    # Groups of files need more memory than GCC begins to collect at, which takes a twelfth of the time: up to 1 GB each.
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=1000000>)
    # Names of one file hide those of another, and GCC takes a .cpp for a header and warns of its unnamed namespaces.
    target_compile_options(${target} PRIVATE -Wno-shadow $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)
  endif()
  if(WINDROW_SANITIZE)
    # GCC takes what a sanitizer adds for uses of unset values.
    target_compile_options(${target} PRIVATE -fsanitize=${WINDROW_SANITIZE} -fno-omit-frame-pointer
                           $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-maybe-uninitialized>)
    target_link_options(${target} PUBLIC -fsanitize=${WINDROW_SANITIZE})
    if(arg_LIGHT AND NOT WINDROW_FUZZ)
      target_compile_options(${target} PRIVATE -Og)
    endif()
    if(WINDROW_SANITIZE MATCHES "undefined" AND (arg_LIGHT OR NOT WINDROW_FUZZ))
      # Checks of each pointer double the time of compiling, and AddressSanitizer's own find most of it; the library that is fuzzed
      # has them all, since there a file's bytes become its values.
      target_compile_options(${target} PRIVATE -fno-sanitize=null,alignment,vptr,object-size)
    endif()
  endif()
endfunction()

# The public headers as users find them, in the build folder: the same files under include/windrow, and the formulas that they include.
set(WINDROW_INCLUDE ${PROJECT_BINARY_DIR}/include)
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/public_headers.txt WINDROW_PUBLIC_HEADERS REGEX "^[^#]")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/public_headers.txt)
file(GLOB formulas RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/numerics/*.glsl)
file(REMOVE_RECURSE ${WINDROW_INCLUDE}/windrow)
foreach(file IN LISTS WINDROW_PUBLIC_HEADERS formulas)
  string(REPLACE "c_api/windrow.h" "windrow.h" name ${file}) # the C interface: #include <windrow/windrow.h>
  cmake_path(GET name PARENT_PATH folder)
  file(MAKE_DIRECTORY ${WINDROW_INCLUDE}/windrow/${folder})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${file} ${WINDROW_INCLUDE}/windrow/${name} SYMBOLIC COPY_ON_ERROR)
endforeach()

# windrow_library(TARGET COMPONENT): what each library of the package is: found as <windrow/...>, with position-independent code so that
# a plug-in can link its archive. Until 1.0 a minor version may change the API, so the name of a shared one holds it.
function(windrow_library target component)
  add_library(windrow::${component} ALIAS ${target})
  windrow_compile(${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${component} POSITION_INDEPENDENT_CODE ON
                        VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${WINDROW_INCLUDE}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "STATIC_LIBRARY")
    target_compile_definitions(${target} PUBLIC WINDROW_STATIC)
  elseif(NOT WIN32 AND NOT APPLE)
    # What templates of the standard library and of OpenVDB mark as visible would be found in the place of a host's own.
    target_link_options(${target} PRIVATE -Wl,--version-script=${PROJECT_SOURCE_DIR}/cmake/exports.map)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/exports.map)
  endif()
endfunction()

# windrow_portable(TARGET): what is built to be copied to other machines (the preset portable, the wheels of Python) holds the libraries of
# C++, and no function that nothing calls.
if(WINDROW_PORTABLE)
  add_compile_options(-ffunction-sections -fdata-sections)
endif()
function(windrow_portable target)
  if(NOT WINDROW_PORTABLE)
    return()
  endif()
  target_compile_options(${target} PRIVATE ${WINDROW_SMALL}) # loops that take time are in the libraries within it
  target_link_options(${target} PRIVATE -static-libstdc++ -static-libgcc -Wl,--gc-sections)
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/portable_glibc.cpp)
    set_source_files_properties(${PROJECT_SOURCE_DIR}/cmake/portable_glibc.cpp TARGET_DIRECTORY ${target}
                                PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

# windrow_link_openvdb(TARGET): for a target that includes OpenVDB's headers. Their templates are one copy with OpenVDB's own library: half
# hidden, its registry of grids crashes. Headers that others precompiled are hidden.
function(windrow_link_openvdb target)
  target_link_libraries(${target} PRIVATE OpenVDB::openvdb)
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET default VISIBILITY_INLINES_HIDDEN OFF
                        DISABLE_PRECOMPILE_HEADERS ON)
endfunction()

# windrow_precompile(TARGET HEADER...): precompiles what most of its files include. For targets that are not installed: the library
# itself is always compiled as it stands, so that a file that lacks an include is found there. For the rest the build with clang
# (./dev test all) goes without.
function(windrow_precompile target)
  if(WINDROW_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory>
      <optional> <span> <string> <string_view> <utility> <variant> <vector> <glm/glm.hpp> ${ARGN})
  endif()
endfunction()
