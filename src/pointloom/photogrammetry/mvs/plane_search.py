"""Coarse-to-fine PatchMatch over all images, first photometric, then with geometric consistency."""

from __future__ import annotations

import contextlib
import dataclasses
import tempfile
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.atomic import atomic_write
from ...core.errors import FileError
from ...io.fixed_rows import StoredArray
from ...io.source import open_source
from ...kernels.array_types import Array1, Device
from ...kernels.lang import launch, uint64, vec4
from ...kernels.memory import clone, download, empty, upload
from ...kernels.stereo.inverse_planes import refine_planes_kernel
from ...kernels.stereo.patch_costs import Reference, Sources, patch_on
from ...kernels.stereo.patch_match import HalfIteration, spread_planes, start_planes
from ...kernels.stereo.plane_results import finish_planes
from ...kernels.stereo.region_planes import INLIER_DISTANCE, judge_pixels, plane_priors, take_priors
from ...kernels.stereo.textureless_regions import find_regions
from ...registration.rigid import invert_pose
from .depth_maps import DepthMap
from .image_slots import Image, Slots, put_brightness, put_planes, read_image
from .posed_images import PosedCamera


@dataclasses.dataclass(frozen=True)
class StoredPlanes:
    """Current planes of an image: vec4 [pixels] on the device, or float32 [pixels, 4] in memory or a file."""

    planes: Array1[vec4] | NDArray[np.float32] | Path
    camera: PinholeCameraIntrinsic

    def read(self) -> Any:
        return _stored(self.planes, self.camera)[:] if isinstance(self.planes, Path) else self.planes

    def on(self, device: Device) -> Array1[vec4]:
        """A modifiable copy of the planes on the device."""
        planes = self.read()
        return upload(planes, vec4, device) if isinstance(planes, np.ndarray) else clone(planes)


class PlaneFiles:
    """Checkpoints of a search, one atomic file per image and phase; `folder` None: none."""

    def __init__(self, folder: Path | None):
        self.folder = folder

    def write(self, phase: int, index: int, planes: Any) -> None:
        if self.folder is not None:
            values = np.array(download(planes)).reshape(-1, 4)  # sync
            with atomic_write(self._path(phase, index)) as file:
                np.lib.format.write_array(file, values, allow_pickle=False)

    def read(self, phase: int, index: int, camera: PinholeCameraIntrinsic) -> StoredPlanes | None:
        if self.folder is None:
            return None
        path = self._path(phase, index)
        try:
            is_finite = np.isfinite(_stored(path, camera)[:]).all()
        except FileError:
            return None
        return StoredPlanes(path, camera) if is_finite else None

    def last_complete(
        self, scales: Sequence[float], cameras: Sequence[PosedCamera], sources: Sequence[Sequence[int]]
    ) -> tuple[int, list[StoredPlanes | None]]:
        """The phase to continue with, and the previous results of all images with sources."""
        for number in range(len(scales) - 2, -1, -1) if self.folder is not None else ():
            results = [
                self.read(number, i, camera.intrinsic.scaled(scales[number])) if sources[i] else None
                for i, camera in enumerate(cameras)
            ]
            if all(each is not None for each, mine in zip(results, sources, strict=True) if mine):
                return number + 1, results
        return 0, [None] * len(cameras)

    def _path(self, phase: int, index: int) -> Path:
        assert self.folder is not None
        return self.folder / f"{phase}-{index:06d}.npy"


def _stored(path: Path, camera: PinholeCameraIntrinsic) -> StoredArray:
    """The planes of an image in a file. Raises `FileError` if the file is missing, damaged or of another image."""
    remedy = "Run it again: planes that cannot be read are computed again"
    try:
        planes = StoredArray(open_source(path))
    except FileError as error:
        raise FileError(path, error.reason, where=error.where, remedy=remedy) from error
    size = camera.width * camera.height
    if planes.shape != (size, 4) or planes.dtype != np.float32:
        reason = f"expected planes float32 [{size}, 4], got {planes.dtype} {list(planes.shape)}"
        raise FileError(path, reason, remedy=remedy)
    return planes


