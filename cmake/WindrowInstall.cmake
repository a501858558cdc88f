# What `cmake --install` lays down, for find_package(windrow 0.1 COMPONENTS fluid coupling vdb vulkan coupling_vulkan
# vegetation):
#
#   include/windrow/fluid/...        public headers: consumers write #include "fluid/wind.h", as inside the project
#   lib/libwindrow_*                 one library and one export set a component; vulkan has two libraries
#   lib/cmake/windrow/               the package files
#   share/windrow/shaders/numerics   the formulas as text, for GLSL
#   share/windrow/shaders/coupling   what a host's shaders include
#   share/windrow/vegetation/shaders   with the component vegetation: what a host includes that draws grass itself, and the
#                                    formulas of the headers
#   bin/windrow, bin/windrow-draw    the programs, where they are built
option(WINDROW_INSTALL "Make install rules" ${PROJECT_IS_TOP_LEVEL})
if(NOT WINDROW_INSTALL)
  return()
endif()

include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/windrow)
set(header_dir ${CMAKE_INSTALL_INCLUDEDIR}/windrow)
set(shader_dir ${CMAKE_INSTALL_DATADIR}/windrow/shaders)

file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/public_headers.txt public_headers REGEX "^[^#]")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/public_headers.txt)
# windrow_install_headers(FOLDER): the public headers that lie in it.
function(windrow_install_headers folder)
  set(headers ${public_headers})
  list(FILTER headers INCLUDE REGEX "^${folder}/[^/]*$")
  list(TRANSFORM headers PREPEND ${PROJECT_SOURCE_DIR}/)
  install(FILES ${headers} DESTINATION ${header_dir}/${folder})
endfunction()

windrow_install_headers(fluid)
windrow_install_headers(fluid/shapes)
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

if(TARGET windrow_vegetation)
  foreach(folder IN ITEMS pictures vegetation/fur vegetation/grass vegetation/render vegetation/trees vegetation/vulkan)
    windrow_install_headers(${folder})
  endforeach()
  install(TARGETS windrow_vegetation EXPORT windrow_vegetation)
  install(TARGETS windrow_draw)
  list(APPEND programs windrow_draw)
  set(vegetation_shaders ${PROJECT_SOURCE_DIR}/vegetation/shaders)
  install(FILES ${vegetation_shaders}/grass/grass_blade.glsl DESTINATION ${CMAKE_INSTALL_DATADIR}/windrow/vegetation/shaders/grass)
  install(DIRECTORY ${vegetation_shaders}/numerics DESTINATION ${CMAKE_INSTALL_DATADIR}/windrow/vegetation/shaders
          FILES_MATCHING PATTERN "*.glsl")
  list(APPEND components vegetation)
endif()

foreach(component IN LISTS components)
  install(EXPORT windrow_${component} NAMESPACE windrow:: FILE windrow-${component}.cmake DESTINATION ${package_dir})
endforeach()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/shaders/numerics ${PROJECT_SOURCE_DIR}/shaders/coupling DESTINATION ${shader_dir}
        FILES_MATCHING PATTERN "*.glsl" PATTERN "*.hlsl")

if(TARGET windrow_cli)
  install(TARGETS windrow_cli)
  list(APPEND programs windrow_cli)
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
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
