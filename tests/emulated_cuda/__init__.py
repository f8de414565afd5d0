"""A CUDA device that is none: Warp's CUDA path on a machine without a GPU, for tests. README.md beside says how."""

from .findings import CudaFault
from .install import EmulationError, install, installed
from .settings import settings

__all__ = ["CudaFault", "EmulationError", "install", "installed", "settings"]
