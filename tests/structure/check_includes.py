#!/usr/bin/env python3
"""check_includes.py ROOT: who may include whom, who makes Vulkan objects, and how long a file may be.

Prints each breach as `file:line: sentence` and exits with 1 if there is one. Rules are about includes as they are written:
a rule that holds for each file holds for the whole tree.
"""
import fnmatch
import pathlib
import re
import sys

LONGEST_FILE = 500
SENTENCES = "tests/structure/messages.txt"  # a list of all messages, made by check_messages.py
FOLDERS = ("gpu", "fluid", "coupling", "c_api", "shaders", "scene", "pictures", "vegetation", "examples", "cases", "cli", "tests",
           "tools", "cmake")
SOURCES = (".h", ".cpp", ".inl", ".glsl", ".comp", ".vert", ".frag", ".hlsl", ".py", ".cmake", ".txt")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')

VULKAN = ("vulkan/*", "vulkan.h", "vulkan_core.h", "volk.h", "*/volk.h")
OPENVDB = ("openvdb/*", "nanovdb/*")
OPENIMAGEIO = ("OpenImageIO/*",)
JSON = ("nlohmann/*",)
TINYGLTF = ("tiny_gltf.h",)
FOLDERS_OF_OURS = tuple(f"{folder}/*" for folder in FOLDERS)
# Production code: target folders that none of it knows, `tests` first of all. Examples: see below.
ABOVE = {
    "gpu": ("coupling", "c_api", "scene", "pictures", "vegetation", "cases", "cli", "examples", "tests"),
    "fluid": ("coupling", "c_api", "scene", "pictures", "vegetation", "cases", "cli", "examples", "tests"),
    "coupling": ("c_api", "scene", "pictures", "vegetation", "cases", "cli", "examples", "tests"),
    "c_api": ("pictures", "vegetation", "cases", "cli", "examples", "tests"),
    "scene": ("c_api", "pictures", "vegetation", "cases", "cli", "examples", "tests"),
    "pictures": ("coupling", "c_api", "scene", "vegetation", "cases", "cli", "examples", "tests"),
    "vegetation": ("c_api", "cases", "cli", "examples", "tests"),
    "shaders": ("tests",),
    "cases": ("scene", "pictures", "cli", "examples", "tests"),
    "cli": ("examples", "tests"),
}
# Rooms of fluid/: what each may include of the others, as patterns. fluid/ itself has the headers that are installed and what
# implements them; of cpu/ it opens the door in wind*.cpp and wind_state.h alone.
NEUTRAL = ("fluid/core/*", "fluid/grid/*", "fluid/solids/*")
ROOMS = {
    "core": ("fluid/grid/*", "fluid/solids/*"),
    "grid": (),
    "solids": ("fluid/grid/*", "fluid/core/message.h", "fluid/core/bytes.h", "fluid/core/numerics.h"),
    "files": ("fluid/core/message.h", "fluid/core/validation.h", "fluid/core/bytes.h"),
    "cpu": NEUTRAL,
    "vulkan": NEUTRAL,
    "vdb": ("fluid/core/*", "fluid/files/*"),
    "shapes": ("fluid/core/*", "fluid/solids/*"),
}
OPENS_CPU = ("fluid/wind*.cpp", "fluid/wind_state.h", "cases/reference/*", "tests/*")
# What gpu/ includes of fluid/, besides installed headers; who uses gpu/, and who looks into the wind of fluid/vulkan.
BELOW_GPU = ("fluid/core/message.h",)
USES_GPU = ("gpu/*", "fluid/vulkan/*", "cli/*", "coupling/vulkan/*", "vegetation/*", "tests/*")
SEES_DEVICE_WIND = ("cli/bench/vulkan/*", "tests/*")
# Of vegetation: what belongs to windrow_vegetation_files and to windrow-draw, and what tests and measures. All else is the library.
FILES_AND_PROGRAM = ("files", "program", "view")
TESTS_AND_BENCH = ("tests", "bench")
BESIDE_RENDERER = tuple(f"vegetation/{folder}/*" for folder in FILES_AND_PROGRAM + TESTS_AND_BENCH)
VIEW = ("cli/view_command.cpp", "vegetation/view/view.h") # the one way from the command to the window
MAKES_OBJECTS = re.compile(r"\bvk(?:Create|Allocate)\w*")
# The layers that make Vulkan objects, tests of them, and a host of two queues.
MAKERS = ("gpu/*", "vegetation/vulkan/*", "vegetation/view/*", "cli/device_report/*", "vegetation/bench/counted_memory.*", "examples/queue_lane.h",
          "tests/parity/*", "tests/plants/*")


