# windrow_find_openvdb([QUIET] [REQUIRED]): defines OpenVDB::openvdb in the calling directory and sets OpenVDB_FOUND.
#
# Debian ships OpenVDB's find module outside CMake's search path, and the module sets BUILD_SHARED_LIBS and more in its
# caller's scope, which would silently turn the libraries that follow into shared ones. Inside a function that stays here.
function(windrow_find_openvdb)
  if(NOT TARGET OpenVDB::openvdb)
    list(APPEND CMAKE_MODULE_PATH
         /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB /usr/lib64/cmake/OpenVDB /usr/local/lib/cmake/OpenVDB)
    set(CMAKE_MESSAGE_LOG_LEVEL WARNING) # Debian's Imath tells at length that its Python library is not installed
    find_package(OpenVDB ${ARGN})
  endif()
  if(TARGET OpenVDB::openvdb)
    set(OpenVDB_FOUND TRUE PARENT_SCOPE)
  else()
    set(OpenVDB_FOUND FALSE PARENT_SCOPE)
  endif()
endfunction()
