"""A mesh colored by its distances from another, with color bar and histogram: `draw_errors`."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...core.units import symbol_of
from ...kernels.drawing.value_colors import Ramp, color_values
from ...kernels.lang import float32
from ...kernels.memory import download, upload
from ...meshing.mesh.mesh import TriangleMesh
from .canvas import Canvas
from .coloring import Coloring
from .colormaps import MISSING_COLOR, colormap_table
from .legends import draw_color_bar
from .plots import error_histogram
from .render import render

COLORMAP = "viridis"  # as in `TriangleMesh.compute_error_map`
BACKGROUND_COLOR = (0.88, 0.89, 0.91)
_IMAGE_WIDTH, _IMAGE_HEIGHT = 1600, 900  # [px] of the image
_MESH_WIDTH, _BAR_WIDTH = 860, 140  # [px] width of the mesh, and of the color bar at its right
_LAST_COLOR_QUANTILE = 0.98  # quantile of the vertices at the last color: outliers must not compress the colors


def draw_errors(
    mesh: TriangleMesh, distances: NDArray[np.float32], title: str, *, back_faces: bool = True
) -> NDArray[np.uint8]:
    """Render a mesh colored by distances (n,) [m] at its vertices (non-finite: gray), with a histogram.

    Returns uint8 (900, 1600, 3).
    """
    finite = distances[np.isfinite(distances)].astype(np.float64)
    largest = float(np.quantile(finite, _LAST_COLOR_QUANTILE)) if len(finite) else 0.0
    limits = 0.0, largest or float(finite.max(initial=0.0)) or 1.0
    device = mesh.device
    ramp = Ramp(colormap_table(COLORMAP), limits, MISSING_COLOR, device)
    colors = color_values(upload(distances, float32, device), ramp)
    colored = mesh.copy()
    colored.vertex_colors = download(colors)
    image = render(
        {"geometry": colored, "shaded": True, "back_faces": back_faces},
        size=(_MESH_WIDTH, _IMAGE_HEIGHT),
        background=BACKGROUND_COLOR,
    )
    left = Canvas.blank(_MESH_WIDTH + _BAR_WIDTH, _IMAGE_HEIGHT, BACKGROUND_COLOR, device)
    left.image(image, 0, 0)
    coloring = Coloring(colors, "values", limits, COLORMAP, has_missing=len(finite) < len(distances))
    label = f"distance [{symbol_of(mesh.unit)}]"
    draw_color_bar(left, coloring, label)
    size = _IMAGE_WIDTH - left.width, _IMAGE_HEIGHT
    bars = error_histogram(distances, size, title=title, label=label, colormap=COLORMAP, limit=limits[1])
    return np.hstack([left.to_numpy(), bars])
