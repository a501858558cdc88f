# What `cmake --install` lays down, for find_package(windrow 0.1 COMPONENTS fluid coupling vdb vulkan coupling_vulkan c):
#
#   include/windrow/fluid/...        public headers: consumers write #include <windrow/fluid/wind.h>
#   include/windrow/shaders/numerics the formulas that these include
#   lib/libwindrow_*                 one library and one export set a component; vulkan has two libraries
#   include/windrow/windrow.h        with the component c: the C interface, whose parts are in c_api/
#   lib/cmake/windrow/               the package files
#   lib/pkgconfig/windrow-*.pc       one a component, for builds without CMake
#   share/windrow/shaders/numerics   the formulas as text, for GLSL
#   share/windrow/shaders/coupling   what a host's shaders include
#   share/windrow/scenes             scenes with what they name, and their schema for editors (install_scenes.cmake)
#   share/doc/windrow                README, CHANGELOG, the pages of docs/ with their pictures, LICENSE, NOTICE
#   bin/windrow, bin/windrow-draw    the programs, where they are built, with their page of the manual and completion for bash and zsh
option(WINDROW_INSTALL "Make install rules" ${PROJECT_IS_TOP_LEVEL})
if(NOT WINDROW_INSTALL)
  return()
endif()

include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/windrow)
set(header_dir ${CMAKE_INSTALL_INCLUDEDIR}/windrow)
set(shader_dir ${CMAKE_INSTALL_DATADIR}/windrow/shaders)

# windrow_install_headers(FOLDER): the public headers that lie in it.
function(windrow_install_headers folder)
  set(headers ${WINDROW_PUBLIC_HEADERS})
  list(FILTER headers INCLUDE REGEX "^${folder}/[^/]*$")
  list(REMOVE_ITEM headers c_api/windrow.h) # include/windrow/windrow.h
  list(TRANSFORM headers PREPEND ${PROJECT_SOURCE_DIR}/)
  install(FILES ${headers} DESTINATION ${header_dir}/${folder})
endfunction()

windrow_install_headers(fluid)
windrow_install_headers(fluid/shapes)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/shaders/numerics DESTINATION ${header_dir}/shaders FILES_MATCHING PATTERN "*.glsl")
install(TARGETS windrow_fluid EXPORT windrow_fluid)
set(components fluid)

if(TARGET windrow_coupling)
  windrow_install_headers(coupling)
  install(TARGETS windrow_coupling EXPORT windrow_coupling)
  set_target_properties(windrow_coupling PROPERTIES INSTALL_RPATH "$ORIGIN") # a shared one finds windrow::fluid beside it
  list(APPEND components coupling)
endif()

if(TARGET windrow_vdb)
  windrow_install_headers(fluid/vdb)
  install(TARGETS windrow_vdb EXPORT windrow_vdb)
  set_target_properties(windrow_vdb PROPERTIES INSTALL_RPATH "$ORIGIN") # a shared one finds windrow::fluid beside it
  get_target_property(vdb_library_type windrow_vdb TYPE)
  list(APPEND components vdb)
endif()

if(TARGET windrow_vulkan)
  windrow_install_headers(fluid/vulkan)
  install(TARGETS windrow_vulkan windrow_vulkan_loader EXPORT windrow_vulkan)
  set_target_properties(windrow_vulkan windrow_vulkan_loader PROPERTIES INSTALL_RPATH "$ORIGIN")
  list(APPEND components vulkan)
endif()

if(TARGET windrow_coupling_vulkan)
  windrow_install_headers(coupling/vulkan)
  install(TARGETS windrow_coupling_vulkan EXPORT windrow_coupling_vulkan)
  set_target_properties(windrow_coupling_vulkan PROPERTIES INSTALL_RPATH "$ORIGIN")
  list(APPEND components coupling_vulkan)
endif()