Matrix = NDArray[np.float64]
SLOT_BYTES = 24  # per pixel: brightness and plane
PLANE_BYTES = 16  # per pixel
SEED_STEP = 7919  # between seeds of consecutive images and phases
MIN_SIDE = 24  # [px] minimum image side of a phase
MAX_SEED = 0x7FFFFFFF


def grid(first: int, step: int, is_taken: Callable[[int], bool]) -> NDArray[np.int64]:
    """Pixel offsets (across, down) [px] within a square whose squared distance is accepted, [n, 2]."""
    side = range(first, 1 - first, step)
    return np.array([(u, v) for v in side for u in side if is_taken(u * u + v * v)])


# The largest patch omits its light corners. The densest (without center and knight moves) follows texture closely, but
# fits noise of plain walls: only at the end.
LARGE_PATCH = grid(-5, 2, lambda sqdist: sqdist < 50)
MIDDLE_PATCH = grid(-3, 2, lambda sqdist: True)
SMALL_PATCH = grid(-2, 2, lambda sqdist: True)
DENSE_PATCH = grid(-2, 1, lambda sqdist: sqdist not in (0, 5))


@dataclasses.dataclass(frozen=True)
class Phase:
    """One pass over all images at a scale; `spread` [px in the sources] is the plane perturbation, halved each time."""

    scale: float
    iterations: int
    spread: float
    patch: NDArray[np.int64]
    regions: int = 8
    geometric: float = 0.0
    prior: bool = False


# Small images need large patches against noise and ambiguity. The last phases use geometric consistency and small
# patches, which do not spread the foreground. A second pass with updated source depth helps more than a second
# iteration. Priors need consistent depth: after the first such phase, and again after the second, since noisy patches
# led pixels away.
SEARCH_PHASES = (
    Phase(0.25, iterations=4, spread=1.0, patch=LARGE_PATCH),
    Phase(0.5, iterations=2, spread=0.6, patch=LARGE_PATCH),
    Phase(1.0, iterations=1, spread=0.6, patch=MIDDLE_PATCH),
    Phase(1.0, iterations=1, spread=0.25, patch=SMALL_PATCH, regions=4, geometric=0.1, prior=True),
    Phase(1.0, iterations=1, spread=0.1, patch=DENSE_PATCH, regions=4, geometric=0.1, prior=True),
)
TRIALS_PER_ITERATION = 4  # perturbed planes per iteration
SOURCES_PER_PIXEL = 3  # sources per pixel
MAX_MATCH_COST = 0.8  # cost below which a source matches


@dataclasses.dataclass(frozen=True)
class Setting:
    """The images, their sources, and depth ranges [pose units]. Images without sources are skipped."""

    images: Sequence[Image]
    cameras: Sequence[PosedCamera]
    sources: Sequence[Sequence[int]]
    ranges: Sequence[tuple[float, float]]
    seed: int
    device: Any
    device_bytes: int


def plan_for(cameras: Sequence[PosedCamera]) -> tuple[Phase, ...]:
    shortest_side = min(min(each.intrinsic.width, each.intrinsic.height) for each in cameras)
    return tuple(
        phase for phase in SEARCH_PHASES if phase.scale == 1.0 or round(shortest_side * phase.scale) >= MIN_SIDE
    )


