// What g++'s static libraries take from glibc 2.35 and 2.36, made of what older ones have, so that what is portable (windrow_portable of
// WindrowCompile.cmake) runs with glibc 2.34. Hidden, so that nothing else in the process uses these.
#include <cstdint>
#include <cstdlib>
#include <dlfcn.h>
#include <link.h>
#include <unistd.h>

#pragma GCC visibility push(hidden)

// For std::random_device.
extern "C" std::uint32_t arc4random() noexcept {
    std::uint32_t bits = 0;
    if (::getentropy(&bits, sizeof bits) != 0)
        std::abort(); // as glibc's own does without a source
    return bits;
}

// In place of the handler that prints the type of an exception that nothing caught: its reader of C++ names takes 47 kB.
namespace __gnu_cxx {
void __verbose_terminate_handler() {
    constexpr char k_words[] = "windrow: an exception was not caught: this is a fault of windrow, report it.\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, k_words, sizeof k_words - 1);
    std::abort();
}
} // namespace __gnu_cxx

namespace {

struct Search {
    std::uintptr_t address;
    dl_find_object* found;
};

int look_at(dl_phdr_info* object, std::size_t, void* data) {
    const Search& search = *static_cast<const Search*>(data);
    bool holds = false;
    std::uintptr_t table = 0, low = UINTPTR_MAX, high = 0;
    for (int n = 0; n < object->dlpi_phnum; ++n) {
        const ElfW(Phdr)& part = object->dlpi_phdr[n];
        const std::uintptr_t begin = object->dlpi_addr + part.p_vaddr, end = begin + part.p_memsz;
        if (part.p_type == PT_GNU_EH_FRAME)
            table = begin;
        if (part.p_type != PT_LOAD)
            continue;
        holds = holds || (search.address >= begin && search.address < end);
        low = begin < low ? begin : low;
        high = end > high ? end : high;
    }
    if (!holds || table == 0)
        return 0; // go on
    *search.found = {};
    search.found->dlfo_map_start = reinterpret_cast<void*>(low);
    search.found->dlfo_map_end = reinterpret_cast<void*>(high);
    search.found->dlfo_eh_frame = reinterpret_cast<void*>(table);
    return 1;
}

} // namespace

// For the unwinder: the table of the object that holds an address. Exceptions are rare, so that a search is fast
// enough.
extern "C" int _dl_find_object(void* address, dl_find_object* found) noexcept {
    Search search{reinterpret_cast<std::uintptr_t>(address), found};
    return ::dl_iterate_phdr(&look_at, &search) == 1 ? 0 : -1;
}

#pragma GCC visibility pop
