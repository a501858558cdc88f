# windrow_shaders(TARGET FILE...): compiles GLSL to SPIR-V while building, checks it, and embeds it: `advect.comp` becomes
#
#   #include "shader_words/advect.h"
#   windrow::vulkan::shader_words::advect   // std::uint32_t[]
#
# Shaders of other stages keep their stage in the name, since they come in pairs: `grass.vert` becomes grass_vert. HLSL names its
# language behind the stage: `seeds.vert.hlsl` becomes seeds_vert_hlsl, `sample.comp.hlsl` sample_hlsl.
# A shader is built again when it or anything that it includes has changed, and it alone. Includes are found beside the file and
# in shaders/, or are named from the project's root.
set(WINDROW_SHADER_OPTIONS "" CACHE STRING "More options for glslangValidator, such as -Os")
mark_as_advanced(WINDROW_SHADER_OPTIONS)

# Sets WINDROW_GLSLANG and WINDROW_SPIRV_VAL, or stops with what to install.
macro(windrow_find_shader_tools)
  find_program(WINDROW_GLSLANG glslangValidator HINTS $ENV{VULKAN_SDK}/bin)
  find_program(WINDROW_SPIRV_VAL spirv-val HINTS $ENV{VULKAN_SDK}/bin)
  if(NOT WINDROW_GLSLANG OR NOT WINDROW_SPIRV_VAL)
    message(FATAL_ERROR "glslangValidator or spirv-val was not found: install glslang-tools and spirv-tools, or configure with -DWINDROW_VULKAN=OFF.")
  endif()
endmacro()

function(windrow_shaders target)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders)
  set(script ${PROJECT_SOURCE_DIR}/cmake/embed_shader.cmake)
  foreach(file IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    cmake_path(GET file STEM name)
    cmake_path(GET file EXTENSION stage)
    string(REPLACE ".comp" "" stage ${stage})
    string(REPLACE "." "_" stage "${stage}")
    string(APPEND name "${stage}")
    set(header ${folder}/shader_words/${name}.h)
    add_custom_command(OUTPUT ${header}
      COMMAND ${CMAKE_COMMAND} -D GLSLANG=${WINDROW_GLSLANG} -D SPIRV_VAL=${WINDROW_SPIRV_VAL} -D SOURCE=${file} -D NAME=${name}
              -D HEADER=${header} -D ROOT=${PROJECT_SOURCE_DIR} "-DOPTIONS=${WINDROW_SHADER_OPTIONS}" -P ${script}
      DEPENDS ${file} ${script}
      DEPFILE ${header}.d
      COMMENT "Compiling shader ${name}" VERBATIM)
    target_sources(${target} PRIVATE ${header})
  endforeach()
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
