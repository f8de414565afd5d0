"""Textures of synthetic scenes with known colors: steps at seams, and errors, with and without leveling.

    python benchmarks/texture_seams.py [--scene owl] [--device cpu]

The images are renderings of a mesh with known colors, each with its own exposure (0.8 to 1.2), vignetting (a quarter at
the corners) and noise of 1 of 255; the given poses have errors of 0.05 degrees and a thousandth of the distance.
Contestants are the mean over images (`project_images_to_albedo` on xatlas's charts), and `texture_from_images` with
parts and all of its leveling.

A step is the color difference across an edge of the mesh whose sides are at different positions of the texture, at
eight
points of each such edge, bilinear, as the mean of three channels. An error is that of the texture at 20,000 points
of the
surface, after one global gain. Sharpness is the contrast of the texture over 1.5 texels along a triangle edge at
each of
these points, relative to that of the known colors: the sum of products of both contrasts divided by the sum of
squares of
the known ones, 1 without blur; in total, and for triangles with a corner on a seam. Times are CPU seconds; the first
includes compilation.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import pointloom as loom

SAMPLES = 8  # per edge
POINTS = 20_000
ACROSS = 1.5  # texels over which contrast is measured
SIZE = 2048
Colors = Callable[[NDArray[np.float64]], NDArray[np.float64]]


@dataclass
class Scene:
    """A mesh, its color function, images of it, and approximate poses."""

    name: str
    mesh: Any
    colors: Colors
    images: list[NDArray[np.uint8]]
    camera: Any
    extrinsics: list[NDArray[np.float64]]


def painted(length: float) -> Colors:
    """Colors that vary over a length [m], over a quarter of it, and at sharp lines."""

    def colors(p: NDArray[np.float64]) -> NDArray[np.float64]:
        x, y, z = np.moveaxis(np.asarray(p, np.float64) * (2 * np.pi / length), -1, 0)
        slow = np.sin(x + 0.7 * y) + np.cos(y - 0.4 * z) + np.sin(z + 0.3 * x)
        fine = np.sin(4 * x + z) * np.cos(3.7 * y - x) + np.sin(4.3 * z + y)
        line = np.tanh(6 * np.sin(0.9 * x + 0.5 * y + 0.8 * z))
        shades = [0.45 + 0.08 * slow + 0.05 * fine + 0.08 * line, 0.42 - 0.07 * slow + 0.05 * fine]
        return np.stack([*shades, 0.40 + 0.05 * np.sin(x - z) - 0.05 * fine - 0.06 * line], -1)

    return colors


def owl() -> Scene:
    """The owl from 16 positions around it."""
    mesh = loom.datasets.object_mesh().simplify_quadric_decimation(20_000)
    poses = ring(16, 0.6, (0.15, 0.7))
    return photographed(
        "owl", mesh, painted(0.08), poses, 0.6, loom.PinholeCameraIntrinsic(640, 480, 720, 720, 319.5, 239.5)
    )


def room() -> Scene:
    """The furnished room from 24 positions inside."""
    from pointloom.datasets.scenes.room import round_pose

    poses = np.array([round_pose(k / 24) for k in range(24)])
    return photographed(
        "room",
        loom.datasets.room_mesh(),
        painted(0.5),
        poses,
        2.0,
        loom.PinholeCameraIntrinsic(640, 480, 400, 400, 319.5, 239.5),
    )


SCENES = {"owl": owl, "room": room}


def ring(count: int, distance: float, heights: tuple[float, ...]) -> NDArray[np.float64]:
    from pointloom.datasets.made import views

    return views.ring(count, distance, heights)


def photographed(
    name: str, mesh: Any, colors: Colors, poses: NDArray[np.float64], distance: float, camera: Any
) -> Scene:
    """Images of a mesh with individual exposures, vignetting and noise, and slightly wrong poses."""
    rng, scene = np.random.default_rng(0), loom.RaycastingScene()
    scene.add_triangles(mesh.vertices.astype(np.float32), mesh.triangles)
    v, u = np.mgrid[: camera.height, : camera.width]
    rays = np.stack([(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, np.ones(u.shape)], -1)
    far = ((rays[..., :2] ** 2).sum(-1) / (rays[0, 0, :2] ** 2).sum())[..., None]
    images, extrinsics = [], []
    for T in poses:
        directions = rays @ T[:3, :3].T
        distances = scene.cast_rays(np.concatenate([np.broadcast_to(T[:3, 3], directions.shape), directions], -1))[
            "t_hit"
        ]
        mask = np.isfinite(distances)[..., None]
        shade = colors(T[:3, 3] + directions * np.where(mask, distances[..., None], 0.0)) * mask
        exposed = shade * rng.uniform(0.8, 1.2) * (1 - 0.25 * far) * 255 + rng.normal(0, 1, shade.shape)
        images.append(np.clip(np.rint(exposed), 0, 255).astype(np.uint8))
        extrinsics.append(shaken(rng, distance) @ np.linalg.inv(T))
    return Scene(name, mesh, colors, images, camera, extrinsics)


def shaken(rng: np.random.Generator, distance: float) -> NDArray[np.float64]:
    """A small random motion: 0.05 degrees and a thousandth of the distance (standard deviations per axis)."""
    T, (a, b, c) = np.eye(4), rng.normal(0, np.radians(0.05), 3)
    cross = np.array([[0, -c, b], [c, 0, -a], [-b, a, 0]])
    left, _, right = np.linalg.svd(np.eye(3) + cross)
    T[:3, :3], T[:3, 3] = left @ right, rng.normal(0, 0.001 * distance, 3)
    return T


def texture_at(image: NDArray[np.uint8], uvs: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bilinear colors at texture coordinates [n, 2], 0..255."""
    height, width = image.shape[:2]
    x = np.clip(uvs[:, 0] * width - 0.5, 0, width - 1)
    y = np.clip((1 - uvs[:, 1]) * height - 0.5, 0, height - 1)
    i, j = np.minimum(x.astype(int), width - 2), np.minimum(y.astype(int), height - 2)
    s, t, p = (x - i)[:, None], (y - j)[:, None], image.astype(np.float64)
    upper = p[j, i] * (1 - s) + p[j, i + 1] * s
    return upper * (1 - t) + (p[j + 1, i] * (1 - s) + p[j + 1, i + 1] * s) * t


