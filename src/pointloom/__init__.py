"""pointloom: point clouds, scans and RGB-D frames to clouds and meshes, with one kernel source for CUDA and CPU.

Operations return new objects: `cloud = cloud.estimate_normals()`. Public names are loaded on first use.
"""

from . import atomic_imports
from .public_names import attach

atomic_imports.install()
__version__ = "0.1.0"
__getattr__, __dir__ = attach(__name__)
