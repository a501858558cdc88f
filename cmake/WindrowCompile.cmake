# How every target of the project is compiled.
option(WINDROW_PRECOMPILE "Precompile the headers that most files of a target include" ON)

# windrow_compile(TARGET [LIGHT])
#
# -ffp-contract=off: a product and a sum stay two roundings unless a kernel asks for a fused one by name, so that one
# source gives one result for each SIMD level whatever the compiler. -fno-fast-math: a host that compiles with -ffast-math does not
# change what the library computes.
# LIGHT: code around the library (the command, file readers, tests). It is compiled far more often than its own loops run, and
# -O1 takes half the time. Results are the same: without fast-math and contraction no level of optimization changes a bit.
function(windrow_compile target)
  cmake_parse_arguments(PARSE_ARGV 1 arg LIGHT "" "")
  set(level -O3)
  if(arg_LIGHT)
    set(level -O1)
  endif()
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/windrow>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                         -fno-fast-math -ffp-contract=off -fno-math-errno -fno-trapping-math $<$<CONFIG:Release>:${level}>
                         $<$<BOOL:${WINDROW_WERROR}>:-Werror>)
  if(WINDROW_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${WINDROW_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${WINDROW_SANITIZE})
    if(arg_LIGHT AND WINDROW_SANITIZE MATCHES "undefined")
      # Checks of each pointer double the time of compiling; outside the library AddressSanitizer's own will do.
      target_compile_options(${target} PRIVATE -fno-sanitize=null,alignment,vptr,object-size)
    endif()
  endif()
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
