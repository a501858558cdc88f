#!/usr/bin/env python3
"""make_film.py PROGRAM [NAME] [flags]: draws the shots of a film and cuts them together: out/NAME/windrow.mp4.

PROGRAM is the program build/release/windrow-draw. NAME is a film of the edit list, tools/film.json: its shots in their order, with
cross-fades of one length. A shot has
    scene     a file of examples/scenes, without .json
    from      [s] where it begins in the scene; seconds: how long it is, fades included
    camera    {"from": [x, y, z], "to": [x, y, z]}: the eye goes from one place to the other while the shot lasts, slowly at both
              ends; "target" the same, of the point that it looks at; default: the scene's own camera
    set       keys of the scene and their values in place of its own, as {"duration": 6}

A run that is stopped, in whatever way, goes on by the same command: pictures are written whole, and those that are there are kept
while program, scene and flags are the same. Needs ffmpeg; a software device draws 640 x 360 at one to six seconds a frame.

Several shots are drawn at a time (--jobs), since a frame leaves cores idle: a software device makes vertices by one thread, and a
GPU waits while a picture is packed. The pictures' bytes are the same.
"""
import argparse
import concurrent.futures
import copy
import hashlib
import importlib.util
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
SCENES = ROOT / "examples" / "scenes"


class Fault(Exception):
    """Wrong use: one sentence, exit code 2."""


def eased(t):
    return t * t * (3.0 - 2.0 * t)


def path_of(move, begin, seconds):
    """Points of a path [t, x, y, z] that rests before and after the shot."""
    steps = 16
    points = []
    for n in range(steps + 1):
        part = eased(n / steps)
        points.append([begin + seconds * n / steps] + [a + (b - a) * part for a, b in zip(move["from"], move["to"])])
    return {"points": points}


def scene_of(shot):
    """The scene's text with what the shot changes of it."""
    file = SCENES / (shot["scene"] + ".json")
    if not file.is_file():
        raise Fault(f"{shot['scene']} is no scene of {SCENES}; correct the edit list.")
    scene = json.loads(file.read_text(encoding="utf-8"))
    scene.update(copy.deepcopy(shot.get("set", {})))
    if shot["from"] + shot["seconds"] > scene.get("duration", 10):
        raise Fault(f"{shot['scene']} ends at {scene.get('duration', 10)} s, before its shot from {shot['from']} s on for {shot['seconds']} s; "
                    'shorten the shot, or give "set": {"duration": ...}.')
    camera = scene.get("picture", {}).get("camera", {})
    for key, (place, path) in {"camera": ("position", "path"), "target": ("target", "target_path")}.items():
        if key in shot:
            scene.setdefault("paths", {})[f"film {key}"] = path_of(shot[key], shot["from"], shot["seconds"])
            camera.pop(place, None)
            camera[path] = f"film {key}"
    return json.dumps(scene, indent=1)


def mirror(folder):
    """Copies what scenes name to folders like theirs, where a changed scene finds it: scenes reject links out of their folder."""
    for file in SCENES.rglob("*"):
        here = folder / file.relative_to(SCENES)
        if file.is_dir():
            here.mkdir(parents=True, exist_ok=True)
        elif file.suffix != ".json" and not (here.is_file() and here.stat().st_mtime_ns == file.stat().st_mtime_ns):
            shutil.copy2(file, here)


def hash_of(*files):
    made = hashlib.sha256()
    for file in files:
        made.update(file.read_bytes())
    return made.hexdigest()


class Programs:
    """Running programs. All are terminated when one fails or this program is stopped."""

    def __init__(self):
        self.lock, self.running, self.ended = threading.Lock(), set(), False

    def run(self, command):
        """Returns exit code and output; the code is None after `end`."""
        with self.lock:
            if self.ended:
                return None, ""
            program = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
            self.running.add(program)
        output, _ = program.communicate()
        with self.lock:
            self.running.remove(program)
            return None if self.ended else program.returncode, output

    def end(self):
        with self.lock:
            self.ended = True
            for program in self.running:
                program.terminate()


