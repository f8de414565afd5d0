"""Open3D's names over pointloom: `import pointloom.open3d as o3d` runs scripts that were written for Open3D.

Objects are Open3D's, changed in place by their methods and by what is written into their arrays; each holds one of
pointloom's, which does the work: `cloud._ours` of a `geometry.PointCloud` is a `loom.PointCloud`. Names that are not
here are errors that say how it is done in pointloom (docs/adr/0030-open3d-objects-over-ours.md).

Modules are loaded when they are first used, as in `pointloom` itself.
"""

from ..public_names import attach, tell_unknown_modules  # pyright: ignore[reportMissingImports]

__version__ = "0.20.0"  # of the Open3D whose names these are; pointloom.__version__ is that of pointloom
__getattr__, __dir__ = attach(__name__)
tell_unknown_modules()
