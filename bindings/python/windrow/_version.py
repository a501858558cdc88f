"""Made by ./dev schema from fluid/version.h. Do not edit."""
__version__ = "0.1.0"
