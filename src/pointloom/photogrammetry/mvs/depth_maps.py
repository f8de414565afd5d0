"""Depth maps in memory or in a folder, written atomically.

A folder contains `000000.npz` and so on (float32 `depth` and `confidence` [h, w], `normals` [h * w, 3], uncompressed)
and `depth_maps.json` with cameras and sources, written last: a folder without it is incomplete.
"""

from __future__ import annotations

import dataclasses
import json
import zipfile
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic, intrinsic_to_json, read_json_matrix
from ...core.atomic import atomic_write
from ...core.checks import check_finite, check_numeric
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.json_files import check_keys, read_json_object
from ...core.paths import input_path, os_errors, path_of, refuse_links
from ...io.optional_imports import foreign_errors
from ...io.points.npz import read_member
from .posed_images import PosedCamera, check_cameras, check_sources

INDEX = "depth_maps.json"
FORMAT_VERSION = 1
AGAIN = "Estimate the depth maps again"
_TIME_STAMP = (1980, 1, 1, 0, 0, 0)  # fixed, for reproducible files
_MEMBERS = ("depth", "normals", "confidence")


@dataclasses.dataclass(frozen=True, eq=False)
class DepthMap:
    """Depth, normals and confidence of one image.

    Args:
        depth: Along the camera's z, float32 [h, w] [pose units]. 0 where unknown.
        normals: Unit normals toward the camera in its frame (x right, y down, z forward), float32 [h, w, 3]; or 0.
        confidence: 0 to 1, float32 [h, w]. 0 without depth.

    Raises:
        TypeError, ValueError: Not numeric, inconsistent shapes, invalid depth, or confidence outside 0..1.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.photogrammetry.mvs.depth_maps import DepthMap
        >>> DepthMap(np.ones((6, 8)), np.zeros((6, 8, 3)), np.ones((6, 8)))
        DepthMap(8 x 6, 100 % with depth)
    """

    depth: NDArray[np.float32]
    normals: NDArray[np.float32]
    confidence: NDArray[np.float32]

    def __init__(self, depth: ArrayLike, normals: ArrayLike, confidence: ArrayLike):
        z = _float32("depth", depth)
        if z.ndim != 2 or not z.size:
            raise ValueError(f"depth: expected shape [h, w] with pixels, got {list(z.shape)}")
        n, c = _float32("normals", normals), _float32("confidence", confidence)
        if n.shape != (*z.shape, 3):
            raise ValueError(f"normals: expected shape {[*z.shape, 3]} as of depth, got {list(n.shape)}")
        if c.shape != z.shape:
            raise ValueError(f"confidence: expected shape {list(z.shape)} as of depth, got {list(c.shape)}")
        if not (z >= 0).all():
            raise ValueError(f"depth: expected numbers >= 0, got {z.min()}")
        if not ((c >= 0) & (c <= 1)).all():
            raise ValueError(f"confidence: expected 0 to 1, got {c.min()} to {c.max()}")
        for name, values in zip(_MEMBERS, (z, n, c), strict=True):
            object.__setattr__(self, name, values)

    def __repr__(self) -> str:
        height, width = self.depth.shape
        return f"DepthMap({width} x {height}, {100 * self.fraction:.0f} % with depth)"

    @property
    def fraction(self) -> float:
        """Fraction of pixels with depth."""
        return float(np.count_nonzero(self.depth)) / self.depth.size