def find_depth(
    setting: Setting, folder: Path | None, report: Any, checkpoints: Path | None = None
) -> Iterator[DepthMap]:
    """Yield the depth maps in order; `folder` buffers planes beyond device memory, `checkpoints` keeps phases."""
    plan, stay = plan_for(setting.cameras), checkpoints is None and _stay_on_device(setting)
    count, files = len(setting.cameras), PlaneFiles(checkpoints)
    first, previous = files.last_complete([phase.scale for phase in plan], setting.cameras, setting.sources)
    folder = None if stay or checkpoints else folder
    with tempfile.TemporaryDirectory(prefix=".planes-", dir=folder) if folder else contextlib.nullcontext() as scratch:
        for number, phase in enumerate(plan[first:], first):
            run = _PhaseRun(setting, number, phase, previous)
            fresh: list[StoredPlanes | None] = [None] * count
            for i in range(count):
                camera = run.cameras[i]
                planes = None
                if setting.sources[i]:
                    before = files.read(number, i, camera)
                    planes = run.match(i) if before is None else before.on(setting.device)
                    if before is None:
                        files.write(number, i, planes)
                report("depth", number * count + i + 1, len(plan) * count)
                if number == len(plan) - 1:
                    yield no_depth(setting.cameras[i]) if planes is None else run.result(i, planes)
                elif planes is not None:
                    fresh[i] = files.read(number, i, camera)
                    if fresh[i] is None:
                        fresh[i] = (
                            StoredPlanes(planes, camera) if stay else _store_planes(planes, camera, scratch, number, i)
                        )
            _drop(previous)
            previous = fresh


def _stay_on_device(setting: Setting) -> bool:
    """True if the planes of all images for two phases fit on the device."""
    size = sum(each.intrinsic.width * each.intrinsic.height for each in setting.cameras)
    return (SLOT_BYTES + 2 * PLANE_BYTES) * size <= setting.device_bytes


def _store_planes(
    planes: Any, camera: PinholeCameraIntrinsic, folder: str | None, number: int, index: int
) -> StoredPlanes:
    values = np.array(download(planes)).reshape(-1, 4)
    if folder is None:
        return StoredPlanes(values, camera)
    path = Path(folder) / f"{number}-{index}.npy"
    np.save(path, values)
    return StoredPlanes(path, camera)


def _drop(stored: Sequence[StoredPlanes | None]) -> None:
    for each in stored:
        if each is not None and isinstance(each.planes, Path):
            each.planes.unlink()


def no_depth(camera: PosedCamera) -> DepthMap:
    size = (camera.intrinsic.height, camera.intrinsic.width)
    return DepthMap(*(np.zeros(shape, np.float32) for shape in (size, (*size, 3), size)))


def projection(source: PinholeCameraIntrinsic, reference: PinholeCameraIntrinsic, T_source_reference: Matrix) -> Matrix:
    K = source.matrix
    rotation = K @ T_source_reference[:3, :3] @ np.linalg.inv(reference.matrix)
    return np.column_stack([rotation, K @ T_source_reference[:3, 3]])


