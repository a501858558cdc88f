// The files that a scene names, in memory, for the module of the page: files[name] = bytes, in one folder, "/".
//
// They take the place of Emscripten's file system, which is larger than the rest of its loader. What the library's reader of files
// (fluid/files) calls is here: an open file is a number, and its place in `opened`.
mergeInto(LibraryManager.library, {
    $files: {},
    $opened: {},
    // [name, bytes] of a path, bytes null for the folder; else undefined.
    $found_file__deps: ["$files"],
    $found_file: function(path) {
        var name = "/" + UTF8ToString(path).split("/").filter(function(part) { return part && part !== "."; }).join("/");
        return name === "/" ? [name, null] : name in files ? [name, files[name]] : undefined;
    },
    $write_stat__deps: ["$files"],
    $write_stat: function(found, at) {
        if (!found) return -{{{ cDefine('ENOENT') }}};
        var number = 1 + Object.keys(files).indexOf(found[0]);
        HEAPU8.fill(0, at, at + {{{ C_STRUCTS.stat.__size__ }}});
        {{{ makeSetValue('at', C_STRUCTS.stat.st_mode, 'found[1] ? 0x81b6 : 0x41ff', 'i32') }}};
        {{{ makeSetValue('at', C_STRUCTS.stat.st_nlink, '1', 'i32') }}};
        {{{ makeSetValue('at', C_STRUCTS.stat.st_size, 'found[1] ? found[1].length : 0', 'i32') }}};
        {{{ makeSetValue('at', C_STRUCTS.stat.st_ino, 'number', 'i32') }}};
        return 0;
    },
    __syscall_open__deps: ["$opened", "$found_file"],
    __syscall_open: function(path) {
        var found = found_file(path), number = 3;
        if (!found) return -{{{ cDefine('ENOENT') }}};
        while (opened[number]) ++number;
        opened[number] = {found: found, place: 0};
        return number;
    },
    __syscall_stat64__deps: ["$found_file", "$write_stat"],
    __syscall_stat64: function(path, at) {
        return write_stat(found_file(path), at);
    },
    __syscall_lstat64__deps: ["$found_file", "$write_stat"],
    __syscall_lstat64: function(path, at) {
        return write_stat(found_file(path), at);
    },
    __syscall_fstatat64__deps: ["$found_file", "$write_stat"],
    __syscall_fstatat64: function(folder, path, at) {
        return write_stat(found_file(path), at);
    },
    __syscall_fstat64__deps: ["$opened", "$write_stat"],
    __syscall_fstat64: function(number, at) {
        return opened[number] ? write_stat(opened[number].found, at) : -{{{ cDefine('EBADF') }}};
    },
    __syscall_readlink: function() {
        return -{{{ cDefine('EINVAL') }}}; // nothing is a link
    },
    __syscall_getcwd: function(at) {
        stringToUTF8("/", at, 2);
        return at;
    },
    fd_read__deps: ["$opened"],
    fd_read: function(number, parts, count, read) {
        var file = opened[number], total = 0;
        if (!file) return {{{ cDefine('EBADF') }}};
        for (var n = 0; n < count; ++n) {
            var [to, most] = [HEAPU32[(parts >> 2) + 2 * n], HEAPU32[(parts >> 2) + 2 * n + 1]];
            var bytes = file.found[1].subarray(file.place, file.place + most);
            HEAPU8.set(bytes, to);
            file.place += bytes.length;
            total += bytes.length;
        }
        HEAPU32[read >> 2] = total;
        return 0;
    },
    fd_close__deps: ["$opened"],
    fd_close: function(number) {
        delete opened[number];
        return 0;
    },
});
