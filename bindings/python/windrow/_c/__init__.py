"""The whole C interface. Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit."""
from typing import Any

from .air import *
from .bodies import *
from .operators import *
from .plants import *
from .device import *


def bind(library: Any) -> Any:
    """Sets the types of each function of a loaded library."""
    for name, result, *arguments in AIR + BODIES + OPERATORS + PLANTS + DEVICE:
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library