class Shot:
    def __init__(self, number, shot, options):
        self.name = f"{number:02d}_{shot['scene'].split('/')[-1]}"
        self.about, self.options = shot, options
        self.first = round(shot["from"] * options.fps)
        self.count = round(shot["seconds"] * options.fps)
        self.frames = options.out / "frames" / self.name
        self.scene = options.out / "scenes" / pathlib.Path(shot["scene"]).parent / f"{self.name}.json"

    def missing(self):
        return [n for n in range(self.first, self.first + self.count) if not (self.frames / f"frame_{n:04d}.png").is_file()]

    def draw(self, program_hash, programs):
        text = scene_of(self.about)
        self.scene.write_text(text, encoding="utf-8")
        flags = ["--fps", str(self.options.fps), "--from", repr(self.first / self.options.fps), "--frames", str(self.count),
                 "--size", self.options.size, "--shutter", str(self.options.shutter)]
        named = hash_of(*sorted(file for file in self.scene.parent.iterdir() if file.is_file() and file.suffix != ".json"))
        stamp = "\n".join([program_hash, named, hashlib.sha256(text.encode()).hexdigest(), *flags])
        stamp_file = self.frames / "made_of"
        if not stamp_file.is_file() or stamp_file.read_text() != stamp:
            shutil.rmtree(self.frames, ignore_errors=True)
            self.frames.mkdir(parents=True)
            stamp_file.write_text(stamp)  # a part of one is no one's: all is drawn again
        missing = len(self.missing())
        print(f"== {self.name}: {self.count} frames" + (f", {self.count - missing} are there" if missing < self.count else ""), flush=True)
        if missing == 0:
            return
        begin = time.monotonic()
        code, output = programs.run([self.options.program, self.scene, *flags, "--resume", "--out", self.frames])
        if code is None:
            return
        if code != 0 or self.missing():
            print(output, end="")
            raise Fault(f"{self.name} was not drawn whole; see above.")
        print(f"   {self.name}: {(time.monotonic() - begin) / missing:.2f} s a frame", flush=True)


def draw_all(shots, jobs, program_hash):
    programs = Programs()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        try:
            for drawn in concurrent.futures.as_completed([pool.submit(shot.draw, program_hash, programs) for shot in shots]):
                drawn.result()
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            programs.end()
            raise


def inputs_and_filter(shots, fade, fps, ending):
    """ffmpeg's inputs, the filter that fades one into the next, as [film], the film's length [s], and where fades begin and end."""
    inputs, chain, shown, cuts = [], [], 0.0, []
    last = "0:v"
    for n, shot in enumerate(shots):
        inputs += ["-framerate", str(fps), "-start_number", str(shot.first), "-i", shot.frames / "frame_%04d.png"]
        if n > 0:
            chain.append(f"[{last}][{n}:v]xfade=transition=fade:duration={fade}:offset={shown - fade:.6f}[f{n}]")
            last = f"f{n}"
            cuts += [shown - fade, shown]
        shown += shot.count / fps - (fade if n > 0 else 0.0)
    chain.append(f"[{last}]{ending}[film]")
    return inputs, ";".join(chain), shown, cuts


def ffmpeg(arguments, file):
    """Writes the file whole or not at all."""
    part = file if "%" in file.name else file.with_name("part_" + file.name)  # pictures: into a folder that is made again
    run = subprocess.run(["ffmpeg", "-v", "error", "-y", *map(str, arguments), str(part)], check=False)
    if run.returncode != 0:
        part.unlink(missing_ok=True)
        raise Fault(f"ffmpeg made no {file.name}; see above.")
    if part != file:
        os.replace(part, file)


def cut(shots, fade, options):
    film = options.out / "windrow.mp4"
    inputs, chain, shown, cuts = inputs_and_filter(shots, fade, options.fps, "format=yuv420p")
    ffmpeg([*inputs, "-filter_complex", chain, "-map", "[film]", "-c:v", "libx264", "-crf", "18", "-force_key_frames",
            ",".join(f"{max(cut - 0.25 / options.fps, 0.0):.6f}" for cut in cuts) or "0", "-movflags", "+faststart"], film)
    print(f"{film}: {shown:.1f} s, {film.stat().st_size / 1e6:.1f} MB")
    if options.webp is None:
        return
    page = options.out / "page"
    shutil.rmtree(page, ignore_errors=True)
    page.mkdir(exist_ok=True)
    inputs, chain, _, _ = inputs_and_filter(shots, fade, options.fps, "fps=12,scale=400:-1:flags=area")
    ffmpeg([*inputs, "-filter_complex", chain, "-map", "[film]"], page / "frame_%04d.png")
    command = ["-B", pathlib.Path(__file__).with_name("webp_film.py"), options.webp, *sorted(page.glob("frame_*.png"))]
    if subprocess.run([sys.executable, *command], check=False).returncode != 0:
        raise Fault(f"{options.webp} was not made; see above.")


