/* Version of the library, for the preprocessor of C and C++. CMake reads the string. */
#ifndef WINDROW_FLUID_VERSION_H
#define WINDROW_FLUID_VERSION_H

#define WINDROW_VERSION_MAJOR 0
#define WINDROW_VERSION_MINOR 1
#define WINDROW_VERSION_PATCH 0
/* 10000 major + 100 minor + patch: #if WINDROW_VERSION >= 100 asks for 0.1.0. */
#define WINDROW_VERSION (WINDROW_VERSION_MAJOR * 10000 + WINDROW_VERSION_MINOR * 100 + WINDROW_VERSION_PATCH)
#define WINDROW_VERSION_STRING "0.1.0"

#endif
