"""The search for the planes of all pictures, phase by phase: from coarse to fine, then with what the sources found."""

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
from ...kernels.array_types import Array1
from ...kernels.lang import launch, vec4
from ...kernels.memory import clone, download, empty, upload
from ...kernels.stereo.inverse_planes import refine_planes_kernel
from ...kernels.stereo.patch_costs import Reference, Sources, patch_on
from ...kernels.stereo.patch_match import Turn, spread_planes, start_planes
from ...kernels.stereo.place_planes import TOLERANCE, judge_places, plane_priors, take_priors
from ...kernels.stereo.plain_places import find_places
from ...kernels.stereo.plane_results import finish_planes
from ...registration.rigid import invert_pose
from .depth_maps import DepthMap
from .picture_slots import Picture, Slots, picture_slots, plane_slots, put_brightness, put_planes, read_picture
from .posed_pictures import PosedCamera


@dataclasses.dataclass(frozen=True)
class Found:
    """The planes of a picture so far: vec4 [pixels] on the device, or float32 [pixels, 4] in memory or in a file."""

    planes: Array1[vec4] | NDArray[np.float32] | Path
    camera: PinholeCameraIntrinsic

    def read(self) -> Any:
        """The planes."""
        return np.load(self.planes) if isinstance(self.planes, Path) else self.planes

    def on(self, device: Any) -> Array1[vec4]:
        """The planes on the device, to be changed."""
        planes = self.read()
        return upload(planes, vec4, device) if isinstance(planes, np.ndarray) else clone(planes)


class PlaneFiles:
    """What a search has found so far, a file a picture and phase, each whole: an interrupted one goes on from it.

    Args:
        folder: Where they lie; None keeps nothing.
    """

    def __init__(self, folder: Path | None):
        self.folder = folder

    def write(self, phase: int, index: int, planes: Any) -> None:
        """Keep the planes of a picture after a phase."""
        if self.folder is not None:
            values = np.array(download(planes)).reshape(-1, 4)  # sync
            with atomic_write(self._place(phase, index)) as file:
                np.lib.format.write_array(file, values, allow_pickle=False)

    def read(self, phase: int, index: int, camera: PinholeCameraIntrinsic) -> Found | None:
        """What is kept of a picture after a phase; None where nothing is, or what is no planes of this size."""
        if self.folder is None:
            return None
        place = self._place(phase, index)
        try:
            kept = np.load(place, mmap_mode="r", allow_pickle=False)
        except (OSError, ValueError, EOFError):
            return None
        fits = kept.shape == (camera.width * camera.height, 4) and kept.dtype == np.float32
        return Found(place, camera) if fits else None

    def last_whole(
        self, scales: Sequence[float], cameras: Sequence[PosedCamera], sources: Sequence[Sequence[int]]
    ) -> tuple[int, list[Found | None]]:
        """The phase to go on with, and what the one before left of all pictures that have sources.

        Args:
            scales: Of the pictures in each phase.
            cameras, sources: Of the pictures.
        """
        for number in range(len(scales) - 2, -1, -1) if self.folder is not None else ():
            found = [
                self.read(number, i, camera.intrinsic.scaled(scales[number])) if sources[i] else None
                for i, camera in enumerate(cameras)
            ]
            if all(each is not None for each, mine in zip(found, sources, strict=True) if mine):
                return number + 1, found
        return 0, [None] * len(cameras)

    def _place(self, phase: int, index: int) -> Path:
        assert self.folder is not None
        return self.folder / f"{phase}-{index:06d}.npy"


Matrix = NDArray[np.float64]
SLOT_BYTES = 20  # a pixel: its brightness and its plane
PLANE_BYTES = 16  # a pixel
SEED_STEP = 7919  # between the seeds of one picture and the next, of one phase and the next
LEAST_SIDE = 24  # [px] of a picture that is worth a phase of its own
MOST_SEED = 0x7FFFFFFF


def grid(first: int, step: int, is_taken: Callable[[int], bool]) -> NDArray[np.int64]:
    """Pixels of a square about a pixel whose squared distance is taken: across and down [px], [n, 2]."""
    side = range(first, 1 - first, step)
    return np.array([(u, v) for v in side for u in side if is_taken(u * u + v * v)])


# The largest patch goes without its corners, which weigh least. The densest, without the middle that costs are relative
# to and the places of a knight's move, follows texture closer, but fits noise of plain walls too: for the end alone.
LARGE = grid(-5, 2, lambda sqdist: sqdist < 50)
MIDDLE = grid(-3, 2, lambda sqdist: True)
SMALL = grid(-2, 2, lambda sqdist: True)
DENSE = grid(-2, 1, lambda sqdist: sqdist not in (0, 5))