if(TARGET windrow_c)
  windrow_install_headers(c_api)
  install(FILES ${PROJECT_SOURCE_DIR}/c_api/windrow.h DESTINATION ${header_dir})
  install(TARGETS windrow_c EXPORT windrow_c)
  set_target_properties(windrow_c PROPERTIES INSTALL_RPATH "$ORIGIN") # shared libraries of a BUILD_SHARED_LIBS build lie beside it
  if(TARGET windrow_openvdb) # opened by the first call that writes a VDB file
    install(TARGETS windrow_openvdb LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
    set_target_properties(windrow_openvdb PROPERTIES INSTALL_RPATH "$ORIGIN")
  endif()
  list(APPEND components c)
endif()

# windrow_pkg_config(COMPONENT [LIBRARY...] [NEEDS COMPONENT...] [SYSTEM FLAG...]): windrow-COMPONENT.pc, found beside the
# libraries wherever the whole is moved. FLAGs are what a static archive leaves to its consumers.
function(windrow_pkg_config component)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "NEEDS;SYSTEM")
  list(TRANSFORM arg_UNPARSED_ARGUMENTS PREPEND -l OUTPUT_VARIABLE libraries)
  list(TRANSFORM arg_NEEDS PREPEND windrow- OUTPUT_VARIABLE needs)
  set(flags "-I\${includedir}")
  if(NOT BUILD_SHARED_LIBS)
    list(APPEND flags -DWINDROW_STATIC)
    list(APPEND libraries ${arg_SYSTEM})
  endif()
  foreach(list IN ITEMS flags libraries needs)
    list(JOIN ${list} " " ${list})
  endforeach()
  file(RELATIVE_PATH up ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/windrow-${component}.pc @ONLY CONTENT
"prefix=\${pcfiledir}/@up@
includedir=\${prefix}/@CMAKE_INSTALL_INCLUDEDIR@
libdir=\${prefix}/@CMAKE_INSTALL_LIBDIR@

Name: windrow-@component@
Description: @PROJECT_DESCRIPTION@
Version: @PROJECT_VERSION@
Requires: @needs@
Cflags: @flags@
Libs: -L\${libdir} @libraries@
")
  install(FILES ${PROJECT_BINARY_DIR}/windrow-${component}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

foreach(component IN LISTS components)
  install(EXPORT windrow_${component} NAMESPACE windrow:: FILE windrow-${component}.cmake DESTINATION ${package_dir})
endforeach()
windrow_pkg_config(fluid windrow_fluid SYSTEM -pthread)
if(coupling IN_LIST components)
  windrow_pkg_config(coupling windrow_coupling NEEDS fluid)
endif()
if(vdb IN_LIST components)
  windrow_pkg_config(vdb windrow_vdb NEEDS fluid SYSTEM -lopenvdb -ltbb -lboost_iostreams -lImath)
endif()
if(vulkan IN_LIST components)
  windrow_pkg_config(vulkan windrow_vulkan_loader windrow_vulkan NEEDS fluid SYSTEM -ldl)
endif()
if(coupling_vulkan IN_LIST components)
  windrow_pkg_config(coupling_vulkan windrow_coupling_vulkan NEEDS coupling vulkan)
endif()
if(c IN_LIST components)
  windrow_pkg_config(c windrow)
endif()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/shaders/numerics ${PROJECT_SOURCE_DIR}/shaders/coupling DESTINATION ${shader_dir}
        FILES_MATCHING PATTERN "*.glsl" PATTERN "*.hlsl")

if(TARGET windrow_draw)
  install(TARGETS windrow_draw)
  list(APPEND programs windrow_draw)
endif()
if(TARGET windrow_cli)
  install(TARGETS windrow_cli)
  list(APPEND programs windrow_cli)
  install(FILES ${PROJECT_SOURCE_DIR}/docs/windrow.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  set(completion ${PROJECT_SOURCE_DIR}/tools/completion)
  install(FILES ${completion}/windrow.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME windrow)
  install(FILES ${completion}/windrow.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions RENAME _windrow)
endif()
if(BUILD_SHARED_LIBS AND programs)
  # A program finds its libraries beside it, wherever the whole is moved.
  file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(${programs} PROPERTIES INSTALL_RPATH "$ORIGIN/${to_libraries}")
endif()

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/windrowConfig.cmake.in ${PROJECT_BINARY_DIR}/windrowConfig.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS shader_dir)
# Until 1.0 a new minor version may change the API.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/windrowConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/windrowConfig.cmake ${PROJECT_BINARY_DIR}/windrowConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/WindrowOpenVDB.cmake ${CMAKE_CURRENT_LIST_DIR}/WindrowVulkanHeaders.cmake
        DESTINATION ${package_dir})
foreach(file IN ITEMS LICENSE NOTICE README.md CHANGELOG.md)
  install(FILES ${PROJECT_SOURCE_DIR}/${file} DESTINATION ${CMAKE_INSTALL_DOCDIR})
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(CODE "set(FROM \"${PROJECT_SOURCE_DIR}/examples/scenes\")
set(TO \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/windrow/scenes\")")
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/install_scenes.cmake)
