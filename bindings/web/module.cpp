// The module of WebAssembly: the linker takes the functions of exports.txt from the library, and a program needs one file of its own.
#include "c_api/windrow.h"

#ifndef __EMSCRIPTEN__
#error "this file is for WebAssembly"
#endif
