#!/usr/bin/env python3
"""make_web.py BUILD: the page and the package of npm from bindings/web and the modules in BUILD/simd and BUILD/plain. ./dev web runs it.

    BUILD/page       index.html, app.js, worker.js, and of each form of the module what the first picture needs (windrow.lzma,
                     windrow_plain.lzma) and the rest (..._rest.lzma); scenery.js, trees and furred bodies, which a scene that has
                     them fetches: a folder of static files
    BUILD/page/scenes  the scenes and the files that they name
    BUILD/windrow.html one file that opens from a mail, everything inlined
    BUILD/package    the package of npm

The modules of the page are packed by LZMA (bindings/web/page/unpack.js), its scripts made small by terser. Shaders are the page's own and
those that they include, from shaders/ and vegetation/shaders, without comments. The panel's rows come
from c_api/tables.json. --sizes prints what a visitor downloads.
"""
import argparse
import base64
import gzip
import json
import lzma
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
WEB = ROOT / "bindings/web"
PAGE = WEB / "page"
APP = ("made.js", "fetched.js", "gl.js", "solids.js", "overlays.js", "meadow.js", "hands.js", "panel.js", "graph.js", "link.js", "main.js")
SCENERY = ("gl.js", "grow.js", "trees.js", "beast.js", "coats.js", "scenery.js")
SCENERY_SHADERS = ("sway.frag", "wood.vert", "wood.frag", "leaf.vert", "leaf.frag", "strands.frag", "coat.vert", "coat.frag")
WORKER = ("../package/windrow.js", "made.js", "unpack.js", "fetched.js", "parts.js", "air.js", "vortices.js", "worker.js")
FORMS = {"simd": "windrow", "plain": "windrow_plain"}
FEATURES = ("simd", "bulk-memory", "sign-ext", "mutable-globals", "nontrapping-float-to-int")
FIRST_SCENE = ROOT / "examples/scenes/web/lawn.json"
TABLES = {"Config": "air", "LogProfile": "profile", "Gusts": "gusts", "JetMotor": "fan", "PressureMotor": "blast", "WakeMotor": "stroke"}
KINDS = {"float", "double", "int32", "uint32", "vec3", "ivec3", "dvec3", "Scheme", "Interpolation"}
BY_HAND = ("position", "direction", "floor", "centre")


def shader_texts(wanted=None):
    """By name: the text without comments; an include is named by its path from the root, or of the page by its file."""
    texts = {}
    wanted = wanted or {path.name: path for path in sorted((PAGE / "shaders").iterdir()) if path.suffix in (".vert", ".frag")}

    def take(path, name):
        if name in texts:
            return
        texts[name] = ""
        text = re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)

        def include(found):
            for folder, prefix in ((path.parent, True), (ROOT, False)):
                other = (folder / found.group(1)).resolve()
                if other.exists():
                    known = other.name if other.parent == PAGE / "shaders" else str(other.relative_to(ROOT))
                    take(other, known)
                    return f'#include "{known}"'
            sys.exit(f"{path} includes {found.group(1)}, which is nowhere")

        lines = (re.sub(r"\s*//.*", "", line).strip() for line in text.splitlines())
        texts[name] = "\n".join(re.sub(r'^#include "(.*)"$', include, line) for line in lines if line and "#extension" not in line) + "\n"

    for name, path in wanted.items():
        take(path, name)
    return texts


def page_shaders():
    """The texts of the first load, and those that trees and furred bodies add."""
    texts = shader_texts()
    names = {path.name: path for path in (PAGE / "shaders").iterdir() if path.suffix in (".vert", ".frag")}
    first = shader_texts({name: path for name, path in sorted(names.items()) if name not in SCENERY_SHADERS})
    return first, {name: text for name, text in texts.items() if name not in first}