@dataclasses.dataclass(frozen=True)
class Phase:
    """One walk over all pictures.

    Attributes:
        scale: Of the pictures.
        turns: Half-turns for each colour of the chessboard.
        spread: Greatest change of a plane in the first turn [px in the sources], half of it in each further one.
        patch: Where its samples are from its middle: across and down [px], [n, 2].
        regions: Of eight whose planes a pixel tries.
        geometric: Weight of the distance to the sources' surfaces and back [1 / px].
        prior: Whether plain places take planes fitted to what is sure about them, at the end.
    """

    scale: float
    turns: int
    spread: float
    patch: NDArray[np.int64]
    regions: int = 8
    geometric: float = 0.0
    prior: bool = False


# Small pictures want large patches, since noise and ambiguity are large there; the last phases have the sources' depth
# against ambiguity and take small ones, which do not spread the foreground beyond its edge. A second walk with the
# sources' new depth does more than a second turn with their old. Priors want sure depth, that which sources agree on:
# after the first of those, and after the second again, since patches of noise would have led pixels away from them.
PLAN = (
    Phase(0.25, turns=4, spread=1.0, patch=LARGE),
    Phase(0.5, turns=2, spread=0.6, patch=LARGE),
    Phase(1.0, turns=1, spread=0.6, patch=MIDDLE),
    Phase(1.0, turns=1, spread=0.25, patch=SMALL, regions=4, geometric=0.1, prior=True),
    Phase(1.0, turns=1, spread=0.1, patch=DENSE, regions=4, geometric=0.1, prior=True),
)
TRIALS = 4  # changed planes that a pixel tries in a half-turn
CHOSEN = 3  # sources that a pixel is compared with
GOOD = 0.8  # cost below which a source fits


@dataclasses.dataclass(frozen=True)
class Setting:
    """What is sought: the pictures, their sources, and the nearest and farthest depth of each [unit of the poses].

    A picture without sources is passed over.
    """

    pictures: Sequence[Picture]
    cameras: Sequence[PosedCamera]
    sources: Sequence[Sequence[int]]
    ranges: Sequence[tuple[float, float]]
    seed: int
    device: Any
    device_bytes: int


def plan_for(cameras: Sequence[PosedCamera]) -> tuple[Phase, ...]:
    """The phases for pictures of this size: none at a scale that leaves nothing to compare."""
    least = min(min(each.intrinsic.width, each.intrinsic.height) for each in cameras)
    return tuple(phase for phase in PLAN if phase.scale == 1.0 or round(least * phase.scale) >= LEAST_SIDE)


def find_depth(setting: Setting, folder: Path | None, say: Any, going: Path | None = None) -> Iterator[DepthMap]:
    """The depth maps of all pictures in order; planes that have no room on the device are kept in
    `folder` meanwhile, in memory where it is None; in `going`, where they stay if this is interrupted."""
    plan, stay = plan_for(setting.cameras), going is None and _stay_on_device(setting)
    count, kept = len(setting.cameras), PlaneFiles(going)
    first, found = kept.last_whole([phase.scale for phase in plan], setting.cameras, setting.sources)
    folder = None if stay or going else folder
    with tempfile.TemporaryDirectory(prefix=".planes-", dir=folder) if folder else contextlib.nullcontext() as place:
        for number, phase in enumerate(plan[first:], first):
            walk = _Walk(setting, number, phase, found)
            fresh: list[Found | None] = [None] * count
            for i in range(count):
                camera = walk.cameras[i]
                planes = None
                if setting.sources[i]:
                    before = kept.read(number, i, camera)
                    planes = walk.match(i) if before is None else before.on(setting.device)
                    if before is None:
                        kept.write(number, i, planes)
                say("depth", number * count + i + 1, len(plan) * count)
                if number == len(plan) - 1:
                    yield _no_depth(setting.cameras[i]) if planes is None else walk.result(i, planes)
                elif planes is not None:
                    fresh[i] = kept.read(number, i, camera)
                    if fresh[i] is None:
                        fresh[i] = Found(planes, camera) if stay else _kept(planes, camera, place, number, i)
            _drop(found)
            found = fresh


def _stay_on_device(setting: Setting) -> bool:
    """Whether the planes of all pictures have room on the device, those of two phases, beside what is matched."""
    size = sum(each.intrinsic.width * each.intrinsic.height for each in setting.cameras)
    return (SLOT_BYTES + 2 * PLANE_BYTES) * size <= setting.device_bytes


def _kept(planes: Any, camera: PinholeCameraIntrinsic, place: str | None, number: int, index: int) -> Found:
    values = np.array(download(planes)).reshape(-1, 4)
    if place is None:
        return Found(values, camera)
    path = Path(place) / f"{number}-{index}.npy"
    np.save(path, values)
    return Found(path, camera)


