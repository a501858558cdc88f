# windrow_import_library(TARGET): what a host that is compiled by MSVC links of a DLL that MinGW-w64 made, beside the DLL: NAME.lib and
# the list of its names, NAME.def. MSVC cannot compile the solver, which is written with vector types of GCC and Clang.
#
# The runtime of GCC is within the DLL, which needs nothing but Windows. Does nothing where TARGET is no DLL.
function(windrow_import_library target)
  get_target_property(type ${target} TYPE)
  if(NOT MINGW OR NOT type STREQUAL "SHARED_LIBRARY")
    return()
  endif()
  find_program(WINDROW_DLLTOOL NAMES llvm-dlltool x86_64-w64-mingw32-dlltool dlltool NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  target_link_options(${target} PRIVATE -static LINKER:--output-def=$<TARGET_FILE_DIR:${target}>/${target}.def)
  set(library ${PROJECT_BINARY_DIR}/${target}.lib)
  add_custom_command(OUTPUT ${library}
    COMMAND ${WINDROW_DLLTOOL} -m i386:x86-64 -d $<TARGET_FILE_DIR:${target}>/${target}.def -D $<TARGET_FILE_NAME:${target}> -l ${library}
    DEPENDS ${target} COMMENT "Making ${target}.lib for MSVC" VERBATIM)
  add_custom_target(${target}_import_library ALL DEPENDS ${library})
  if(WINDROW_INSTALL)
    install(FILES ${library} $<TARGET_FILE_DIR:${target}>/${target}.def DESTINATION ${CMAKE_INSTALL_LIBDIR})
  endif()
endfunction()

foreach(target IN ITEMS windrow windrow_c windrow_fluid windrow_coupling)
  if(TARGET ${target})
    windrow_import_library(${target})
  endif()
endforeach()
