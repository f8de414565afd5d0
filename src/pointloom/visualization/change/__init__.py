"""Change detection between two epochs of a surface, and its images.

`m3c2` compares two clouds along the surface normal, `cloud_to_mesh` a cloud with a mesh; `paint` and `draw` show
significant changes and draw noise in gray. Names are loaded on first use.

Example:
    >>> import numpy as np, pointloom as loom
    >>> rng = np.random.default_rng(0)
    >>> before, after = (loom.PointCloud(rng.random((5_000, 3)) * (10, 10, 0.02)) for _ in range(2))
    >>> found = loom.change.m3c2(before, after, normal_radii=1, cylinder_radius=1, max_distance=1)
    >>> loom.change.draw(before, found, size=(400, 300)).shape
    (300, 400, 3)
"""

from ...public_names import attach  # pyright: ignore[reportMissingImports]

__getattr__, __dir__ = attach(__name__)