class DepthMaps(Sequence[DepthMap]):
    """Depth maps of several images, in memory or on disk (20 B per pixel; those on disk are loaded one at a time).

    Args:
        cameras: A PosedCamera of the same size for each map.
        sources: Source image numbers of each image.
        maps: The DepthMaps in order; may be a generator.
        folder: Output folder, created if missing; None: in memory.

    Raises:
        TypeError, ValueError: Wrong types, a wrong number of maps, or a map of another size than its camera.
        FileError: The folder cannot be written.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.photogrammetry.mvs.depth_maps import DepthMap
        >>> from pointloom.photogrammetry.mvs.depth_maps import DepthMaps
        >>> intrinsic = loom.PinholeCameraIntrinsic(8, 6, 10.0, 10.0, 3.5, 2.5)
        >>> camera = loom.photogrammetry.PosedCamera(intrinsic, np.eye(4))
        >>> empty = DepthMap(np.zeros((6, 8)), np.zeros((6, 8, 3)), np.zeros((6, 8)))
        >>> maps = DepthMaps([camera], [()], [empty], folder="maps")
        >>> DepthMaps.open("maps")
        DepthMaps(1 image in maps)
    """

    def __init__(
        self,
        cameras: Iterable[PosedCamera],
        sources: Iterable[Iterable[int]],
        maps: Iterable[DepthMap],
        *,
        folder: FilePath | None = None,
    ):
        self.cameras = check_cameras("cameras", cameras)
        self.sources = check_sources("sources", sources, len(self.cameras))
        self.folder = None if folder is None else made_folder(folder)
        self._in_memory: list[DepthMap] = []
        if isinstance(maps, str | bytes | dict):
            raise TypeError(f"maps: expected an iterable of DepthMap, got {type(maps).__name__}")
        try:
            several = iter(maps)
        except TypeError as error:
            raise TypeError(f"maps: expected an iterable of DepthMap, got {type(maps).__name__}") from error
        count = 0
        for i, each in enumerate(several):
            self._check(i, each)
            if self.folder is None:
                self._in_memory.append(each)
            else:
                _write_map(self.folder / _file_name(i), each)
            count += 1
        if count != len(self.cameras):
            raise ValueError(f"maps: expected one for each of the {len(self.cameras)} cameras, got {count}")
        if self.folder is not None:
            _write_index(self.folder / INDEX, self.cameras, self.sources)

    @classmethod
    def open(cls, folder: FilePath) -> DepthMaps:
        """Open a folder of maps. Each is read on demand.

        Raises:
            FileError: Not a complete folder of depth maps, or a damaged one.
        """
        maps = object.__new__(cls)
        maps.folder, maps._in_memory = path_of(folder, "folder"), []
        maps.cameras, maps.sources = _read_index(maps.folder / INDEX)
        for i in range(len(maps.cameras)):
            if not (maps.folder / _file_name(i)).is_file():
                raise FileError(maps.folder / _file_name(i), "is missing", remedy=AGAIN)
        return maps

    def __repr__(self) -> str:
        count = f"{len(self)} image{'' if len(self) == 1 else 's'}"
        return escaped(f"DepthMaps({count}{'' if self.folder is None else f' in {self.folder}'})")

    def __len__(self) -> int:
        return len(self.cameras)

    @overload
    def __getitem__(self, index: int) -> DepthMap: ...
    @overload
    def __getitem__(self, index: slice) -> list[DepthMap]: ...
    def __getitem__(self, index: int | slice) -> DepthMap | list[DepthMap]:
        selected = range(len(self))[index]
        return self._read(selected) if isinstance(selected, int) else [self._read(i) for i in selected]

    def __iter__(self) -> Iterator[DepthMap]:
        return (self._read(i) for i in range(len(self)))

    def _read(self, index: int) -> DepthMap:
        if self.folder is None:
            return self._in_memory[index]
        return _read_map(self.folder / _file_name(index), self.cameras[index].intrinsic)

    def _check(self, index: int, each: Any) -> None:
        if not isinstance(each, DepthMap):
            raise TypeError(f"maps[{index}]: expected a DepthMap, got {type(each).__name__}")
        if index < len(self.cameras):
            intrinsic = self.cameras[index].intrinsic
            if each.depth.shape != (intrinsic.height, intrinsic.width):
                size = f"{intrinsic.width} x {intrinsic.height}"
                given = f"{each.depth.shape[1]} x {each.depth.shape[0]}"
                raise ValueError(f"maps[{index}]: expected {size} pixels as its camera has, got {given}")


def _float32(name: str, values: ArrayLike) -> NDArray[np.float32]:
    """The values as read-only float32, without a copy if possible."""
    array = check_numeric(name, values)
    with np.errstate(over="ignore"):
        array = np.ascontiguousarray(array, np.float32)
    if not np.isfinite(array).all():
        check_finite(name, np.asarray(values))
        raise ValueError(f"{name}: a number is beyond the range of float32")
    view = array.view()
    view.flags.writeable = False
    return view


def made_folder(folder: FilePath) -> Path:
    """Create the folder if missing, and delete its index, which marks it incomplete."""
    path = unlinked_folder(path_of(folder, "folder"))
    with os_errors(path, "written"):
        (path / INDEX).unlink(missing_ok=True)
    return path