def seam_steps(mesh: Any, shown: NDArray[np.bool_] | None = None) -> NDArray[np.float64]:
    """Color steps across edges whose sides are at different positions of the texture, 0..255.

    Args:
        mesh: With one texture and merged vertices.
        shown: Selected triangles, bool [t]; None for all.
    """
    triangles, uvs = np.asarray(mesh.triangles), np.asarray(mesh.triangle_uvs, np.float64).reshape(-1, 3, 2)
    keep = np.ones(len(triangles), bool) if shown is None else shown
    begin, end = triangles[:, [0, 1, 2]].reshape(-1), triangles[:, [1, 2, 0]].reshape(-1)
    at_begin, at_end = uvs[:, [0, 1, 2]].reshape(-1, 2), uvs[:, [1, 2, 0]].reshape(-1, 2)
    low = begin < end
    keys = np.where(low, begin, end).astype(np.int64) * (triangles.max() + 1) + np.where(low, end, begin)
    first, last = np.where(low[:, None], at_begin, at_end), np.where(low[:, None], at_end, at_begin)
    order = np.argsort(keys, kind="stable")
    order = order[np.repeat(keep, 3)[order]]
    pairs = np.flatnonzero(keys[order][1:] == keys[order][:-1])
    rows, other_rows = order[pairs], order[pairs + 1]
    is_seam = (np.abs(first[rows] - first[other_rows]) + np.abs(last[rows] - last[other_rows])).max(1) > 1e-6
    rows, other_rows, steps = rows[is_seam], other_rows[is_seam], []
    for k in range(SAMPLES):
        fraction = (k + 0.5) / SAMPLES
        colors = [
            texture_at(mesh.textures[0], first[h] * (1 - fraction) + last[h] * fraction) for h in (rows, other_rows)
        ]
        steps.append(np.abs(colors[0] - colors[1]).mean(1))
    return np.concatenate(steps) if len(rows) else np.zeros(0)


def samples_on(mesh: Any, shown: NDArray[np.bool_]) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Evenly distributed points on the selected triangles, as rows and barycentric coordinates."""
    rng, triangles = np.random.default_rng(1), np.asarray(mesh.triangles)
    corners = np.asarray(mesh.vertices)[triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) * shown
    rows = rng.choice(len(triangles), POINTS, p=areas / areas.sum())
    return rows, rng.dirichlet((1, 1, 1), POINTS)


def colors_on(
    mesh: Any, colors: Colors, rows: NDArray[np.int64], fractions: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Colors of the texture and known colors at points, 0..255."""
    corners = np.asarray(mesh.vertices)[np.asarray(mesh.triangles)[rows]]
    uvs = np.asarray(mesh.triangle_uvs, np.float64).reshape(-1, 3, 2)[rows]
    points, texture_uvs = (corners * fractions[..., None]).sum(1), (uvs * fractions[..., None]).sum(1)
    return texture_at(mesh.textures[0], texture_uvs), 255 * colors(points)


