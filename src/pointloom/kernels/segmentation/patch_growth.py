"""Grow and merge planar patches over the nearest-neighbor graph, and fit their bounding boxes.

Araujo and Oliveira, Pattern Recognition 100, 2020, sections 3.3 and 3.4. Patches grow in parallel rounds: new points
offer their patch to free neighbors, which accept the least noisy patch. A patch that fits an adjacent larger one is
merged. Patches that grew by half are refitted, until convergence. Boxes have one side along the normal and the in-plane
rotation of minimum area.
"""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from ..array_types import Array2, Integers, Points, Vectors
from ..arrays.concatenation import concatenate_rows
from ..arrays.row_numbers import count_numbers
from ..arrays.select import gather_keys, gather_rows, number_rows_kernel, positions_of
from ..arrays.sort import argsort_keys, positions
from ..lang import (
    INFINITY,
    array,
    atomic_max,
    atomic_min,
    dot,
    float32,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    loop_while,
    struct,
    tid,
    uint8,
    vec3,
)
from ..memory import download, empty, fill, full, upload, upload_together
from .cluster_labels import rename_labels_kernel
from .planar_patches import NO_LIMITS, RunPlanes, Runs

BOX_DIRECTIONS = 45  # of a box's first side over a quarter turn. A second pass subdivides a step
SLICES_PER_BOX = 32  # threads per patch and direction


@kernel
def measure_boxes_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    starts: array(dtype=int32),
    centers: array(dtype=vec3),
    axes: array(dtype=vec3),
    directions: int,
    lows: array(dtype=float32),
    highs: array(dtype=float32),
):
    """Extent of a slice of a patch's points along each axis. Minima and maxima do not depend on the order."""
    i = tid()
    box = i // SLICES_PER_BOX
    part = i % SLICES_PER_BOX
    patch = box // directions
    first = starts[patch]
    size = starts[patch + 1] - first
    per_slice = (size + SLICES_PER_BOX - 1) // SLICES_PER_BOX
    for axis in range(3):
        side = axes[3 * box + axis]
        low = float(INFINITY)
        high = -float(INFINITY)
        for j in range(first + min(part * per_slice, size), first + min((part + 1) * per_slice, size)):
            along = dot(side, points[rows[j]] - centers[patch])
            low = min(low, along)
            high = max(high, along)
        atomic_min(lows, 3 * box + axis, low)
        atomic_max(highs, 3 * box + axis, high)