class _PhaseRun:
    """One phase: the scaled images on the device, and the maps of the previous phase."""

    def __init__(self, setting: Setting, number: int, phase: Phase, previous: Sequence[StoredPlanes | None]):
        self.setting, self.number, self.phase, self.previous = setting, number, phase, previous
        self.patch = patch_on(phase.patch, setting.device)
        self.cameras = [camera.intrinsic.scaled(phase.scale) for camera in setting.cameras]
        largest = max(each.width * each.height for each in self.cameras)
        min_slots = 1 + max(len(each) for each in setting.sources)
        count = min(max(setting.device_bytes // (SLOT_BYTES * largest), min_slots), len(setting.cameras))
        self.brightness = Slots(count, largest, uint64, setting.device)
        room = (count, largest) if phase.geometric else (1, 1)
        self.maps = Slots(*room, vec4, setting.device)
        self._views: tuple[int, Reference, Sources] | None = None

    def match(self, index: int) -> Any:
        reference, sources = self.views(index)
        phase, device = self.phase, self.setting.device
        before, size = self.previous[index], reference.width * reference.height
        chosen = min(SOURCES_PER_PIXEL, sources.count)
        seed = (self.setting.seed + SEED_STEP * (self.number * len(self.cameras) + index)) & MAX_SEED
        if before is None:
            planes = empty(size, vec4, device)
        else:
            planes = before.on(device)
            columns, rows = before.camera.width, before.camera.height
            if (columns, rows) != (reference.width, reference.height):
                coarse, planes = planes, empty(size, vec4, device)
                launch(refine_planes_kernel, size, [coarse, columns, rows, reference.width, reference.height, planes])
        costs = start_planes(
            reference, sources, planes, seed=seed, is_given=before is not None, geometric=phase.geometric, chosen=chosen
        )
        for number in range(phase.iterations):
            for color in (0, 1):
                iteration = HalfIteration(
                    seed=seed, number=number, color=color, regions=phase.regions, trials=TRIALS_PER_ITERATION,
                    chosen=chosen, spread=phase.spread * 0.5**number, geometric=phase.geometric, good=MAX_MATCH_COST,
                )  # fmt: skip
                spread_planes(iteration, reference, sources, planes, costs)
        if phase.prior:
            judged = judge_pixels(reference, sources, planes)
            supports = find_regions(judged, reference.width)
            if supports is not None:
                priors = plane_priors(supports, judged, planes, INLIER_DISTANCE / reference.pixels_per, seed)
                take_priors(chosen, phase.geometric, reference, sources, priors, planes, costs)
        return planes

    def result(self, index: int, planes: Any) -> DepthMap:
        camera = self.cameras[index]
        values = [np.array(download(each)) for each in finish_planes(*self.views(index), planes)]
        depth, normals, confidence = values
        size = (camera.height, camera.width)
        return DepthMap(depth.reshape(size), normals.reshape(*size, 3), confidence.reshape(size))

    def views(self, index: int) -> tuple[Reference, Sources]:
        if self._views is not None and self._views[0] == index:
            return self._views[1:]
        setting, mine = self.setting, self.cameras[index]
        first = self._image(index)
        tables = [self._source(index, j) for j in setting.sources[index]]
        there, map_there, map_back, layout, map_layout = (np.array(each) for each in zip(*tables, strict=True))
        slots = (self.brightness.values, self.maps.values)
        sources = Sources(there, map_there, map_back, layout, map_layout, *slots)
        near, far = setting.ranges[index]
        moved = [motion_of(setting.cameras[index], setting.cameras[j]) for j in setting.sources[index]]
        reference = Reference(
            mine.width, mine.height, first, (mine.fx, mine.fy, mine.cx, mine.cy), (1 / far, 1 / near),
            float(np.median(moved)) * self.phase.scale, self.patch,
        )  # fmt: skip
        self._views = (index, reference, sources)
        return reference, sources

    def _source(self, index: int, other: int) -> tuple[Any, ...]:
        mine, theirs, old = self.cameras[index], self.cameras[other], self.previous[other]
        T = self.setting.cameras[other].T_camera_world @ invert_pose(self.setting.cameras[index].T_camera_world)
        layout = (theirs.width, theirs.height, self._image(other))
        there = projection(theirs, mine, T)
        if not self.phase.geometric or old is None:
            return there, there, there, layout, (0, 0, 0)
        first = self.maps.first_of(other, lambda at: put_planes(self.maps, at, old.read()))
        size = (old.camera.width, old.camera.height, first)
        return there, projection(old.camera, mine, T), projection(mine, old.camera, invert_pose(T)), layout, size

    def _image(self, index: int) -> int:
        camera = self.cameras[index]

        def load(first: int) -> None:
            pixels = read_image(f"images[{index}]", self.setting.images[index], self.setting.cameras[index])
            put_brightness(self.brightness, first, pixels, camera.width, camera.height)

        return self.brightness.first_of(index, load)


def motion_of(reference: PosedCamera, source: PosedCamera) -> float:
    """Maximum image motion per inverse depth [px unit]."""
    focal = max(source.intrinsic.fx, source.intrinsic.fy)
    return focal * float(np.linalg.norm(reference.center - source.center))
