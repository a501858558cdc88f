// An engine that opens the plug-in at run time and knows nothing of wind.
#include <cstdio>
#include <dlfcn.h>

int main(int count, char** arguments) {
    void* const module = count == 2 ? dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL) : nullptr;
    if (!module)
        return std::fprintf(stderr, "%s\n", count == 2 ? dlerror() : "usage: engine PLUGIN"), 1;
    auto* const wind_at_leaf = reinterpret_cast<float (*)()>(dlsym(module, "wind_at_leaf"));
    return wind_at_leaf && wind_at_leaf() > 2.9f ? 0 : 1;
}
