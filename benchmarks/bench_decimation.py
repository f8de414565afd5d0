"""simplify_quadric_decimation of a scanned surface and of a computed one, beside other libraries.

The baselines are Open3D, the two wrappers of Fast-Quadric-Mesh-Simplification (fast-simplification and pyfqmr, both
with default aggressiveness) and, if installed, meshoptimizer. Only Open3D keeps its edges in a queue sorted by cost.
The others collapse edges below a growing threshold, and their results are farther from the full surface. The distances
of both results are printed with each check. All baselines run on one core. Open3D's result depends on the unit of
length; it gets millimeters, which give its best result.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import real_scans
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed, waiting
from mesh_scenes import Arrays, in_open3d, in_pointloom, scene_in_open3d, wavy_mesh
from reasons import ROUNDS

BUNNY = "reg-bunny-scans/reconstruction/bun_zipper.ply"
SAMPLES = 100_000  # samples of a surface, whose distance to the other surface is measured
WORSE = 1.1  # maximum ratio to the baseline's distance


@dataclass(frozen=True)
class Thinning:
    """A mesh, and the target number of triangles."""

    arrays: Arrays
    target: int


def bunny(target: int) -> Thinning:
    import pointloom as loom

    mesh = loom.read_triangle_mesh(real_scans.folder() / BUNNY)
    return Thinning((mesh.vertices * 1000, mesh.triangles), target)


def wavy(cells: int, fraction: float) -> Thinning:
    vertices, triangles = wavy_mesh(cells)
    return Thinning((vertices * 1000 / np.ptp(vertices), triangles), int(fraction * len(triangles)))


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
        left = np.empty_like(indices)  # no error limit: only the count stops it
        count = meshoptimizer.simplify(left, indices, vertices, target_index_count=3 * scene.target, target_error=1.0)
        return scene, (vertices, left[:count].reshape(-1, 3))

    return simplify


def facts(result: tuple[Thinning, Any]) -> tuple[Thinning, Arrays]:
    scene, mesh = result
    if isinstance(mesh, tuple):
        return scene, (np.asarray(mesh[0], np.float64), np.asarray(mesh[1], np.int32))
    return scene, (np.asarray(mesh.vertices), np.asarray(mesh.triangles))


def samples(arrays: Arrays) -> np.ndarray:
    """Sample points evenly on a surface."""
    return in_pointloom(arrays, "cpu").sample_points_uniformly(SAMPLES, seed=1).points


def rms_between(arrays: Arrays, points: np.ndarray) -> float:
    """Root mean squared distance of points from a surface."""
    queries = load_open3d().core.Tensor(points.astype(np.float32))
    distances = scene_in_open3d(arrays).compute_distance(queries).numpy().astype(np.float64)
    return float(np.sqrt((distances**2).mean()))


def check(actual: tuple[Thinning, Arrays], reference: tuple[Thinning, Arrays], peer: str) -> None:
    """Print the RMS distances of both results in both directions. Check that the target count is reached and that
    pointloom's distances are not larger.
    """
    scene, mesh = actual
    results = {POINTLOOM: mesh, peer: reference[1]}
    for arrays in results.values():
        count = len(arrays[1])
        assert scene.target - 1 <= count <= scene.target, f"{count} triangles for {scene.target}"
    surface = samples(scene.arrays)
    errors = {name: rms_between(arrays, surface) for name, arrays in results.items()}
    back = {name: rms_between(scene.arrays, samples(arrays)) for name, arrays in results.items()}
    for name in results:
        print(
            f"    {name:20} rms from the full surface {errors[name]:.4g}, from the simplified one {back[name]:.4g}",
            file=sys.stderr,
        )
    for distances in (errors, back):
        assert distances[POINTLOOM] <= WORSE * distances[peer], distances


def scenes() -> dict[str, Callable[[], Thinning]]:
    return {
        "wavy 1k to 300": partial(wavy, 16, 0.25),
        "bunny 69k to 7k": partial(bunny, 7000),
        "bunny 69k to 2k": partial(bunny, 2000),
        "wavy 1M to 100k": partial(wavy, 465, 0.1),
    }


INDEPENDENT_EDGES = (
    "fast-simplification collapses all edges below a growing threshold, with 1.0 to 1.15 times the "
    "RMS distance. Here each round takes an independent set of the cheapest edges, about one in ten "
    "of those it looks at. Of the time on one core, 25 to 30 % is their selection and 15 to 22 % "
    "costs of edges."
)
DECIMATION = Operation(
    name="decimation",
    scenes=scenes(),
    quick={"wavy": partial(wavy, 40, 0.2)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
        Contestant("fast-simplification", prepare_fast_simplification, facts),
        Contestant("pyfqmr", prepare_pyfqmr, facts),
        Contestant("meshoptimizer", prepare_meshoptimizer, facts),
    ),
    check=check,
    targets={"bunny 69k to 7k": 1.2, "bunny 69k to 2k": 1.2, "wavy 1M to 100k": 1.2},
    reasons={
        "wavy 1k to 300": ROUNDS,
        "bunny 69k to 7k": INDEPENDENT_EDGES,
        "bunny 69k to 2k": INDEPENDENT_EDGES,
        "wavy 1M to 100k": INDEPENDENT_EDGES,
    },
    slow={"wavy 1M to 100k": ("open3d-legacy",)},
)
OPERATIONS = (DECIMATION,)


@timed(DECIMATION)
def test_decimation(time_lap) -> None:
    time_lap()