def color_errors(mesh: Any, colors: Colors, shown: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Errors of the texture at points of the selected triangles, 0..255, after one gain."""
    texture_colors, truth = colors_on(mesh, colors, *samples_on(mesh, shown))
    return np.abs(texture_colors * ((texture_colors * truth).sum() / (texture_colors**2).sum()) - truth).mean(1)


def sharpness(mesh: Any, colors: Colors, shown: NDArray[np.bool_]) -> float:
    """Contrast of the texture over `ACROSS` texels, relative to that of the known colors; nan without points."""
    if not shown.any():
        return float("nan")
    rows, fractions = samples_on(mesh, shown)
    uvs = np.asarray(mesh.triangle_uvs, np.float64).reshape(-1, 3, 2)[rows] * mesh.textures[0].shape[0]
    length = np.linalg.norm(uvs[:, 1] - uvs[:, 0], axis=1)
    moved = fractions + (ACROSS / np.maximum(length, ACROSS))[:, None] * np.array([-1.0, 1.0, 0.0])
    inside = (moved >= 0).all(1)
    colors_here, colors_moved = (colors_on(mesh, colors, rows[inside], part[inside]) for part in (fractions, moved))
    drawn, known = colors_moved[0] - colors_here[0], colors_moved[1] - colors_here[1]
    return float((drawn * known).sum() / (known**2).sum())


def beside_seams(mesh: Any, views: NDArray[np.int32]) -> NDArray[np.bool_]:
    """Triangles with a source image and a corner shared with another image."""
    triangles, count = np.asarray(mesh.triangles), len(np.asarray(mesh.vertices))
    lowest, highest = np.full(count, 1 << 30), np.full(count, -1)
    for k in range(3):
        np.minimum.at(lowest, triangles[views >= 0, k], views[views >= 0])
        np.maximum.at(highest, triangles[views >= 0, k], views[views >= 0])
    return (views >= 0) & (lowest < highest)[triangles].any(1)


def measure(scene: Scene, device: str) -> dict[str, Any]:
    """The meshes of all contestants, with a printed table."""
    mesh, maps = scene.mesh.to(device), loom.meshing
    given = (scene.images, scene.camera, scene.extrinsics)
    variants: dict[str, dict[str, Any]] = {
        "one image each": {"exposures": False, "seam_leveling": False, "local_leveling": False},
        "at one exposure": {"seam_leveling": False, "local_leveling": False},
        "and vertices shifted": {"local_leveling": False},
        "and strips blended": {},
        "without exposures": {"exposures": False},
    }
    meshes, views = {}, np.zeros(0, np.int32)
    print(f"{scene.name}: {len(mesh):,} triangles, {len(scene.images)} images, {mesh.device}")
    figures = f"{'step mean':>11}{'95 %':>7}{'error mean':>12}{'95 %':>7}{'sharp':>7}{'beside':>8}{'seconds':>9}"
    print(f"{'':28}{'charts':>8}{figures}")
    for name, how in variants.items():
        begin = time.process_time()
        result = maps.texture_from_images(mesh, *given, maps.ImageTextureOption(**how), size=SIZE)
        seconds = time.process_time() - begin
        views, meshes[name] = result.views, result.mesh
        _print(name, result.chart_count, result.mesh, scene, views, seconds)
    print(result)
    begin = time.process_time()
    mean = mesh.compute_uvatlas(SIZE, gutter=4).project_images_to_albedo(*given, tex_size=SIZE)
    _print("mean over images", None, mean, scene, views, time.process_time() - begin)
    return meshes | {"mean over images": mean}


def _print(name: str, charts: int | None, mesh: Any, scene: Scene, views: Any, seconds: float) -> None:
    shown = views >= 0
    sharp, beside = (sharpness(mesh, scene.colors, part) for part in (shown, beside_seams(mesh, views)))
    steps, errors = seam_steps(mesh, shown), color_errors(mesh, scene.colors, shown)
    counted = "" if charts is None else f"{charts:,}"
    figures = (
        f"{steps.mean():11.2f}{np.quantile(steps, 0.95):7.2f}{errors.mean():12.2f}{np.quantile(errors, 0.95):7.2f}"
        f"{sharp:7.2f}{beside:8.2f}"
    )
    print(f"{name:28}{counted:>8}{figures}{seconds:9.1f}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scene", choices=[*SCENES, "all"], default="all")
    parser.add_argument("--device", default="cpu")
    chosen = parser.parse_args()
    for name in SCENES if chosen.scene == "all" else [chosen.scene]:
        measure(SCENES[name](), chosen.device)


if __name__ == "__main__":
    main()