def tree_kinds():
    """The kinds of trees by name, from the tables of the renderer: settings' defaults, and what a kind changes."""
    value = r"(?:[\w:]+)?\{[^{}]*\}|[-\w.:]+"

    def read(text):
        if "{" in text:
            return [float(number.rstrip("f")) for number in re.search(r"\{(.*)\}", text).group(1).split(",")]
        word = text.rsplit("::", 1)[-1]
        return word if re.match(r"[A-Za-z_]", word) else float(word.rstrip("f"))

    header = (ROOT / "vegetation/trees/tree_settings.h").read_text(encoding="utf-8")
    defaults = {}
    for struct, key in (("TreeSettings", "tree"), ("TreeLook", "look")):
        body = re.search(rf"struct {struct} \{{\n(.*?)\n\n", header, re.DOTALL).group(1)
        rows = re.findall(r"(\w+)(?: = )?(\{[^{}]*\}|[-\w.:]+)?;", body)
        defaults[key] = {name: read(default) for name, default in rows if default}
    kinds = {"oak": defaults}
    presets = (ROOT / "vegetation/trees/tree_presets.cpp").read_text(encoding="utf-8")
    for name, body in re.findall(r"TreeKind (\w+)\(\) \{\n(.*?)\n\}\n", presets, re.DOTALL):
        kind = {key: dict(values) for key, values in defaults.items()}
        for key, rows in re.findall(r"kind\.(tree|look) = \{(.*?)\};", body, re.DOTALL):
            kind[key] |= {field: read(text) for field, text in re.findall(rf"\.(\w+) = ({value})", rows)}
        for key, field, text in re.findall(rf"kind\.(tree|look)\.(\w+) = ({value});", body):
            kind[key][field] = read(text)
        kinds[name] = kind
    unknown = [f"{name}.{field}" for name, kind in kinds.items() for key, values in kind.items() for field in values if field not in defaults[key]]
    if len(kinds) != 4 or unknown:
        sys.exit(f"vegetation/trees/tree_presets.cpp: kinds are {', '.join(kinds)}, unknown fields {', '.join(unknown) or 'none'}: mend tree_kinds")
    return kinds


def beast_flesh():
    """The capsules of the beast, [ax, ay, az, bx, by, bz, radius_a, radius_b, melt] each, from the renderer's table."""
    joints = dict(re.findall(r"(k_\w+)(\{[^{}]*\})", (ROOT / "vegetation/fur/beast_form.h").read_text(encoding="utf-8")))
    table = re.search(r"Flesh flesh_of\(\) \{(.*?)return flesh;", (ROOT / "vegetation/fur/beast.cpp").read_text(encoding="utf-8"), re.DOTALL).group(1)
    table = re.sub(r"//.*", "", re.sub(r"k_\w+", lambda found: joints[found.group()], table))
    point, number = r"\{([^{}]*)\}", r"([-\d.]+)f"
    rows = []
    for kind, *parts in re.findall(rf"(both\(|\{{){point},\s*{point},\s*{number},\s*{number},\s*{number}", table):
        row = [float(word.strip().rstrip("f")) for part in parts for word in part.split(",")]
        rows.append(row)
        if kind == "both(":
            rows.append([-x if n in (0, 3) else x for n, x in enumerate(row)])
    if len(rows) < 25 or any(len(row) != 9 for row in rows):
        sys.exit(f"vegetation/fur/beast.cpp: {len(rows)} capsules of the beast were read: mend beast_flesh")
    return rows


def bundle(names):
    """Modules one after the other as a plain script: no imports, no exports, no lines of comment, no indentation."""
    text = "".join((PAGE / name).read_text(encoding="utf-8") for name in names)
    text = re.sub(r"^import [^;]*;\n", "", text, flags=re.MULTILINE)
    text = re.sub(r"^export (default )?", "", text, flags=re.MULTILINE)
    lines = (line.strip() for line in re.sub(r"^\s*/\*\*.*?\*/$", "", text, flags=re.MULTILINE | re.DOTALL).splitlines())
    return "\n".join(line for line in lines if line and not line.startswith("//")) + "\n"


TERSER = """
const text = require("fs").readFileSync(0, "utf8");
require("terser").minify(text, {toplevel: true, ecma: 2020, compress: {passes: 2}}).then(({code}) => process.stdout.write(code + "\\n"));
"""


def small(script):
    """The same script with short names, by terser (Debian: node-terser)."""
    environment = {**os.environ, "NODE_PATH": "/usr/share/nodejs"}
    return subprocess.run(["node", "-e", TERSER], input=script, stdout=subprocess.PIPE, text=True, check=True, env=environment).stdout


def by_lzma(content):
    """As bindings/web/page/unpack.js unpacks it."""
    form = {"id": lzma.FILTER_LZMA1, "preset": 9 | lzma.PRESET_EXTREME, "lc": 4, "lp": 0, "pb": 0, "nice_len": 273, "dict_size": 1 << 22}
    return struct.pack("<I", len(content)) + lzma.compress(content, format=lzma.FORMAT_RAW, filters=[form])


def tables():
    structs = json.loads((ROOT / "c_api/tables.json").read_text())["structs"]
    return {part: [row for row in structs[name] if row["type"] in KINDS and row["name"] not in BY_HAND] for name, part in TABLES.items()}


