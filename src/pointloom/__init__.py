"""pointloom: point clouds, scans and RGB-D frames to clouds and meshes, on one kernel source for CUDA and CPU cores.

Operations return what they make and change nothing in place: `cloud = cloud.estimate_normals()`.

`import pointloom as loom` starts no runtime: each public name is loaded when it is first used.
"""

from .public_names import attach

__version__ = "0.1.0"
__getattr__, __dir__ = attach(__name__)
