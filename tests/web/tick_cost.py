#!/usr/bin/env python3
"""tick_cost.py NATIVE WASM [--timed]: CPU time of a tick as WebAssembly in node over that of the native baseline, of one run after the other.

Each program (windrow_tick_bench) runs for few steps and for many; the difference leaves out what starting costs. Both must have the
same bits. The exit code is 1 where they differ or, with --timed, where the ratio exceeds 1.8.
"""
import resource
import statistics
import subprocess
import sys

FEW, MANY, BOUND = 100, 500, 1.8


def seconds(command, steps):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([*command, str(steps)], stdout=subprocess.PIPE, text=True, check=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done


def main():
    native, wasm = [sys.argv[1]], ["node", "--no-experimental-fetch", sys.argv[2]]
    ratios = []
    for _ in range(5):
        costs, texts = [], []
        for command in (native, wasm):
            (few, _), (many, text) = seconds(command, FEW), seconds(command, MANY)
            costs.append(1000 * (many - few) / (MANY - FEW))
            texts.append(text)
        ratios.append(costs[1] / costs[0])
        print(f"native {costs[0]:.2f} ms, WebAssembly {costs[1]:.2f} ms a tick: {ratios[-1]:.2f}; {texts[0].strip()}")
        if texts[0] != texts[1]:
            sys.exit(f"the bits differ: {texts[0]} and {texts[1]}")
    ratio = statistics.median(ratios)
    print(f"[figure] web/cpu_of_a_tick_over_native = {ratio:.2f} <= {BOUND}")
    sys.exit("--timed" in sys.argv and ratio > BOUND)


if __name__ == "__main__":
    main()
