"""simplify_quadric_decimation of a scanned surface and of one that is computed, beside the libraries that do it.

These are Open3D, the two wrappers of Fast-Quadric-Mesh-Simplification (fast-simplification and pyfqmr, both with their
default aggressiveness) and, where it is installed, meshoptimizer. Of them Open3D alone keeps its edges in a queue by
cost; the others collapse what is below a threshold that grows, and end further from the whole surface. All but ours run
on one core. Open3D's result depends on the unit of length; it is given millimeters, in which it is at its best.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import real_scans
from contest import OURS, Contestant, Operation, load_open3d, timed, waiting
from mesh_scenes import Arrays, in_open3d, in_pointloom, scene_in_open3d, wavy_mesh

BUNNY = "reg-bunny-scans/reconstruction/bun_zipper.ply"
SAMPLES = 100_000  # of a surface, of which the distance to the other is measured
WORSE = 1.1  # times the peer's distance is allowed


@dataclass(frozen=True)
class Thinning:
    """A mesh, and how many triangles are to be left."""

    arrays: Arrays
    target: int


def bunny(target: int) -> Thinning:
    import pointloom as loom

    mesh = loom.read_triangle_mesh(real_scans.folder() / BUNNY)
    return Thinning((mesh.vertices * 1000, mesh.triangles), target)


def wavy(cells: int, share: float) -> Thinning:
    vertices, triangles = wavy_mesh(cells)
    return Thinning((vertices * 1000 / np.ptp(vertices), triangles), int(share * len(triangles)))


def prepare_pointloom(scene: Thinning, device: str) -> Any:
    mesh = in_pointloom(scene.arrays, device)
    return waiting(lambda: (scene, mesh.simplify_quadric_decimation(scene.target)), device, "warp")


def prepare_open3d(scene: Thinning, device: str) -> Any:
    mesh = in_open3d(scene.arrays)
    return lambda: (scene, mesh.simplify_quadric_decimation(scene.target))


def prepare_fast_simplification(scene: Thinning, device: str) -> Any:
    import fast_simplification

    vertices, triangles = (values.copy() for values in scene.arrays)
    return lambda: (scene, fast_simplification.simplify(vertices, triangles, target_count=scene.target))


def prepare_pyfqmr(scene: Thinning, device: str) -> Any:
    import pyfqmr

    vertices, triangles = (values.copy() for values in scene.arrays)

    def simplify() -> Any:
        simplifier = pyfqmr.Simplify()
        simplifier.setMesh(vertices, triangles)
        simplifier.simplify_mesh(target_count=scene.target, aggressiveness=7, preserve_border=False, verbose=False)
        return scene, simplifier.getMesh()[:2]

    return simplify


def prepare_meshoptimizer(scene: Thinning, device: str) -> Any:
    import meshoptimizer

    vertices = scene.arrays[0].astype(np.float32)
    indices = np.ascontiguousarray(scene.arrays[1], np.uint32).ravel()

    def simplify() -> Any:
        left = np.empty_like(indices)  # no error is too large: the count alone ends it
        count = meshoptimizer.simplify(left, indices, vertices, target_index_count=3 * scene.target, target_error=1.0)
        return scene, (vertices, left[:count].reshape(-1, 3))

    return simplify


def facts(result: tuple[Thinning, Any]) -> tuple[Thinning, Arrays]:
    scene, mesh = result
    if isinstance(mesh, tuple):
        return scene, (np.asarray(mesh[0], np.float64), np.asarray(mesh[1], np.int32))
    return scene, (np.asarray(mesh.vertices), np.asarray(mesh.triangles))


def samples(arrays: Arrays) -> np.ndarray:
    """Points of a surface, evenly spread."""
    return in_pointloom(arrays, "cpu").sample_points_uniformly(SAMPLES, seed=1).points


def rms_between(arrays: Arrays, points: np.ndarray) -> float:
    """The root of the mean squared distance of points from a surface."""
    queries = load_open3d().core.Tensor(points.astype(np.float32))
    distances = scene_in_open3d(arrays).compute_distance(queries).numpy().astype(np.float64)
    return float(np.sqrt((distances**2).mean()))


def check(ours: tuple[Thinning, Arrays], theirs: tuple[Thinning, Arrays], peer: str) -> None:
    """The target is reached, and our surface is hardly further from the whole one, either way."""
    scene, mine = ours
    other = theirs[1]
    for triangles in (mine[1], other[1]):
        assert scene.target - 1 <= len(triangles) <= scene.target, f"{len(triangles)} triangles for {scene.target}"
    whole = samples(scene.arrays)
    to_whole = [rms_between(arrays, whole) for arrays in (mine, other)]
    assert to_whole[0] <= WORSE * to_whole[1], f"rms {to_whole[0]:.4g} from the whole surface, {peer} {to_whole[1]:.4g}"
    back = [rms_between(scene.arrays, samples(arrays)) for arrays in (mine, other)]
    assert back[0] <= WORSE * back[1], f"rms {back[0]:.4g} of the thin surface, {peer} {back[1]:.4g}"


def scenes() -> dict[str, Callable[[], Thinning]]:
    return {
        "bunny 69k to 7k": partial(bunny, 7000),
        "bunny 69k to 2k": partial(bunny, 2000),
        "wavy 1M to 100k": partial(wavy, 465, 0.1),
    }


DECIMATION = Operation(
    name="decimation",
    scenes=scenes(),
    quick={"wavy": partial(wavy, 40, 0.2)},
    contestants=(
        Contestant(OURS, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
        Contestant("fast-simplification", prepare_fast_simplification, facts),
        Contestant("pyfqmr", prepare_pyfqmr, facts),
        Contestant("meshoptimizer", prepare_meshoptimizer, facts),
    ),
    check=check,
)
OPERATIONS = (DECIMATION,)


@timed(DECIMATION)
def test_decimation(turn) -> None:
    turn()
