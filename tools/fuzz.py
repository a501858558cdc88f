#!/usr/bin/env python3
"""fuzz.py PRESET [PARSER...] [--executions N | --seconds S] [--part K/N] [--fresh]
fuzz.py PRESET --join FOLDER...

Runs the fuzz targets of build/PRESET one after the other, a slice of time each, until every parser has had N executions with this
preset, or S seconds have passed. Without either: one slice each.

build/fuzz-corpus/PARSER     the corpus, where the next run goes on
build/fuzz-corpus/counts.csv executions, accepted inputs and seconds of each parser and preset, over all runs
build/fuzz-findings          inputs that ended a parser; the exit code is 1 where this run added one

--part K/N takes every N-th parser, for machines that share the work. --join adds what other machines have in their folders `build`:
corpora, counts and findings. A folder is joined once: its counts have a mark then.
"""
import argparse
import csv
import fcntl
import os
import pathlib
import signal
import struct
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "tests" / "fuzz"
CORPUS = ROOT / "build" / "fuzz-corpus"
FINDINGS = ROOT / "build" / "fuzz-findings"
TABLE = CORPUS / "counts.csv"
COLUMNS = ("parser", "preset", "executions", "accepted", "accepted_percent", "seconds", "per_second")
# [byte] Of an input: room for a few of the largest seeds, and small enough for thousands of executions a second.
LONGEST = {"scene": 4096, "picture": 12288, "path_table": 1024, "obstacle_mesh": 2048, "vox": 1024, "map": 512, "obj": 4096,
           "gltf": 4096, "glb": 4096, "snapshot": 8192, "event_log": 2048, "saved": 8192, "command_line": 256}
LONGEST_SLICE = 900  # [s] until a process that hangs is killed: a slice, and reading a large corpus before it
SLICE = 60  # [s] after which the next parser has its turn, and the table is written


def read_table():
    if not TABLE.is_file():
        return {}
    with open(TABLE, newline="", encoding="utf-8") as file:
        return {(row["parser"], row["preset"]): [int(row["executions"]), int(row["accepted"]), float(row["seconds"])]
                for row in csv.DictReader(file)}


