"""Images of 1280 x 960 pixels of clouds and of a mesh, beside Open3D's legacy Visualizer off screen.

Open3D keeps the geometry on the drawing device (without a GPU: Mesa's software renderer) and redraws it. pointloom uses
the arrays of a cloud or mesh. Both times are per image, including the read-back.
"""

from __future__ import annotations

from functools import cache, partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed
from mesh_scenes import wavy_mesh
from numpy.typing import NDArray
from reasons import CALL

Scene = tuple[NDArray[np.float32], NDArray[np.int32] | None, tuple[int, int]]

CAMERA = {"front": [0.3, 0.5, 0.6], "up": [0.0, 1.0, 0.0], "zoom": 0.55}
POINT_SIZE = 2.0  # [px]
WHITE = 250


@cache
def cloud_scene(count: int, size: tuple[int, int] = (1280, 960)) -> Scene:
    """Points on a wavy square in random order."""
    rng = np.random.default_rng(0)
    x, z = rng.uniform(-4, 4, (2, count)).astype(np.float32)
    return np.column_stack([x, 0.5 * np.sin(2 * x) * np.cos(2 * z), z]), None, size


@cache
def mesh_scene(cells: int, size: tuple[int, int] = (1280, 960)) -> Scene:
    """A wavy mesh."""
    vertices, triangles = wavy_mesh(cells)
    return np.asarray(vertices, np.float32), np.array(triangles, np.int32), size


def prepare_pointloom(scene: Scene, device: str) -> Any:
    import pointloom as loom

    points, triangles, size = scene
    if triangles is None:
        cloud = loom.PointCloud(points, colors=shades(points), device=device)
        return partial(loom.render, cloud, CAMERA, size, point_size=POINT_SIZE)
    mesh = loom.TriangleMesh(points, triangles, device=device).compute_vertex_normals()
    return partial(loom.render, mesh, CAMERA, size)


def prepare_open3d(scene: Scene, device: str) -> Any:
    o3d = load_open3d()
    points, triangles, (width, height) = scene
    vectors = o3d.utility.Vector3dVector(points.astype(np.float64))
    if triangles is None:
        geometry = o3d.geometry.PointCloud(vectors)
        geometry.colors = o3d.utility.Vector3dVector(shades(points).astype(np.float64))
    else:
        geometry = o3d.geometry.TriangleMesh(vectors, o3d.utility.Vector3iVector(triangles.copy()))
        geometry.compute_vertex_normals()
    window = o3d.visualization.Visualizer()
    with o3d.utility.VerbosityContextManager(o3d.utility.VerbosityLevel.Error):
        if not window.create_window(visible=False, width=width, height=height):
            raise RuntimeError("Open3D cannot create an off-screen window: EGL is required (libegl1, libgl1-mesa-dri)")
    window.add_geometry(geometry)
    window.get_render_option().point_size = POINT_SIZE
    control = window.get_view_control()
    control.set_lookat((points.min(axis=0) + points.max(axis=0)) / 2)
    for name, value in CAMERA.items():
        getattr(control, f"set_{name}")(value)
    return lambda: np.asarray(window.capture_screen_float_buffer(True))


def shades(points: NDArray[np.float32]) -> NDArray[np.float32]:
    """Colors that are not white."""
    low, high = points.min(axis=0), points.max(axis=0)
    return (0.9 * (points - low) / (high - low)).astype(np.float32)


def facts(image: NDArray[Any]) -> float:
    """Fraction of the image that is covered."""
    values = image if image.dtype == np.uint8 else np.round(255 * image)
    return float((values < WHITE).any(axis=2).mean())


def check(actual: float, reference: float, peer: str) -> None:
    """Check for similar coverage; Open3D's square points have another size."""
    assert 0.1 < actual < 0.9, actual
    assert abs(actual - reference) < 0.1, f"{peer} covers {reference} of the image, pointloom {actual}"


RENDER = Operation(
    name="render",
    scenes={
        "cloud 1k": partial(cloud_scene, 1000, (64, 48)),
        "mesh 1k": partial(mesh_scene, 16, (64, 48)),
        "cloud 1M": partial(cloud_scene, 1_000_000),
        "mesh 200k": partial(mesh_scene, 208),
        "cloud 20M": partial(cloud_scene, 20_000_000),
    },
    quick={"cloud": partial(cloud_scene, 20_000, (160, 120)), "mesh": partial(mesh_scene, 24, (160, 120))},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
    ),
    check=check,
    memory_size="cloud 1M",
    long=("cloud 20M",),
    targets={"cloud 1M": 4, "mesh 200k": 2},
    reasons={
        "cloud 1k": CALL,
        "mesh 1k": CALL,
        "mesh 200k": "Of the time on one core, 41 % is shading and 38 % covering four samples a pixel.",
        "cloud 1M": ("Of the time on one core, 45 % is shading and 26 % marking cells: reads in random order."),
    },
)
OPERATIONS = (RENDER,)


@timed(RENDER)
def test_render(time_lap) -> None:
    time_lap()
