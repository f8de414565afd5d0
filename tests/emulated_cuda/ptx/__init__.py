"""PTX to C: what NVRTC makes of a module, as C functions of one thread that gcc compiles."""

from .module import Kernel, Translation, UnknownPtx, translate

__all__ = ["Kernel", "Translation", "UnknownPtx", "translate"]