def tightest_boxes(
    points: Points, runs: Runs, centers: np.ndarray, directions: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Boxes along the normals [b, 3] with minimum face area, to a tenth of a degree. Returns float64 (centers [b, 3],
    rotations [b, 3, 3] with axes as columns and the normal last, extents [b, 3])."""
    normals = directions.astype(np.float64)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    base = _basis(normals)
    step = 0.5 * np.pi / BOX_DIRECTIONS
    best: np.ndarray = np.zeros(len(normals))
    k = axes = lows = highs = best  # set in the loop
    for _ in range(2):
        angles = best[:, None] + step * (np.arange(BOX_DIRECTIONS) - BOX_DIRECTIONS // 2)
        axes = _rotated(base, normals, angles)
        lows, highs = _measure(points, runs, centers, axes)
        sizes = highs - lows
        k = np.argmin(sizes[..., 0] * sizes[..., 1], axis=1)
        best, step = angles[np.arange(len(k)), k], step * 2 / BOX_DIRECTIONS
    chosen = np.arange(len(k)), k
    sides, low, high = axes[chosen], lows[chosen], highs[chosen]
    middle = centers + np.einsum("bi,bij->bj", 0.5 * (low + high), sides)
    return middle, np.transpose(sides, (0, 2, 1)), high - low


def _measure(points: Points, runs: Runs, centers: np.ndarray, axes: np.ndarray) -> Iterator[Any]:
    boxes = axes.shape[0] * axes.shape[1]
    extents = full(6 * boxes, INFINITY, float32, points.device)
    lows, highs = extents[: 3 * boxes], extents[3 * boxes :]
    fill(highs, -INFINITY)
    frames = upload(centers, vec3, points.device), upload(axes.reshape(-1, 3), vec3, points.device)
    arguments = [points, runs.rows, runs.starts, *frames, axes.shape[1], lows, highs]
    launch(measure_boxes_kernel, boxes * SLICES_PER_BOX, arguments)
    bounds = download(extents)  # sync
    return (part.reshape(axes.shape[:3]).astype(np.float64) for part in bounds.reshape(2, -1))


def _basis(normals: np.ndarray) -> np.ndarray:
    smallest = np.eye(3)[np.argmin(np.abs(normals), axis=1)]
    across = np.cross(normals, smallest)
    return across / np.linalg.norm(across, axis=1, keepdims=True)


def _rotated(base: np.ndarray, normals: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Right-handed axes [b, d, 3, 3] as rows: the rotated base, its complement, the normal."""
    partner = np.cross(normals, base)
    cos, sin = np.cos(angles)[..., None], np.sin(angles)[..., None]
    first = cos * base[:, None] + sin * partner[:, None]
    second = cos * partner[:, None] - sin * base[:, None]
    return np.stack([first, second, np.broadcast_to(normals[:, None], first.shape)], axis=2)


NO_OFFER = 0x7FFF_FFFF
REFIT_RATIO = 3  # a patch is fitted again when more than a third of its points are new


@struct
class PatchPoints:
    """Points with normals, neighbors int32 [n, k] (negative for none), and patch labels (-1 for none)."""

    points: array(dtype=vec3)
    normals: array(dtype=vec3)
    neighbors: array(dtype=int32, ndim=2)
    labels: array(dtype=int32)

    def __init__(self, points: Points, normals: Vectors, neighbors: Array2[int32], labels: Integers) -> None:
        self.points, self.normals, self.neighbors, self.labels = points, normals, neighbors, labels


@struct
class PatchPlanes:
    """Planes of patches. `similar`: exclusive minimum cosine of normals; `near`: exclusive maximum distance [m]."""

    centers: array(dtype=vec3)
    directions: array(dtype=vec3)
    similar: array(dtype=float32)
    near: array(dtype=float32)

    def __init__(self, centers: Points, directions: Vectors, similar: np.ndarray, near: np.ndarray) -> None:
        self.centers, self.directions = centers, directions
        self.similar, self.near = upload_together([similar, near], float32, centers.device)


@kernel
def mask_growing_kernel(labels: array(dtype=int32), growing: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    inside = 0
    if labels[i] >= 0:
        inside = growing[labels[i]]
    mask[i] = uint8(inside)


@kernel
def offer_patches_kernel(
    frontier: array(dtype=int32),
    mask: array(dtype=uint8),
    cloud: PatchPoints,
    planes: PatchPlanes,
    ranks: array(dtype=int32),
    offers: array(dtype=int32),
    going: array(dtype=int32),
):
    """Offer the patch of each marked frontier point to its neighbors. An atomic minimum of ranks decides."""
    i = tid()
    if i == 0:
        going[0] = 0
    row = frontier[i]
    if mask[row] == 0:
        return
    patch = cloud.labels[row]
    direction = planes.directions[patch]
    for k in range(cloud.neighbors.shape[1]):
        other = cloud.neighbors[row, k]
        if other >= 0:
            if cloud.labels[other] < 0:
                distance = abs(dot(direction, cloud.points[other] - planes.centers[patch]))
                cosine = abs(dot(direction, cloud.normals[other]))
                if isfinite(cosine) and cosine > planes.similar[patch] and distance < planes.near[patch]:
                    atomic_min(offers, other, ranks[patch])


@kernel
def take_offers_kernel(
    by_rank: array(dtype=int32),
    offers: array(dtype=int32),
    labels: array(dtype=int32),
    mask: array(dtype=uint8),
    going: array(dtype=int32),
):
    """Accept the best offer. All threads that set `going` write 1."""
    i = tid()
    taken = 0
    if offers[i] < NO_OFFER:
        labels[i] = by_rank[offers[i]]
        offers[i] = NO_OFFER
        taken = 1
        going[0] = 1
    mask[i] = uint8(taken)


@func
def fits_patch(i: int, patch: int, similar: float, near: float, cloud: PatchPoints, planes: PatchPlanes) -> int:
    """1 if a point is within the cosine and distance limits of a patch."""
    direction = planes.directions[patch]
    distance = abs(dot(direction, cloud.points[i] - planes.centers[patch]))
    cosine = abs(dot(direction, cloud.normals[i]))
    inside = 0
    if isfinite(cosine) and cosine > similar and distance < near:
        inside = 1
    return inside


@kernel
def choose_partners_kernel(
    cloud: PatchPoints, planes: PatchPlanes, ranks: array(dtype=int32), partners: array(dtype=int32)
):
    """Lowest rank (atomic minimum) of the larger patches that each fits: adjacent points are in each other's planes."""
    i = tid()
    a = cloud.labels[i]
    if a >= 0:
        for k in range(cloud.neighbors.shape[1]):
            j = cloud.neighbors[i, k]
            b = -1
            if j >= 0:
                b = cloud.labels[j]
            if b >= 0 and b != a:
                like = min(planes.similar[a], planes.similar[b])
                max_distance = max(planes.near[a], planes.near[b])
                if abs(dot(planes.directions[a], planes.directions[b])) >= like:
                    there = fits_patch(j, a, like, max_distance, cloud, planes)
                    here = fits_patch(i, b, like, max_distance, cloud, planes)
                    if there == 1 and here == 1:
                        if ranks[a] < ranks[b]:
                            atomic_min(partners, b, ranks[a])
                        else:
                            atomic_min(partners, a, ranks[b])


@kernel
def hand_over_kernel(cloud: PatchPoints, planes: PatchPlanes, targets: array(dtype=int32), names: array(dtype=int32)):
    i = tid()
    patch = cloud.labels[i]
    if patch >= 0:
        target = targets[patch]
        name = names[target]
        if target != patch:
            if fits_patch(i, target, planes.similar[target], planes.near[target], cloud, planes) == 0:
                name = -1
        cloud.labels[i] = name


@kernel
def order_counts_kernel(counts: array(dtype=int32), keys: array(dtype=int64)):
    i = tid()
    keys[i] = int64(NO_OFFER - counts[i])


@kernel
def write_planes_kernel(
    patches: array(dtype=int32),
    new_centers: array(dtype=vec3),
    new_directions: array(dtype=vec3),
    centers: array(dtype=vec3),
    directions: array(dtype=vec3),
):
    i = tid()
    centers[patches[i]] = new_centers[i]
    directions[patches[i]] = new_directions[i]


class Patches:
    """Planar patches over the neighbor graph: labels (-1 for none), planes with cosine and distance limits, point
    counts now and at the last fit, and whether a patch outgrew its seeds."""

    def __init__(
        self, points: Points, normals: Vectors, labels: Integers, planes: Sequence[np.ndarray], neighbors: Array2[int32]
    ) -> None:
        self.points, self.normals, self.labels = points, normals, labels
        self.cloud = PatchPoints(points, normals, neighbors, labels)
        self.device, (centers, directions, self.similar, self.near) = points.device, planes
        self.centers, self.directions = (upload(part, vec3, self.device) for part in (centers, directions))
        self.grew = np.zeros(len(self.near), bool)
        self.counts = self.fitted = download(self._count()).astype(np.int64)  # sync

    def converge(self) -> None:
        merged, growing = True, np.ones(len(self.near), bool)
        while merged or growing.any():
            self._grow(growing | merged)
            merged = self._merge()  # sync
            growing = REFIT_RATIO * (self.counts - self.fitted) > self.counts
            if growing.any():
                self._fit(growing)
                self.grew |= growing

    def boxes(self, shortest: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """`tightest_boxes` of grown patches with an extent >= `shortest` [m], by decreasing number of points."""
        selected = np.flatnonzero(self.grew & (self.counts > 0))
        if not len(selected):
            return np.empty((0, 3)), np.empty((0, 3, 3)), np.empty((0, 3))
        chosen = np.zeros(len(self.grew), bool)
        chosen[selected] = True
        runs, planes = self._fit(chosen)
        numbers = download(planes.packed).view(np.float32)  # sync
        edges = numbers[:, 6]
        boxes = tightest_boxes(self.points, runs, numbers[:, 0:3], numbers[:, 3:6])
        order = np.argsort(-self.counts[selected], kind="stable")
        order = order[edges[order] >= shortest]
        centers, rotations, extents = boxes
        return centers[order], rotations[order], extents[order]

    def _planes(self) -> PatchPlanes:
        return PatchPlanes(self.centers, self.directions, self.similar, self.near)

    def _count(self) -> Integers:
        return count_numbers(self.labels, len(self.near))

    def _grow(self, growing: np.ndarray) -> None:
        size, planes = self.labels.size, self._planes()
        by_rank = np.argsort(-self.similar, kind="stable")
        tables = [growing, np.argsort(by_rank, kind="stable"), by_rank]
        chosen, ranks, by_rank = upload_together(tables, int32, self.device)
        offers, mask = full(size, NO_OFFER, int32, self.device), empty(size, uint8, self.device)
        launch(mask_growing_kernel, size, [self.labels, chosen, mask])
        going = full(1, 1, int32, self.device)
        frontier = positions(size, self.device) if self.device.is_cuda else positions_of(mask)

        def spread() -> None:
            launch(offer_patches_kernel, frontier.size, [frontier, mask, self.cloud, planes, ranks, offers, going])
            launch(take_offers_kernel, size, [by_rank, offers, self.labels, mask, going])

        if self.device.is_cuda:
            loop_while(going, spread)
            return
        while frontier.size:
            spread()
            frontier = positions_of(mask)

    def _merge(self) -> bool:
        """Merge each patch into the largest that it fits, unless that is merged too, so that edges join no walls."""
        count, planes, numbers = len(self.near), self._planes(), self._count()
        keys, ranks = empty(count, int64, self.device), empty(count, int32, self.device)
        launch(order_counts_kernel, count, [numbers, keys])
        order = argsort_keys(keys, 31)[1]
        launch(number_rows_kernel, count, [order, ranks])
        partners = full(count, NO_OFFER, int32, self.device)
        launch(choose_partners_kernel, self.labels.size, [self.cloud, planes, ranks, partners])
        together = download(concatenate_rows([partners, order, numbers]))  # sync
        best_ranks, by_rank, self.counts = (part.astype(np.int64) for part in together.reshape(3, count))
        wanted = best_ranks < NO_OFFER
        targets = np.where(wanted, by_rank[np.where(wanted, best_ranks, 0)], np.arange(count))
        targets = np.where(wanted[targets], np.arange(count), targets)
        is_remaining = targets == np.arange(count)
        if is_remaining.all():
            return False
        np.minimum.at(self.similar, targets, self.similar.copy())
        np.maximum.at(self.near, targets, self.near.copy())
        tables = [targets, np.cumsum(is_remaining) - 1, np.flatnonzero(is_remaining)]
        onto, names, rows = upload_together(tables, int32, self.device)
        launch(hand_over_kernel, self.labels.size, [self.cloud, self._planes(), onto, names])
        for name in ("similar", "near", "fitted", "grew"):
            setattr(self, name, getattr(self, name)[is_remaining])
        self.centers, self.directions = gather_rows(self.centers, rows), gather_rows(self.directions, rows)
        self.counts = download(self._count()).astype(np.int64)  # sync
        return True

    def _fit(self, chosen: np.ndarray) -> tuple[Runs, RunPlanes]:
        """Fit the planes of some patches to their points: one run each."""
        patches, device = np.flatnonzero(chosen), self.device
        tables = [chosen, np.cumsum(chosen) - 1, self.counts[patches], patches]
        inside, names, counts, numbers = upload_together(tables, int32, device)
        mask = empty(self.labels.size, uint8, device)
        launch(mask_growing_kernel, self.labels.size, [self.labels, inside, mask])
        rows = positions_of(mask, int(self.counts[chosen].sum()))
        _, order = argsort_keys(gather_keys(self.labels, rows), max(1, len(chosen).bit_length()))
        rows = gather_rows(rows, order)
        of_rows = gather_rows(self.labels, rows)
        launch(rename_labels_kernel, of_rows.size, [names, of_rows])
        runs = Runs(rows, of_rows, counts)
        planes = RunPlanes(self.points, self.normals, runs, gather_rows(self.directions, numbers), NO_LIMITS)
        arguments = [numbers, planes.centers, planes.directions, self.centers, self.directions]
        launch(write_planes_kernel, numbers.size, arguments)
        self.fitted = np.where(chosen, self.counts, self.fitted)
        return runs, planes
