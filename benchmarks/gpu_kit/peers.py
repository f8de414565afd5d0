"""pointloom beside libraries that a GPU machine has anyway: Warp's own geometry, CuPy, torch. Results are compared.

    python -m gpu_kit.peers STATE SECONDS

Data and results of both sides stay on the device. Search structures are built in the call of both sides. In a dry run
Warp's geometry runs on the CPU, because the emulated device lacks its native functions.
"""

from __future__ import annotations

import statistics
import sys
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from gpu_kit import device as devices
from gpu_kit.documents import keep_part, saved_part
from gpu_kit.runner import MORE

ROUNDS, AT_LEAST = 7, 6.0  # timed calls, and seconds to prepare and compile
K = 20  # nearest neighbors
Call = Callable[[], Any]


class Pair(NamedTuple):
    """The same work by pointloom and by a peer, and the comparison: raises AssertionError if the results disagree."""

    own: Call
    other: Call
    compare: Callable[[Any, Any], None]


@dataclass(frozen=True)
class Peer:
    """A peer of an operation.

    Attributes:
        prepare: (size, device) -> the pair of calls. ImportError if a package is missing.
        small: Size in a dry run; 0 if it needs a GPU.
    """

    name: str
    operation: str
    size: int
    small: int
    prepare: Callable[[int, str], Pair]


def cloud(points: np.ndarray, device: str) -> Any:
    import pointloom as loom

    return loom.PointCloud(points, device=device).to(device, arrays="warp")


def host(array: Any) -> np.ndarray:
    """An array of any library as NumPy's."""
    for name in ("numpy", "get"):
        if hasattr(array, name):
            return np.asarray(array.cpu().numpy() if hasattr(array, "cpu") else getattr(array, name)())
    return np.asarray(array)


def similar(own: np.ndarray, other: np.ndarray, limit: float, what: str) -> None:
    """Check that values agree within a limit, except for one in 10,000: ties, and roundings at a border."""
    assert own.shape == other.shape, f"{what}: shapes {own.shape} and {other.shape}"
    with np.errstate(invalid="ignore"):
        differ = np.mean(~((np.abs(own - other) <= limit) | (own == other)))
    assert differ <= 1e-4, f"{what}: {differ:.3%} differ by more than {limit}"


# ------------------------------------------------------------------------------------------------ Warp


def radius_counts(size: int, device: str) -> Pair:
    """Remove points with few neighbors within 2 cm at 200,000 points."""
    import warp as wp
    from contest import anew
    from gpu_operation import spacing_of, surface_of

    from gpu_kit.peer_kernels import count_within

    radius, needed, source = 0.02 * spacing_of(size), 8, cloud(surface_of(size), device)
    points = wp.array(surface_of(size), dtype=wp.vec3, device=device)
    grid, counts = wp.HashGrid(128, 128, 128, device=device), wp.empty(size, dtype=int, device=device)

    def other() -> Any:
        grid.build(points, radius)
        wp.launch(count_within, size, [grid.id, points, radius, counts], device=device)
        return counts

    def compare(own: Any, found: Any) -> None:
        kept = np.zeros(size, int)
        kept[host(own[1])] = 1
        similar(kept, (host(found) > needed).astype(int), 0, "kept points")

    return Pair(lambda: anew(source).remove_radius_outlier(needed, radius), other, compare)


def closest_points(size: int, device: str) -> Pair:
    import warp as wp
    from mesh_scenes import scene_in_pointloom, wavy_mesh

    from gpu_kit.peer_kernels import find_closest, mesh_of

    vertices, triangles = wavy_mesh(128)
    rng = np.random.default_rng(0)
    points = rng.uniform(vertices.min(axis=0), vertices.max(axis=0), (size, 3)).astype(np.float32)
    scene, mesh = scene_in_pointloom((vertices, triangles), device), mesh_of(vertices, triangles, device)
    queries, closest = (wp.array(points, dtype=wp.vec3, device=device) for _ in range(2))
    own_queries = wp.array(points, dtype=float, device=device)

    def other() -> Any:
        wp.launch(find_closest, size, [mesh.id, queries, closest], device=device)
        return closest

    def compare(own: Any, found: Any) -> None:
        distances = [np.linalg.norm(host(each) - points, axis=1) for each in (own["points"], found)]
        similar(*distances, 1e-6 * np.ptp(vertices, axis=0).max(), "distances")

    return Pair(lambda: scene.compute_closest_points(own_queries), other, compare)


