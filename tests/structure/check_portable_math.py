#!/usr/bin/env python3
"""check_portable_math.py LIBRARY...: what reaches the state of a wind or a plant calls no elementary function of the C library.

Its bits differ between systems and processors; those of fluid/portable_math.h do not. Reads the undefined names of static libraries
by nm, prints each such call with its object, and exits with 1 if there is one. Functions that IEEE arithmetic makes exact (floor,
fmod, ldexp) are fine.
"""
import re
import subprocess
import sys

FUNCTIONS = ("acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "cbrt", "cos", "cosh", "erf", "erfc", "exp", "exp10", "exp2",
             "expm1", "fma", "hypot", "lgamma", "log", "log10", "log1p", "log2", "pow", "sin", "sincos", "sinh", "tan", "tanh", "tgamma")
NAME = re.compile(rf"^(?:__)?(?:{'|'.join(FUNCTIONS)})(?:f|l)?(?:_finite)?(?:@.*)?$")


def calls(text):
    """Object and function of each line of nm that names one."""
    name = ""
    for line in text.splitlines():
        if line.endswith(":"):
            name = line[:-1]
        words = line.split()
        if words and NAME.match(words[-1]):
            yield name, words[-1]


def main():
    sample = "basis.cpp.o:\n                 U sin\n U cosf\n U floorf\n U _Z3expd\n"
    if list(calls(sample)) != [("basis.cpp.o", "sin"), ("basis.cpp.o", "cosf")]:
        sys.exit("the check does not find what it looks for")
    faults = [f"{name} calls {function}: call windrow::numerics::{function} (fluid/portable_math.h)" for library in sys.argv[1:]
              for name, function in calls(subprocess.run(["nm", "-u", library], stdout=subprocess.PIPE, text=True, check=True).stdout)]
    print("\n".join(faults) or "no call")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