def read_edit(options):
    films = json.loads(options.edit.read_text(encoding="utf-8"))
    if options.name not in films:
        raise Fault(f"{options.name} is no film of {options.edit}; give one of: {', '.join(films)}.")
    film = films[options.name]
    for number, shot in enumerate(film["shots"], 1):
        unknown = shot.keys() - {"scene", "from", "seconds", "camera", "target", "set"}
        if unknown or not {"scene", "from", "seconds"} <= shot.keys():
            raise Fault(f"{options.edit}, {options.name}, shot {number}: give scene, from, seconds, and camera, target, set if need be; "
                        f"it has {', '.join(sorted(shot))}.")
        if shot["seconds"] <= 2 * film["fade"]:
            raise Fault(f"{options.edit}, {options.name}, shot {number}: seconds is {shot['seconds']}, within its two fades of "
                        f"{film['fade']} s; give more.")
    return film


def options_of(arguments):
    parser = argparse.ArgumentParser(prog="make_film.py", description="Draws a film of tools/film.json.", exit_on_error=False)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("name", nargs="?", default="film")
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--fps", type=int, default=24)
    parser.add_argument("--shutter", type=float, default=180.0)
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--edit", type=pathlib.Path, default=ROOT / "tools" / "film.json")
    parser.add_argument("--webp", type=pathlib.Path, help="a small film for a page too: 400 px wide, 12 frames a second (webp_film.py)")
    parser.add_argument("--jobs", type=int, default=min(os.cpu_count() or 1, 4), help="shots drawn at a time; default: one a core, 4 at most")
    parser.add_argument("--frames-only", action="store_true", help="draw, and do not cut")
    try:
        options = parser.parse_args(arguments)
    except argparse.ArgumentError as error:
        raise Fault(f"{error}.") from error
    options.out = options.out or ROOT / "out" / options.name
    if not re.fullmatch(r"\d{2,4}x\d{2,4}", options.size) or any(int(side) % 2 for side in options.size.split("x")):
        raise Fault(f"--size is {options.size}; give it as 1920x1080, with even sides.")
    if not 1 <= options.fps <= 240:
        raise Fault(f"--fps is {options.fps}; give 1 to 240.")
    if not 1 <= options.jobs <= 64:
        raise Fault(f"--jobs is {options.jobs}; give 1 to 64.")
    if options.webp is not None:
        if options.frames_only:
            raise Fault("--webp is cut from all shots; leave --frames-only out.")
        if options.webp.absolute().parent != options.out.absolute() and not options.webp.absolute().parent.is_dir():
            raise Fault(f"--webp is {options.webp}, in no folder; make that first.")
        if importlib.util.find_spec("PIL") is None:
            raise Fault("--webp needs Pillow; install Debian's package python3-pil and use /usr/bin/python3.")
    if not options.frames_only and shutil.which("ffmpeg") is None:
        raise Fault("ffmpeg is not installed; install Debian's package ffmpeg, or draw alone by --frames-only.")
    return options


def main():
    options = options_of(sys.argv[1:])
    film = read_edit(options)
    shots = [Shot(number, shot, options) for number, shot in enumerate(film["shots"], 1)]
    (options.out / "scenes").mkdir(parents=True, exist_ok=True)
    mirror(options.out / "scenes")
    program_hash = hash_of(options.program)
    for shot in film["shots"]:
        scene_of(shot)  # a fault of the last shot is found before the first is drawn
    draw_all(shots, options.jobs, program_hash)
    if not options.frames_only:
        cut(shots, film["fade"], options)


def stop(*_):
    raise KeyboardInterrupt


if __name__ == "__main__":
    for stopped in (signal.SIGTERM, signal.SIGHUP):  # as Ctrl-C: the programs end too
        signal.signal(stopped, stop)
    try:
        main()
    except Fault as fault:
        print(f"make_film.py: {fault}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        print("make_film.py: stopped; the same command goes on from here.", file=sys.stderr)
        sys.exit(1)
