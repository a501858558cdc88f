#!/usr/bin/env python3
"""python_costs_test.py: what the Python package costs: a call, many points, memory over many winds, two threads."""
import ctypes
import math
import resource
import threading
import time
import unittest
import zlib

import numpy as np

import windrow
from windrow import _c, _library


class Costs(unittest.TestCase):
    def test_ten_thousand_winds_leave_no_memory_behind(self):
        def make(count):
            for _ in range(count):
                wind = windrow.Wind(windrow.Config(cells=(8, 8, 8)))
                wind.obstacles.add(windrow.Obstacle())
                wind.step(1 / 60)
                wind.field()
        def held():
            with open("/proc/self/statm", encoding="ascii") as file:
                return int(file.read().split()[1]) * resource.getpagesize()
        make(500)
        before = held()
        make(10000)
        self.assertLess(held() - before, 4 << 20)

    def test_a_point_and_many(self):
        wind = windrow.Wind(windrow.Config(boundaries=windrow.Boundaries.open_over_floor(), ambient=(3, 0, 0)))
        points = np.random.default_rng(3).uniform(-10, 10, (10000, 3))
        out = np.empty(points.shape, np.float32)
        one = min(timed(lambda: [wind.velocity((1.0, 2.0, 3.0)) for _ in range(2000)]) for _ in range(7)) / 2000
        query = _c.Query()
        _library.check(_library.library.windrow_query_init(ctypes.byref(query), ctypes.sizeof(query)))
        query.count, query.positions = len(points), points.ctypes.data
        query.velocities = out.ctypes.data_as(ctypes.POINTER(ctypes.c_float))
        call, place = _library.library.windrow_wind_sample, ctypes.byref(query)
        in_c, many = math.inf, math.inf
        for _ in range(50):  # interleaved
            in_c = min(in_c, timed(lambda: call(wind._wind, place)))
            many = min(many, timed(lambda: wind.sample(points, out=out)))
        print(f"[figure] python_point = {1e6 * one:.2f} us (bound 2)\n[figure] python_points = {many / in_c:.3f} of the call in C (bound 1.05)")
        self.assertLess(one, 2e-6)
        self.assertLess(many / in_c, 1.05)

    def test_two_threads_step_two_winds_at_once(self):
        """Beside what two threads get of this machine for work that holds nothing, in turns."""
        winds = [windrow.Wind(windrow.Config(cells=(64, 32, 64), ambient=(3, 0, 0))) for _ in range(2)]
        for wind in winds:
            wind.motors.add(windrow.JetMotor())
        text = np.random.default_rng(1).bytes(1 << 20)
        def cores_of(works):
            threads = [threading.Thread(target=work) for work in works]
            wall, cpu = time.perf_counter(), time.process_time()
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            return (time.process_time() - cpu) / (time.perf_counter() - wall)
        ours, free = 0.0, 0.0
        for _ in range(5):
            free = max(free, cores_of([lambda: [zlib.crc32(text) for _ in range(150)]] * 2))
            ours = max(ours, cores_of([lambda wind=wind: [wind.step(1 / 60) for _ in range(20)] for wind in winds]))
        print(f"[figure] python_two_threads = {ours:.2f} cores, of {free:.2f} that this machine gives")
        self.assertGreater(ours, 0.85 * free)


def timed(call):
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


if __name__ == "__main__":
    unittest.main()
