"""The operations of digests.py that render."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from digest_scenes import loom

SIZE = (96, 72)


def drawn(geometries: Any, **options: Any) -> list[Any]:
    """An image and its depth."""
    picture, depth = loom().render(geometries, size=SIZE, depth=True, **options)
    return [np.asarray(picture), depth]


def scene_of(d: Any) -> list[Any]:
    """A cloud, a mesh, lines and a camera."""
    box = d.surface.box
    corners = np.asarray(box.get_box_points())
    lines = loom().LineSet(corners, [[0, 1], [1, 2], [2, 3], [4, 5]])
    return [d.surface.cloud, d.ball, box, lines]


def splats_of(d: Any) -> Any:
    """Splats of a cloud."""
    cloud, rng = d.surface.facing.remove_non_finite_points(), np.random.default_rng(0)
    count = len(cloud)
    shape = [np.exp(rng.normal(-3, 0.5, (count, 3))), rng.normal(size=(count, 4)), rng.uniform(0.01, 0.99, count)]
    return loom().GaussianSplats(cloud.points, *shape, rng.normal(0, 0.5, (count, 9, 3)), device=cloud.device)


def rendered_splats(d: Any) -> list[Any]:
    """Rendered splats of a cloud, alone and together with others."""
    splats, camera = splats_of(d), loom().PinholeCameraIntrinsic(*SIZE, 80.0, 80.0, 47.5, 35.5)
    T = np.eye(4)
    T[:3, 3] = -splats.get_center() + [0, 0, 2]
    image = splats.rasterize(camera, T)
    picture = loom().render([splats, d.ball], size=SIZE, background="transparent")
    return [image.color, image.opacity, image.depth, image.median_depth, image.normals, np.asarray(picture)]


def map_of(d: Any) -> list[Any]:
    """Orthographic maps of the ball by vertex colors, in UTM, and of a sheet with two textures."""
    ball, rng = d.ball.compute_vertex_normals(), np.random.default_rng(0)
    ball.vertex_colors = np.abs(ball.vertex_normals)
    side = float(np.ptp(ball.vertices[:, 0])) / 40
    sheet = loom().TriangleMesh(
        [[0, 0, 0], [9, 0, 1], [9, 9, 2], [0, 9, 1]], [[0, 1, 2], [0, 2, 3]], triangle_uvs=rng.random((6, 2)),
        triangle_material_ids=[1, 0], textures=list(rng.integers(0, 256, (2, 16, 16, 3), np.uint8)), device=d.device,
    )  # fmt: skip
    maps = [
        loom().meshing.orthophoto(ball, side, frame=loom().WorldFrame(47.5, 8.25)),
        loom().meshing.orthophoto(sheet, 0.3),
    ]
    return [[each.colors, each.heights.values] for each in maps]


DRAWN: dict[str, Callable[[Any], Any]] = {
    "render, cloud": lambda d: [drawn(d.surface.facing), drawn(d.surface.cloud, point_size=3, background="black")],
    "render, values": lambda d: drawn(
        {"geometry": d.surface.cloud, "color_by": "height", "name": "heights"}, color_bar=True, legend=True
    ),
    "render, mesh": lambda d: [drawn(d.ball, shading=kind) for kind in ("smooth", "flat")],
    "render, see-through": lambda d: drawn(
        [{"geometry": d.ball, "opacity": 0.4}, d.surface.cloud], background="transparent"
    ),
    "splats, drawn": lambda d: rendered_splats(d),
    "orthophoto": lambda d: map_of(d),
    "render, scene": lambda d: drawn(
        scene_of(d), labels=[("here", [0, 0, 0])], mesh_show_wireframe=True, scale_bar=True
    ),
}