def rays(size: int, device: str) -> Pair:
    import warp as wp
    from mesh_scenes import scene_in_pointloom, wavy_mesh

    import pointloom as loom
    from gpu_kit.peer_kernels import cast, mesh_of

    vertices, triangles = wavy_mesh(128)
    middle, extent = (vertices.min(axis=0) + vertices.max(axis=0)) / 2, np.ptp(vertices, axis=0).max()
    eye = middle + extent * np.array([0.2, 0.3, 1.2])
    height = round((size * 3 / 4) ** 0.5)
    given = loom.RaycastingScene.create_rays_pinhole(60, middle, eye, [0, 1, 0], size // height, height).reshape(-1, 6)
    scene, mesh = scene_in_pointloom((vertices, triangles), device), mesh_of(vertices, triangles, device)
    on_device, hits = wp.array(given, dtype=float, device=device), wp.empty(len(given), dtype=float, device=device)

    def other() -> Any:
        wp.launch(cast, len(given), [mesh.id, on_device, hits], device=device)
        return hits

    def compare(own: Any, found: Any) -> None:
        similar(host(own["t_hit"]), host(found), 1e-4 * extent, "distances")

    return Pair(lambda: scene.cast_rays(on_device), other, compare)


def marching_cubes(size: int, device: str) -> Pair:
    """The surface of a field. pointloom shares vertices and separates ambiguous faces, Warp does not."""
    import scenes
    import warp as wp
    from warp.geometry import IsoSurfaceMarchingCubes

    import pointloom as loom

    count = round(size ** (1 / 3))
    field = wp.array(scenes.wavy_ball(count), dtype=float, device=device)
    surface = IsoSurfaceMarchingCubes(count, count, count)

    def other() -> Any:
        surface.surface(field, 0.0)
        return surface.indices

    def compare(own: Any, found: Any) -> None:
        triangles = len(own.triangles), found.size // 3
        assert abs(triangles[0] / triangles[1] - 1) < 0.01, f"{triangles[0]} triangles, Warp {triangles[1]}"

    return Pair(lambda: loom.meshing.marching_cubes(field), other, compare)


# ------------------------------------------------------------------------------------------------ CuPy, torch


def neighbors(points: np.ndarray, device: str, query: Call) -> Pair:
    """The 20 nearest neighbors. `query` returns the distances."""
    from contest import anew

    import pointloom as loom

    source = cloud(points, device)

    def own() -> Any:
        fresh = anew(source)
        return loom.NearestNeighborSearch(fresh).knn_search(fresh, K)

    def compare(result: Any, distances: Any) -> None:  # torch.cdist expands (a - b)^2: up to 2 mm of rounding at 4 m
        similar(np.sqrt(host(result[1]).astype(np.float64)), host(distances).astype(np.float64), 2e-3, "distances")

    return Pair(own, query, compare)


def cupy_tree(size: int, device: str) -> Pair:
    import cupy
    from cupyx.scipy.spatial import KDTree
    from gpu_operation import surface_of

    points = surface_of(size)
    given = cupy.asarray(points, cupy.float32)
    return neighbors(points, device, lambda: KDTree(given).query(given, K)[0])


def cupy_lbvh(size: int, device: str) -> Pair:
    """cupy-knn: a bounding volume hierarchy with sorted queries."""
    import cupy
    from cupy_knn import LBVHIndex
    from gpu_operation import surface_of

    points = surface_of(size)
    given = cupy.asarray(points, cupy.float32)
    index = LBVHIndex(leaf_size=32, compact=True, shrink_to_fit=True, sort_queries=True)
    index.build(given)
    index.prepare_knn_default(K)

    def query() -> Any:
        index.build(given)
        return cupy.sort(cupy.sqrt(index.query_knn(given)[1]), axis=1)

    return neighbors(points, device, query)


def torch_brute_force(size: int, device: str) -> Pair:
    import torch
    from gpu_operation import surface_of

    points = surface_of(size)
    given = torch.as_tensor(points, dtype=torch.float32, device=device)

    def query() -> Any:
        result = torch.cdist(given, given).topk(K, largest=False).values
        torch.cuda.synchronize() if given.is_cuda else None
        return result

    return neighbors(points, device, query)


def torch_fps(size: int, device: str) -> Pair:
    """Farthest points. Both begin with the first point."""
    import torch
    from contest import anew
    from gpu_operation import surface_of
    from torch_fps import farthest_point_sampling

    count, source = 1000, cloud(surface_of(size), device)
    given = torch.as_tensor(surface_of(size), dtype=torch.float32, device=device)[None]
    mask = torch.ones(given.shape[:2], dtype=torch.bool, device=device)

    def other() -> Any:
        result = farthest_point_sampling(given, mask, count, random_start=False, validate=False)[0]
        torch.cuda.synchronize()
        return given[0, result]

    def compare(own: Any, found: Any) -> None:
        from scipy.spatial import cKDTree

        spacings = [cKDTree(each).query(each, k=2)[0][:, 1].min() for each in (np.asarray(own.points), host(found))]
        assert abs(spacings[0] / spacings[1] - 1) < 1e-2, f"{spacings[0]:.5f} m apart, torch-fps {spacings[1]:.5f} m"

    return Pair(lambda: anew(source).farthest_point_down_sample(count), other, compare)


PEERS = (
    Peer("Warp HashGrid", "radius_outliers", 200_000, 3000, radius_counts),
    Peer("Warp HashGrid", "radius_outliers", 1_000_000, 3000, radius_counts),
    Peer("Warp Mesh", "closest_points", 200_000, 1000, closest_points),
    Peer("Warp Mesh", "cast_rays", 1_000_000, 1200, rays),
    Peer("Warp IsoSurfaceMarchingCubes", "marching_cubes", 256**3, 24**3, marching_cubes),
    Peer("CuPy KDTree", "knn20", 200_000, 0, cupy_tree),
    Peer("CuPy KDTree", "knn20", 1_000_000, 0, cupy_tree),
    Peer("cupy-knn", "knn20", 200_000, 0, cupy_lbvh),
    Peer("cupy-knn", "knn20", 1_000_000, 0, cupy_lbvh),
    Peer("torch cdist, topk", "knn20", 10_000, 0, torch_brute_force),
    Peer("torch-fps", "farthest_points", 200_000, 0, torch_fps),
)


def key_of(peer: Peer, size: int = 0) -> str:
    return f"{peer.operation} {size or peer.size} beside {peer.name}"


def seconds_of(pair: Pair, device: str) -> tuple[list[float], list[float]]:
    """Seconds of some synchronized calls of both sides, in turn: clocks and temperature change during a run."""
    import warp as wp

    seconds: tuple[list[float], list[float]] = [], []
    for _ in range(1 if devices.is_dry() else ROUNDS):
        for call, times in zip((pair.own, pair.other), seconds, strict=True):
            wp.synchronize_device(device)
            start = time.perf_counter()
            result = call()
            wp.synchronize_device(device)  # the context of all libraries: cudaDeviceSynchronize
            times.append(time.perf_counter() - start)
            del result
    return seconds


def measured(peer: Peer, size: int, device: str) -> dict[str, Any]:
    """Times of both sides after their results were compared; or why there are none."""
    try:
        pair = peer.prepare(size, device)
        pair.compare(pair.own(), pair.other())
        own, other = seconds_of(pair, device)
    except ImportError as error:
        return {"skipped": str(error)}
    except Exception as error:
        traceback.print_exc(limit=4)
        return {"error": f"{type(error).__name__}: {str(error)[:300]}"}
    names = {"best_ms": min, "median_ms": statistics.median}
    return {name: {"pointloom": 1e3 * best(own), peer.name: 1e3 * best(other)} for name, best in names.items()}


def main() -> int:
    """Compare the remaining peers; returns MORE if some remain."""
    state, end = Path(sys.argv[1]), time.monotonic() + float(sys.argv[2])
    device, results = devices.start(), saved_part(state, "peers")
    where = "cpu" if devices.is_dry() else devices.NAME
    for peer in PEERS:
        size = peer.small if devices.is_dry() else peer.size
        key = key_of(peer, size)
        if key in results:
            continue
        if end - time.monotonic() < AT_LEAST:
            print("no time left before", key)
            return MORE
        results[key] = measured(peer, size, where) if size else {"skipped": f"dry run: {peer.name} needs a GPU"}
        print(f"{key}: {results[key]}", flush=True)
        keep_part(state, device, "peers", results)
    return 1 if any("error" in each for each in results.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