def scenes():
    """What the page lists: the text of each scene as the command reads it, and how the page shows it."""
    shown = json.loads((PAGE / "scenes.json").read_text())
    for scene in shown:
        scene["text"] = json.dumps(json.loads((ROOT / scene["file"]).read_text()), separators=(",", ":"))
        scene["file"] = pathlib.Path(scene["file"]).name
    return shown


def files_of(shown):
    """The files that scenes name, by name."""
    found = {}
    for scene in shown:
        for name in scene.get("files", ()):
            found[name] = (ROOT / "examples/scenes" / name).read_bytes()
    return found


def worker_script(build):
    description = (build / "simd/interface.json").read_text()
    loader = (build / "simd/windrow_page.js").read_text()
    if loader != (build / "plain/windrow_page.js").read_text():
        sys.exit("the loaders of the modules with and without vector instructions differ")
    used = "".join((PAGE / name).read_text() for name in WORKER)
    return f"{loader}\nconst INTERFACE = {pruned(description, used)};\n" + bundle(WORKER)


def pruned(description, used):
    """The structs that the worker makes, and what they hold; choices likewise."""
    whole = json.loads(description)
    words = set(re.findall(r"windrow_\w+", used)) | {name for name in whole["structs"] if name.endswith("_motor")}
    wanted = [name for name in whole["structs"] if name in words or name.removeprefix("windrow_") in
              ("log_profile", "gusts", "canopy", "roughness", "rows")]
    kept = {}
    while wanted:
        name = wanted.pop()
        if name not in kept:
            kept[name] = whole["structs"][name]
            wanted += [kind for kind, *_ in kept[name]["fields"].values() if kind in whole["structs"]]
    return json.dumps({"structs": kept, "choices": whole["choices"]}, separators=(",", ":"))


def parts(build, form, worker):
    """The packed parts of a form's module: what the first picture and the first gestures call, by trial, and the rest."""
    folder = build / form
    whole_module, first, rest = folder / "windrow_page.wasm", folder / "first.wasm", folder / "rest.wasm"
    trial, profile, script = folder / "instrumented.wasm", folder / "first.profile", folder / "worker.js"
    split = ["wasm-split", *(f"--enable-{name}" for name in FEATURES), whole_module]
    subprocess.run([*split, "--instrument", "-o", trial], check=True)
    packed_trial = folder / "instrumented.lzma"
    packed_trial.write_bytes(by_lzma(trial.read_bytes()))
    (folder / "whole.lzma").write_bytes(by_lzma(whole_module.read_bytes()))  # for tests/web/parts_test.mjs
    script.write_text(worker)
    subprocess.run(["node", "--no-experimental-fetch", WEB / "first_picture.mjs", script, packed_trial, FIRST_SCENE, profile], check=True)
    subprocess.run([*split, f"--profile={profile}", "--export-prefix=%", "-o1", first, "-o2", rest], check=True)
    return {f"{FORMS[form]}.lzma": by_lzma(first.read_bytes()), f"{FORMS[form]}_rest.lzma": by_lzma(rest.read_bytes())}


def app_script(shown):
    return with_data({"SHADERS": page_shaders()[0], "TABLES": tables(), "SCENES": shown}, APP)


def scenery_script():
    """In a function, since its short names are app.js's too."""
    return "(() => {" + with_data({"SCENERY_SHADERS": page_shaders()[1], "TREE_KINDS": tree_kinds(), "BEAST_FLESH": beast_flesh()}, SCENERY) + "})();\n"


def with_data(data, names):
    return small("".join(f"const {name} = {json.dumps(value, separators=(',', ':'))};\n" for name, value in data.items()) + bundle(names))


def page(build):
    folder = build / "page"
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "scenes").mkdir(parents=True)
    shown = scenes()
    for name, content in files_of(shown).items():
        (folder / "scenes" / name).write_bytes(content)
    html, style = (PAGE / "index.html").read_text(), (PAGE / "style.css").read_text()
    app, worker = app_script(shown), worker_script(build)
    (folder / "index.html").write_text(html.replace("/* style.css */", style))
    (folder / "app.js").write_text(app)
    for name in ("LICENSE", "NOTICE"):
        shutil.copy(ROOT / name, folder / f"{name}.txt")
    modules = {name: content for form in FORMS for name, content in parts(build, form, worker).items()}
    worker = small(worker)
    for name, content in modules.items():
        (folder / name).write_bytes(content)
    (folder / "worker.js").write_text(worker)
    scenery = scenery_script()
    (folder / "scenery.js").write_text(scenery)
    fetched = {**modules, "worker.js": worker.encode(), "scenery.js": scenery.encode(), **{f"scenes/{name}": content for name, content in files_of(shown).items()}}
    whole(build, html.replace("/* style.css */", style), app, fetched)
    return folder


