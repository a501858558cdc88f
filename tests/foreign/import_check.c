/* Calls a DLL of MinGW-w64 as a host of MSVC does: compiled for its ABI, linked through the import library, without a C library.
   The names are those of C++; the C library's are plain. */
extern _Bool _ZN7windrow4runsENS_4SimdE(unsigned char level);
extern const char* _ZN7windrow7name_ofENS_4SimdE(unsigned char level);

int start(void) {
    if (!_ZN7windrow4runsENS_4SimdE(1))
        return 1;
    const char* const found = _ZN7windrow7name_ofENS_4SimdE(1);
    for (int n = 0; n < 9; ++n)
        if (found[n] != "baseline"[n])
            return 2;
    return 0;
}
