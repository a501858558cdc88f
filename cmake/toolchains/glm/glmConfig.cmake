# GLM's headers of this machine for another one's compiler: they are the same everywhere. A folder of their own, since all other
# headers of /usr/include would stand before the compiler's.
find_path(WINDROW_HOST_GLM glm/glm.hpp PATHS /usr/include /usr/local/include NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
set(glm_headers ${CMAKE_BINARY_DIR}/host_headers)
file(MAKE_DIRECTORY ${glm_headers})
file(CREATE_LINK ${WINDROW_HOST_GLM}/glm ${glm_headers}/glm SYMBOLIC)
if(NOT TARGET glm::glm)
  add_library(glm::glm INTERFACE IMPORTED)
  target_include_directories(glm::glm SYSTEM INTERFACE ${glm_headers})
endif()