def _drop(found: Sequence[Found | None]) -> None:
    for each in found:
        if each is not None and isinstance(each.planes, Path):
            each.planes.unlink()


def _no_depth(camera: PosedCamera) -> DepthMap:
    size = (camera.intrinsic.height, camera.intrinsic.width)
    return DepthMap(*(np.zeros(shape, np.float32) for shape in (size, (*size, 3), size)))


def projection(source: PinholeCameraIntrinsic, reference: PinholeCameraIntrinsic, T_source_reference: Matrix) -> Matrix:
    """A and b of A p + b w side by side, shape [3, 4]."""
    K = source.matrix
    rotation = K @ T_source_reference[:3, :3] @ np.linalg.inv(reference.matrix)
    return np.column_stack([rotation, K @ T_source_reference[:3, 3]])


class _Walk:
    """One phase: the pictures at its scale on the device, and the maps that the last one left."""

    def __init__(self, setting: Setting, number: int, phase: Phase, found: Sequence[Found | None]):
        self.setting, self.number, self.phase, self.found = setting, number, phase, found
        self.patch = patch_on(phase.patch, setting.device)
        self.cameras = [camera.intrinsic.scaled(phase.scale) for camera in setting.cameras]
        largest = max(each.width * each.height for each in self.cameras)
        least = 1 + max(len(each) for each in setting.sources)
        count = min(max(setting.device_bytes // (SLOT_BYTES * largest), least), len(setting.cameras))
        self.brightness = picture_slots(count, largest, setting.device)
        self.maps: Slots = plane_slots(
            count if phase.geometric else 1, largest if phase.geometric else 1, setting.device
        )
        self._views: tuple[int, Reference, Sources] | None = None

    def match(self, index: int) -> Any:
        """The planes of a picture after this phase, on the device."""
        reference, sources = self.views(index)
        phase, device = self.phase, self.setting.device
        before, size = self.found[index], reference.width * reference.height
        chosen = min(CHOSEN, sources.count)
        seed = (self.setting.seed + SEED_STEP * (self.number * len(self.cameras) + index)) & MOST_SEED
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
        for number in range(phase.turns):
            for color in (0, 1):
                turn = Turn(
                    seed=seed, number=number, color=color, regions=phase.regions, trials=TRIALS, chosen=chosen,
                    spread=phase.spread * 0.5**number, geometric=phase.geometric, good=GOOD,
                )  # fmt: skip
                spread_planes(turn, reference, sources, planes, costs)
        if phase.prior:
            judged = judge_places(reference, sources, planes)
            places = find_places(judged, reference.width)
            if places is not None:
                priors = plane_priors(places, judged, planes, TOLERANCE / reference.pixels_per, seed)
                take_priors(chosen, phase.geometric, reference, sources, priors, planes, costs)
        return planes

    def result(self, index: int, planes: Any) -> DepthMap:
        """The depth map that planes come to."""
        camera = self.cameras[index]
        values = [np.array(download(each)) for each in finish_planes(*self.views(index), planes)]
        depth, normals, confidence = values
        size = (camera.height, camera.width)
        return DepthMap(depth.reshape(size), normals.reshape(*size, 3), confidence.reshape(size))

    def views(self, index: int) -> tuple[Reference, Sources]:
        """A picture and its sources on the device."""
        if self._views is not None and self._views[0] == index:
            return self._views[1:]
        setting, mine = self.setting, self.cameras[index]
        first = self._picture(index)
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
        mine, theirs, old = self.cameras[index], self.cameras[other], self.found[other]
        T = self.setting.cameras[other].T_camera_world @ invert_pose(self.setting.cameras[index].T_camera_world)
        layout = (theirs.width, theirs.height, self._picture(other))
        there = projection(theirs, mine, T)
        if not self.phase.geometric or old is None:
            return there, there, there, layout, (0, 0, 0)
        first = self.maps.first_of(other, lambda at: put_planes(self.maps, at, old.read()))
        size = (old.camera.width, old.camera.height, first)
        return there, projection(old.camera, mine, T), projection(mine, old.camera, invert_pose(T)), layout, size

    def _picture(self, index: int) -> int:
        camera = self.cameras[index]

        def load(first: int) -> None:
            pixels = read_picture(f"pictures[{index}]", self.setting.pictures[index], self.setting.cameras[index])
            put_brightness(self.brightness, first, pixels, camera.width, camera.height)

        return self.brightness.first_of(index, load)


def motion_of(reference: PosedCamera, source: PosedCamera) -> float:
    """How far pixels move at most for an inverse depth of one [px unit]."""
    focal = max(source.intrinsic.fx, source.intrinsic.fy)
    return focal * float(np.linalg.norm(reference.center - source.center))