def matches(name, patterns):
    return any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)


def includes(text):
    """Line number and name of each include."""
    for number, line in enumerate(text.splitlines(), 1):
        found = INCLUDE.match(line)
        if found:
            yield number, found.group(2)


def within_root(root, file, name):
    """The included file's path from the root, where it is one of ours; else None."""
    for folder in (file.parent, root, root / "shaders"):
        path = (folder / name.removeprefix("windrow/")).resolve()
        if path.is_file() and path.is_relative_to(root):
            return path.relative_to(root).as_posix()
    return None


def folder_of(root, here):
    """Where the includes of a public header begin: windrow/windrow.h is installed a folder above the others of c_api."""
    return root if here == "c_api/windrow.h" else (root / here).parent


def breaches_of_include(root, file, name, public):
    """Why this file may not include this name: sentences."""
    here = file.relative_to(root).as_posix()
    folders = here.split("/")[:-1]
    top = folders[0]
    target = within_root(root, file, name)
    # A file that does not exist (yet) is judged by its name.
    users_name = name.startswith("windrow/")
    name = name.removeprefix("windrow/")
    target_folders = (target or name).split("/")[:-1]
    target_top = target_folders[0] if target_folders else None

    if folders[:2] == ["shaders", "numerics"] and target_folders[:2] != ["shaders", "numerics"]:
        yield "shaders/numerics is text for two languages and includes nothing outside itself"
    if folders[:3] == ["vegetation", "shaders", "numerics"] and (
            target_folders[:2] != ["shaders", "numerics"] and target_folders[:3] != ["vegetation", "shaders", "numerics"]):
        yield "vegetation/shaders/numerics is text for two languages and includes only shaders/numerics beside itself"
    tested = top == "vegetation" and len(folders) > 1 and folders[1] in TESTS_AND_BENCH
    if target_top in ABOVE.get(top, ()) and not (tested and target_top == "tests"):
        yield f"{top} is a lower layer and does not know {target_top}"
    elif top not in ("vegetation", "tests", "examples") and target_top == "vegetation" and not (
            folders[:2] == ["cli", "device_report"] and not matches(target or name, BESIDE_RENDERER)) and (here, target) != VIEW:
        yield f"{top} does not know vegetation: it is built without it; the report of a device draws with its renderer alone"
    if top == "vegetation" and not tested and (len(folders) == 1 or folders[1] not in FILES_AND_PROGRAM):
        if target_top == "scene" or matches(name, JSON + TINYGLTF + OPENIMAGEIO) or target == "pictures/picture_files.h":
            yield "the renderer is a library without files: no scene, JSON, mesh or picture files"
        if target_top == "vegetation" and len(target_folders) > 1 and target_folders[1] in FILES_AND_PROGRAM + TESTS_AND_BENCH:
            yield f"the renderer does not know vegetation/{target_folders[1]}"
    if matches(name, VULKAN) and "vulkan" not in folders and top not in ("gpu", "vegetation", "examples", "tests"):
        yield "Vulkan's headers belong in gpu, in folders named vulkan, in examples and in tests"
    if matches(name, OPENVDB) and top not in ("cases", "tests") and not (folders == ["fluid", "vdb"] and file.suffix == ".cpp"):
        yield "OpenVDB's headers belong in one .cpp of fluid/vdb, in cases and in tests"
    if matches(name, OPENIMAGEIO) and top not in ("pictures", "vegetation", "tests"):
        yield "OpenImageIO's headers belong in pictures, vegetation/files and tests: it brings 261 libraries"
    renderer = target_top == "vegetation" and not users_name and not matches(target or name, BESIDE_RENDERER)
    if top == "examples" and target_top in FOLDERS and target_top not in ("examples", "shaders") and target not in public and not renderer:
        yield 'examples show what a user can do: installed headers (cmake/public_headers.txt), and the renderer as "vegetation/..."'
    if here in public and target_top in ("fluid", "coupling") and target not in public and (not target or not target.endswith(".glsl")):
        yield "a public header may only include public ones (cmake/public_headers.txt)"
    if top == "examples" and target in public and not users_name:
        yield f"users write <windrow/{target}>"
    if here in public and (target in public or (target or "").endswith(".glsl")) and not (folder_of(root, here) / name).is_file():
        yield "a public header names ours by the way from its own folder, so that a host's own file of that name is not found instead"
    if here in public and "/" in name and not target and not matches(name, ("glm/*", *VULKAN, *FOLDERS_OF_OURS, *OPENVDB, *OPENIMAGEIO)):
        yield "a public header needs GLM, the language's own library and, for the GPU, Vulkan; nothing else"


