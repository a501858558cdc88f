# cmake -D GLSLANG= -D SPIRV_VAL= -D SOURCE=x.comp -D NAME=x -D HEADER=x.h -D ROOT=folder -D OPTIONS= -P embed_shader.cmake
#
# Compiles one shader, checks it, and writes its words as a C++ header, with the list of what it was made from in HEADER.d.
cmake_path(GET HEADER PARENT_PATH folder)
file(MAKE_DIRECTORY ${folder})
set(binary ${HEADER}.spv)
separate_arguments(options UNIX_COMMAND "${OPTIONS}")

# glslang's HLSL declares storage buffers in a way that SPIR-V 1.4, and so Vulkan 1.2, no longer has.
if(SOURCE MATCHES "[.]hlsl$")
  set(language -D -e main)
  set(target vulkan1.1)
else()
  set(language "")
  set(target vulkan1.2)
endif()

# -g0: no names and no source in what users get.
execute_process(COMMAND ${GLSLANG} --quiet -V -g0 ${language} --target-env ${target} ${options} -I${ROOT}/shaders -I${ROOT} --depfile ${HEADER}.d.raw -o ${binary} ${SOURCE}
                RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${SOURCE} does not compile")
endif()
execute_process(COMMAND ${SPIRV_VAL} --target-env ${target} ${binary} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${SOURCE} compiles to SPIR-V that is not valid")
endif()

# The compiler names the .spv as what depends on the files; the build knows the header.
file(READ ${HEADER}.d.raw dependencies)
string(FIND "${dependencies}" ".spv:" colon)
math(EXPR colon "${colon} + 5")
string(SUBSTRING "${dependencies}" ${colon} -1 dependencies)
file(WRITE ${HEADER}.d "${HEADER}:${dependencies}")

# Words of four bytes, the lowest first, six a line.
file(READ ${binary} bytes HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${bytes}")
string(REGEX REPLACE "(...........)(...........)(...........)(...........)(...........)(...........)" "\\1\\2\\3\\4\\5\\6\n" words "${words}")
file(WRITE ${HEADER} "#pragma once\n#include <cstdint>\nnamespace windrow::vulkan::shader_words {\n"
     "inline constexpr std::uint32_t ${NAME}[] = {\n${words}};\n}\n")