def packed(content):
    return base64.b64encode(gzip.compress(content, 9, mtime=0)).decode()


def whole(build, html, app, files):
    """One file: what the page fetches as gzip in base64."""
    inlined = {name: packed(content) for name, content in files.items()}
    script = f"const INLINED = {json.dumps(inlined)};\n{app}".replace("</script", "<\\/script")
    notice = (ROOT / "NOTICE").read_text().replace("--", "- -")
    html = html.replace('<script src="app.js"></script>', f"<script>{script}</script>").replace("NOTICE.txt", "https://www.apache.org/licenses/LICENSE-2.0")
    (build / "windrow.html").write_text(f"{html}<!--\n{notice}-->\n")


LOADER = """// The loader of Emscripten, as a module: in node it asks for `require`.
const node = typeof process === "object" && typeof process.versions?.node === "string";
const require = node ? (await import("node:module")).createRequire(import.meta.url) : undefined;
const __dirname = ".";
"""
INDEX = """import {Library, Wind, hasSimd, instantiate} from "./windrow.js";
import createWindrow from "./loader.js";
import description from "./interface.js";
export {Library, Wind, hasSimd};
export {default as windrow_wind_glsl} from "./wind_glsl.js";

/** The library, with vector instructions where this machine has them. */
export async function load({simd = hasSimd()} = {}) {
    const {default: packed} = await (simd ? import("./simd.js") : import("./plain.js"));
    const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
    const stream = new Response(bytes).body.pipeThrough(new DecompressionStream("gzip"));
    return instantiate(createWindrow, {wasmBinary: new Uint8Array(await new Response(stream).arrayBuffer())}, description);
}
"""


def package(build):
    """The package of npm: modules of JavaScript with the WebAssembly in them."""
    folder = build / "package"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(WEB / "package", folder)
    loader = (build / "simd/windrow_package.js").read_text()
    if loader != (build / "plain/windrow_package.js").read_text():
        sys.exit("the loaders of the modules with and without vector instructions differ")
    texts = {}
    expand = shader_texts({"wind": ROOT / "shaders/coupling/windrow_wind.glsl"})

    def whole_text(name):
        texts[name] = True
        return re.sub(r'^#include "(.*)"\n', lambda found: "" if found.group(1) in texts else whole_text(found.group(1)), expand[name],
                      flags=re.MULTILINE)

    modules = {"interface.js": (build / "simd/interface.json").read_text(), "wind_glsl.js": json.dumps("#define WINDROW_ES\n" + whole_text("wind")),
               **{f"{form}.js": json.dumps(packed((build / form / "windrow_package.wasm").read_bytes())) for form in ("simd", "plain")}}
    for name, value in modules.items():
        (folder / name).write_text(f"export default {value};\n")
    (folder / "loader.js").write_text(f"{LOADER}{loader}\nexport default createWindrow;\n")
    (folder / "index.js").write_text(INDEX)
    version = re.search(r'define WINDROW_VERSION_STRING "(.*)"', (ROOT / "fluid/version.h").read_text()).group(1)
    described = {"name": "windrow", "version": version, "description": "The wind around a player on a voxel grid, as WebAssembly",
                 "license": "Apache-2.0", "type": "module", "exports": {".": {"types": "./index.d.ts", "default": "./index.js"}},
                 "types": "./index.d.ts", "sideEffects": False}
    (folder / "package.json").write_text(json.dumps(described, indent=4) + "\n")
    for name in ("LICENSE", "NOTICE"):
        shutil.copy(ROOT / name, folder / name)


def sizes(folder):
    total = 0
    for name in ("index.html", "app.js", "worker.js", "windrow.lzma", "windrow_rest.lzma", "scenery.js"):
        content = (folder / name).read_bytes()
        small_size = len(gzip.compress(content, 9))
        total += small_size
        print(f"{name:20} {len(content):8} bytes, {small_size:7} gzipped; {total / 1000:.0f} kB up to here")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--sizes", action="store_true")
    arguments = parser.parse_args()
    folder = page(arguments.build)
    if (arguments.build / "plain/windrow_package.js").exists():
        package(arguments.build)
    if arguments.sizes:
        sizes(folder)


if __name__ == "__main__":
    main()