def breaches_of_room(here, target, public):
    """Why a file may not look into this room of fluid/: sentences."""
    folders, rooms = here.split("/")[:-1], target.split("/")[:-1]
    if rooms == ["gpu"] and not matches(here, USES_GPU):
        yield "gpu is used by fluid/vulkan, coupling/vulkan, vegetation, cli and tests"
    elif folders == ["gpu"] and rooms[:1] == ["fluid"] and target not in public and not matches(target, BELOW_GPU):
        yield "gpu is below the wind: of fluid it knows installed headers and messages"
    if rooms[:1] != ["fluid"] or len(rooms) == 1 or rooms[:2] == folders[:2] or folders[0] == "examples":
        return
    if rooms[1] == "cpu" and not matches(here, OPENS_CPU):
        yield "fluid/cpu is closed, except to fluid/wind*.cpp and to the references in cases/"
    elif rooms[1] == "vulkan" and target not in public and not matches(here, SEES_DEVICE_WIND):
        yield "of fluid/vulkan others see its public headers"
    elif folders[0] == "fluid" and len(folders) > 1 and rooms[1] not in ("cpu", "shapes") and not matches(target, ROOMS[folders[1]]):
        yield f"fluid/{folders[1]} does not know fluid/{rooms[1]}"


def public_headers(root):
    lines = (root / "cmake" / "public_headers.txt").read_text(encoding="utf-8").splitlines()
    return {line for line in lines if line and not line.startswith("#")}


def check(root):
    root = pathlib.Path(root).resolve()
    public = public_headers(root)
    files = [path for folder in FOLDERS if (root / folder).is_dir() for path in sorted((root / folder).rglob("*"))
             if path.is_file() and path.suffix in SOURCES]
    found = []
    openvdb_files = []
    for file in files:
        here = file.relative_to(root).as_posix()
        text = file.read_text(encoding="utf-8")
        lines = len(text.splitlines())
        if lines > LONGEST_FILE and here != SENTENCES:
            found.append(f"{here}:{lines}: {lines} lines; {LONGEST_FILE} are the most. Does it hold one concept?")
        if file.suffix in (".py", ".cmake", ".txt"):
            continue
        if file.suffix in (".h", ".cpp") and not matches(here, MAKERS):
            found += [f"{here}:{number}: {call}: Vulkan objects are made in gpu and vegetation/vulkan"
                      for number, line in enumerate(text.splitlines(), 1)
                      for call in MAKES_OBJECTS.findall(re.sub('"[^"]*"', "", line).split("//")[0])]
        for number, name in includes(text):
            target = within_root(root, file, name)
            found += [f"{here}:{number}: includes {name}: {why}" for why in breaches_of_room(here, target or name, public)]
            found += [f"{here}:{number}: includes {name}: {why}" for why in breaches_of_include(root, file, name, public)]
            if matches(name, OPENVDB) and file.match("fluid/vdb/*.cpp") and here not in openvdb_files:
                openvdb_files.append(here)
    for here in sorted(public):
        if not (root / here).is_file():
            found.append(f"cmake/public_headers.txt:1: {here} does not exist")
    for here in openvdb_files[1:]:
        found.append(f"{here}:1: OpenVDB belongs in one translation unit of the library, which is {openvdb_files[0]}")
    return len(files), found


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    count, found = check(sys.argv[1])
    if count == 0:
        sys.exit(f"{sys.argv[1]} holds no source file: is it the project's root?")
    print(f"{count} files, {len(found)} breaches")
    print("\n".join(found), end="\n" if found else "")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
