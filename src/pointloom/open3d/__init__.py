"""Open3D's names over pointloom: `import pointloom.open3d as o3d` runs scripts written for Open3D.

Objects behave as in Open3D (changed in place) and wrap pointloom objects: `cloud._native` of a `geometry.PointCloud` is
a `loom.PointCloud`. Missing names raise errors that name pointloom's equivalent
(docs/adr/0030-open3d-objects-over-ours.md). Modules are loaded on first use.
"""

from ..public_names import attach, report_unknown_modules  # pyright: ignore[reportMissingImports]

__version__ = "0.20.0"  # version of the Open3D API; pointloom.__version__ is that of pointloom
__getattr__, __dir__ = attach(__name__)
report_unknown_modules()
