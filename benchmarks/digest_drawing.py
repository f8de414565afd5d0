"""The operations of digests.py that draw."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from digest_scenes import loom

SIZE = (96, 72)


def drawn(geometries: Any, **options: Any) -> list[Any]:
    """A picture and its depths."""
    picture, depth = loom().render(geometries, size=SIZE, depth=True, **options)
    return [np.asarray(picture), depth]


def scene_of(d: Any) -> list[Any]:
    """A cloud, a mesh, lines and a camera."""
    box = d.surface.box
    corners = np.asarray(box.get_box_points())
    lines = loom().LineSet(corners, [[0, 1], [1, 2], [2, 3], [4, 5]])
    return [d.surface.cloud, d.ball, box, lines]


DRAWN: dict[str, Callable[[Any], Any]] = {
    "render, cloud": lambda d: [drawn(d.surface.facing), drawn(d.surface.cloud, point_size=3, background="black")],
    "render, values": lambda d: drawn(
        {"geometry": d.surface.cloud, "color_by": "height", "name": "heights"}, color_bar=True, legend=True
    ),
    "render, mesh": lambda d: [drawn(d.ball, shading=kind) for kind in ("smooth", "flat")],
    "render, see-through": lambda d: drawn(
        [{"geometry": d.ball, "opacity": 0.4}, d.surface.cloud], background="transparent"
    ),
    "render, scene": lambda d: drawn(
        scene_of(d), labels=[("here", [0, 0, 0])], mesh_show_wireframe=True, scale_bar=True
    ),
}