def add_counts(parser, preset, counts):
    """Adds to a row of the table, which runs of both presets may do at a time; the row's sums."""
    CORPUS.mkdir(parents=True, exist_ok=True)
    with open(CORPUS / "counts.lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        table = read_table()
        row = [old + new for old, new in zip(table.get((parser, preset), (0, 0, 0.0)), counts)]
        table[(parser, preset)] = row
        write_table(table)
    return row


def write_table(table):
    beside = TABLE.with_suffix(".new")
    with open(beside, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for (parser, preset), (executions, accepted, seconds) in sorted(table.items()):
            writer.writerow((parser, preset, executions, accepted, f"{100 * accepted / max(executions, 1):.1f}",
                             f"{seconds:.1f}", f"{executions / max(seconds, 1e-9):.0f}"))
    beside.replace(TABLE)


def read_part(text):
    numbers = text.split("/")
    if len(numbers) != 2 or not all(number.isdigit() for number in numbers) or not 1 <= int(numbers[0]) <= int(numbers[1]):
        raise argparse.ArgumentTypeError(f"{text}: give K/N, part K of N, such as 1/8")
    return int(numbers[0]), int(numbers[1])


def join(folder):
    """Adds the folder `build` of another machine: a sentence where it has none of this."""
    counts, mark = folder / "fuzz-corpus" / "counts.csv", folder / "fuzz-corpus" / "joined"
    if not counts.is_file():
        return f"{counts} is missing: name the folder build of a machine that has fuzzed"
    if mark.is_file():
        return f"{folder} was joined before: its counts would be added twice"
    with open(counts, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    added = 0
    for row in rows:
        for source, kept in ((folder / "fuzz-corpus" / row["parser"], CORPUS / row["parser"]), (folder / "fuzz-findings", FINDINGS)):
            kept.mkdir(parents=True, exist_ok=True)
            for path in source.iterdir() if source.is_dir() else ():
                if path.is_file() and not (kept / path.name).exists():  # libFuzzer names an input after its content
                    (kept / path.name).write_bytes(path.read_bytes())
                    added += 1
        add_counts(row["parser"], row["preset"], (int(row["executions"]), int(row["accepted"]), float(row["seconds"])))
    mark.touch()
    print(f"{folder}: {added} inputs and the counts of {len(rows)} rows")
    return None


def run_slice(parser, preset, limit, fresh):
    """One libFuzzer process: executions, accepted, seconds, and its exit code; None where it was interrupted."""
    corpus = CORPUS / parser
    corpus.mkdir(parents=True, exist_ok=True)
    FINDINGS.mkdir(parents=True, exist_ok=True)
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    with tempfile.TemporaryDirectory(prefix="windrow_fuzz_", dir=memory) as folder:
        counts = pathlib.Path(folder) / "counts"
        if fresh:
            corpus = pathlib.Path(folder) / "corpus"
            corpus.mkdir()
        command = [ROOT / "build" / preset / f"windrow_fuzz_{parser}", corpus, SOURCE / "seeds" / parser]
        if (SOURCE / "findings" / parser).is_dir():
            command.append(SOURCE / "findings" / parser)
        # The entropic schedule takes a third of the time where inputs have many features.
        command += ["-entropic=0", f"-dict={SOURCE / parser}.dict", f"-max_len={LONGEST[parser]}",
                    f"-artifact_prefix={FINDINGS / parser}-", "-rss_limit_mb=1024", "-timeout=10", "-len_control=0", limit]
        # The quarantine counts against the memory limit, and UBSan only prints by default.
        environment = dict(os.environ, TMPDIR=folder, WINDROW_FUZZ_COUNTS=str(counts),
                           ASAN_OPTIONS="quarantine_size_mb=64:" + os.environ.get("ASAN_OPTIONS", ""),
                           UBSAN_OPTIONS="print_stacktrace=1:halt_on_error=1")
        log = CORPUS / f"{parser}.log"
        start = time.monotonic()
        with open(log, "w", encoding="utf-8") as output:
            process = subprocess.Popen(command, env=environment, stdout=output, stderr=subprocess.STDOUT)
        try:
            status = process.wait(LONGEST_SLICE)
        except subprocess.TimeoutExpired:  # libFuzzer's limit holds for the parser alone, not for a mutator
            process.kill()
            status = process.wait()
        except KeyboardInterrupt:  # what was done until then counts
            process.terminate()
            process.wait()
            status = None
        seconds = time.monotonic() - start
        executions, accepted = struct.unpack("=2Q", counts.read_bytes()) if counts.is_file() else (0, 0)
    if status is not None and status != 0:
        print(f"fuzz.py: {parser} ended with {status}; the input is {FINDINGS}/{parser}-*, the report {log}", flush=True)
    return executions, accepted, seconds, status


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("preset", choices=("fuzz", "fuzz-fast"))
    arguments.add_argument("parsers", nargs="*", metavar="PARSER", help=", ".join(LONGEST))
    arguments.add_argument("--part", type=read_part, metavar="K/N", default=(1, 1), help="part K of N of the parsers")
    limits = arguments.add_mutually_exclusive_group()
    limits.add_argument("--join", type=pathlib.Path, nargs="+", metavar="FOLDER", help="folders build of other machines")
    limits.add_argument("--executions", type=int, metavar="N", help="of each parser, those of former runs included")
    limits.add_argument("--seconds", type=float, metavar="S", help="of all parsers together")
    arguments.add_argument("--fresh", action="store_true", help="begin with the seeds: reading a large corpus takes its own time")
    wish = arguments.parse_args()
    parsers = wish.parsers or list(LONGEST)
    for parser in parsers:
        if parser not in LONGEST:
            arguments.error(f"unknown parser {parser}: use {', '.join(LONGEST)}")
    if wish.join:
        faults = [fault for fault in map(join, wish.join) if fault]
        for fault in faults:
            print(f"fuzz.py: {fault}", file=sys.stderr)
        sys.exit(2 if faults else 0)
    parsers = parsers[wish.part[0] - 1::wish.part[1]]

    signal.signal(signal.SIGTERM, signal.default_int_handler)
    well = True
    waiting = list(parsers)
    end = time.monotonic() + wish.seconds if wish.seconds else None
    while waiting:
        parser = waiting.pop(0)
        if wish.executions and read_table().get((parser, wish.preset), (0,))[0] >= wish.executions:
            continue
        seconds = SLICE
        if end:
            seconds = max(1.0, min(SLICE, (end - time.monotonic()) / (len(waiting) + 1)))
        executions, accepted, took, status = run_slice(parser, wish.preset, f"-max_total_time={int(seconds)}",
                                                        wish.fresh)
        row = add_counts(parser, wish.preset, (executions, accepted, took))
        print(f"{parser}: {executions} executions in {took:.0f} s, {100 * accepted / max(executions, 1):.1f} % accepted; "
              f"{row[0]} with {wish.preset} in all", flush=True)
        if status is None:
            sys.exit(130)
        well = well and status == 0
        # A parser with a finding would end there again and again.
        if status == 0 and (wish.executions or end and seconds == SLICE):
            waiting.append(parser)
    sys.exit(0 if well else 1)


if __name__ == "__main__":
    main()
