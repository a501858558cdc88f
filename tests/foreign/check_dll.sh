#!/usr/bin/env bash
# check_dll.sh FOLDER: builds the C interface as a DLL by MinGW-w64 in FOLDER, links a program with its import library as MSVC does
# (clang for MSVC's ABI, lld-link), and runs it by Wine. The DLL needs nothing but Windows.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$1
mkdir -p "$(dirname "$folder")"
cmake -S "$root" -B "$folder" -G Ninja --toolchain "$root/cmake/toolchains/windows.cmake" -DCMAKE_BUILD_TYPE=Release \
    -DWINDROW_VDB=OFF -DWINDROW_VULKAN=OFF -DWINDROW_IMAGES=OFF -DWINDROW_CLI=OFF -DWINDROW_VEGETATION=OFF -DWINDROW_EXAMPLES=OFF \
    -DWINDROW_TESTS=OFF >"$folder.log"
cmake --build "$folder" --parallel "${WINDROW_JOBS:-$(nproc)}" >>"$folder.log" || { tail -30 "$folder.log"; exit 1; }
cd "$folder"
needed=$(x86_64-w64-mingw32-objdump -p libwindrow.dll | sed -n 's/.*DLL Name: //p' | grep -viE '^(kernel32|msvcrt|user32|advapi32|bcrypt)\.dll$' || true)
[[ -z $needed ]] || { echo "libwindrow.dll needs $needed" && exit 1; }
names=$(sed -n 's/^ *\([A-Za-z_][A-Za-z0-9_]*\) @.*/\1/p' windrow_c.def | grep -vE '^(own_)?windrow_' || true) # own_: before the host's axes
[[ -z $names ]] || { echo "libwindrow.dll exports $names" && exit 1; }
clang --target=x86_64-pc-windows-msvc -O1 -ffreestanding -Iinclude -c "$root/tests/foreign/import_check.c" -o import_check.obj
lld-link /nologo /subsystem:console /entry:start /nodefaultlib /out:import_check.exe import_check.obj windrow_c.lib
wine=$(sed -n 's/^WINDROW_WINE:FILEPATH=//p' CMakeCache.txt)
WINEPREFIX=$PWD/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml,winemenubuilder.exe=' "$wine" import_check.exe
echo "A program for MSVC's ABI calls libwindrow.dll through windrow_c.lib: $(grep -c ' @' windrow_c.def) functions."
