# How every target of the project is compiled.
#
# -ffp-contract=off: a product and a sum stay two roundings unless a kernel asks for a fused one by name, so that one
# source gives one result for each SIMD level whatever the compiler. No fast-math anywhere.
function(windrow_compile target)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/windrow>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                         -ffp-contract=off -fno-math-errno -fno-trapping-math $<$<CONFIG:Release>:-O3>
                         $<$<BOOL:${WINDROW_WERROR}>:-Werror>)
  if(WINDROW_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${WINDROW_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${WINDROW_SANITIZE})
  endif()
endfunction()
