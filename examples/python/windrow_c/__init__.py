"""The whole C interface. Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit."""
from .air import *
from .bodies import *
from .plants import *
from .device import *


def bind(library):
    """Sets the types of each function of a loaded library."""
    for name, result, *arguments in AIR + BODIES + PLANTS + DEVICE:
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library