def unlinked_folder(path: Path) -> Path:
    """Create a folder if missing. Raises FileError if it contains symbolic links, which would redirect its files."""
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(path, f"no folder can be created here: {error.strerror or error}") from error
    refuse_links(path)
    return path


def _file_name(index: int) -> str:
    return f"{index:06d}.npz"


def _write_map(path: Path, each: DepthMap) -> None:
    arrays = (each.depth, each.normals.reshape(-1, 3), each.confidence)
    with atomic_write(path) as file, zipfile.ZipFile(file, "w", zipfile.ZIP_STORED) as archive:
        for name, values in zip(_MEMBERS, arrays, strict=True):
            member = zipfile.ZipInfo(f"{name}.npy", _TIME_STAMP)
            with archive.open(member, "w", force_zip64=True) as stream:
                np.lib.format.write_array(stream, values, allow_pickle=False)


def _read_map(path: Path, intrinsic: PinholeCameraIntrinsic) -> DepthMap:
    arrays = {}
    try:
        with (
            input_path(path).open("rb") as file,
            foreign_errors(path, "is not an intact archive", remedy=AGAIN),
            zipfile.ZipFile(file) as archive,
        ):
            names = [info.filename for info in archive.infolist()]
            if names != [f"{name}.npy" for name in _MEMBERS]:
                raise FileError(path, f"expected the arrays {', '.join(_MEMBERS)}, got {names}", remedy=AGAIN)
            for info in archive.infolist():
                name = info.filename.removesuffix(".npy")
                arrays[name] = read_member(path, archive, info, name)
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}", remedy=AGAIN) from error
    size = (intrinsic.height, intrinsic.width)
    shapes = (size, (size[0] * size[1], 3), size)
    for (name, values), shape in zip(arrays.items(), shapes, strict=True):
        if values.shape != shape or values.dtype != np.float32:
            reason = f"{name}: expected float32 {list(shape)}, got {values.dtype} {list(values.shape)}"
            raise FileError(path, reason, remedy=AGAIN)
    try:
        return DepthMap(arrays["depth"], arrays["normals"].reshape(*size, 3), arrays["confidence"])
    except ValueError as error:
        raise FileError(path, str(error), remedy=AGAIN) from error


def _write_index(path: Path, cameras: Sequence[PosedCamera], sources: Sequence[Sequence[int]]) -> None:
    listed = [
        {**intrinsic_to_json(each.intrinsic), "T_camera_world": each.T_camera_world.T.ravel().tolist()}
        for each in cameras
    ]
    content = {"version": FORMAT_VERSION, "cameras": listed, "sources": [list(each) for each in sources]}
    with atomic_write(path) as file:
        file.write(json.dumps(content, indent=1, allow_nan=False).encode() + b"\n")


def _read_index(path: Path) -> tuple[tuple[PosedCamera, ...], tuple[tuple[int, ...], ...]]:
    if path.parent.is_dir() and not path.exists():
        raise FileError(path.parent, f"contains no finished depth maps: {INDEX} is missing", remedy=AGAIN)
    content = read_json_object(path)
    check_keys(path, content, required={"version", "cameras", "sources"})
    if content["version"] != FORMAT_VERSION:
        raise FileError(path, f"expected version {FORMAT_VERSION}, got {content['version']!r}", where="key version")
    if not isinstance(content["cameras"], list):
        raise FileError(path, "expected a list", where="key cameras")
    cameras = tuple(_read_camera(path, each, f"cameras[{i}].") for i, each in enumerate(content["cameras"]))
    try:
        return cameras, check_sources("sources", content["sources"], len(cameras))
    except (TypeError, ValueError) as error:
        raise FileError(path, str(error), where="key sources", remedy=AGAIN) from error


def _read_camera(path: Path, content: Any, where: str) -> PosedCamera:
    if not isinstance(content, dict):
        raise FileError(path, "expected an object", where=f"key {where[:-1]}")
    check_keys(path, content, required={"width", "height", "intrinsic_matrix", "T_camera_world"}, where=where)
    K = read_json_matrix(path, content["intrinsic_matrix"], 3, where=f"key {where}intrinsic_matrix")
    pose = read_json_matrix(path, content["T_camera_world"], 4, where=f"key {where}T_camera_world")
    try:
        return PosedCamera(PinholeCameraIntrinsic.from_matrix(K, content["width"], content["height"]), pose)
    except (TypeError, ValueError) as error:
        raise FileError(path, str(error), where=f"key {where[:-1]}") from error
