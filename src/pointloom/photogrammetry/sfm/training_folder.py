"""Export of undistorted images and poses for 3DGS training: gsplat, Inria's 3DGS and nerfstudio."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path, PurePosixPath
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.camera_models import CameraModel
from ...cameras.undistortion import Undistortion
from ...core.atomic import atomic_folder
from ...core.checks import check_count, check_list, check_progress
from ...core.coordinates import choose_origin
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from ...core.reports import Fields, Report
from ...io.images.image_files import write_png
from ...io.images.photo_files import is_photo
from ...io.models.colmap import write_colmap_model
from ...io.models.sfm_model import SfmModel
from ...io.models.transforms_writer import write_content
from .image_folder import EXIF_UPRIGHT, check_path, is_gray_16, read_header, read_orientation, read_stored
from .image_writing import write_bytes
from .masks import MASK_THRESHOLD, masks_in, read_mask, write_mask
from .straightened import straightened_model

MIN_UNSEEN = 0.001  # fraction of blank pixels below which no mask is written
_SUFFIXES = {"jpeg": (".jpg", ".jpeg"), "png": (".png",)}

Pixels = NDArray[np.uint8]


def find_images(images: Any, model: SfmModel) -> list[Path | Pixels]:
    if isinstance(images, str | os.PathLike):
        folder = check_path("images", images)
        given: list[Any] = [folder / name for name in model.names]
    else:
        given = check_list("images", images, "paths or images")
    if len(given) != len(model):
        raise ValueError(f"images: expected one for each of the {len(model)} images of the model, got {len(given)}")
    result: list[Path | Pixels] = []
    for k, (each, camera) in enumerate(zip(given, model.cameras, strict=True)):
        size = camera.width, camera.height
        if not isinstance(each, str | os.PathLike):
            result.append(_checked_array(f"images[{k}]", each, size))
            continue
        path = check_path(f"images[{k}]", each)
        if not path.is_file():
            raise FileError(path, "does not exist", remedy="Give the folder that contains the images of the model")
        header = read_header(path)
        if (header.width, header.height) != size:
            reason = f"expected {size[0]} x {size[1]} pixels as of its camera, got {header.width} x {header.height}"
            raise FileError(path, reason, remedy="Give the images in the size for which the cameras were estimated")
        if is_gray_16(header):
            raise FileError(path, "expected an 8-bit image, got 16-bit gray", remedy="Convert it to 8 bits")
        result.append(path)
    return result


def _checked_array(name: str, value: object, size: tuple[int, int]) -> Pixels:
    array = np.asarray(value)
    if array.dtype != np.uint8:
        raise TypeError(f"{name}: expected a path or uint8, got {array.dtype}")
    if array.shape not in ((size[1], size[0]), (size[1], size[0], 3)):
        raise ValueError(f"{name}: expected shape {[size[1], size[0], 3]}, as of its camera, got {list(array.shape)}")
    return array if array.ndim == 3 else np.repeat(array[..., None], 3, axis=2)


def find_masks(masks: Any, model: SfmModel) -> list[NDArray[np.bool_] | Path | None]:
    if masks is None:
        return [None] * len(model)
    if isinstance(masks, str | os.PathLike):
        folder = check_path("masks", masks)
        paths = masks_in(folder, model.names)
        if not any(paths):
            reason = f"contains no mask of an image, such as {model.names[0]}.png"
            raise FileError(folder, reason, remedy="Name masks like their images, with .png appended")
        return [*paths]
    given = check_list("masks", masks, "masks")
    if len(given) != len(model):
        raise ValueError(f"masks: expected one, or None, for each of the {len(model)} images, got {len(given)}")
    result: list[NDArray[np.bool_] | Path | None] = []
    for k, (each, camera) in enumerate(zip(given, model.cameras, strict=True)):
        if each is None or isinstance(each, str | os.PathLike):
            result.append(None if each is None else check_path(f"masks[{k}]", each))
            continue
        array = np.asarray(each)
        if array.dtype not in (np.bool_, np.uint8):
            raise TypeError(f"masks[{k}]: expected a path, or an array of bool or uint8, got {array.dtype}")
        if array.shape != (camera.height, camera.width):
            raise ValueError(f"masks[{k}]: expected shape {[camera.height, camera.width]}, got {list(array.shape)}")
        result.append(array if array.dtype == np.bool_ else array >= MASK_THRESHOLD)
    return result


def is_straight(camera: CameraModel, lens: Undistortion) -> bool:
    return camera.is_pinhole and (camera.width, camera.height) == (lens.intrinsic.width, lens.intrinsic.height)


def is_copied(image: Path | Pixels, camera: CameraModel, lens: Undistortion) -> bool:
    """True if an image can be copied unchanged: upright, 8 bit, undistorted, in a common format."""
    if not isinstance(image, Path) or not is_straight(camera, lens) or is_photo(image):
        return False
    header = read_header(image)
    known = image.suffix.lower() in _SUFFIXES.get(header.kind, ())
    return known and header.bits == 8 and header.channels in (1, 3) and read_orientation(image) == EXIF_UPRIGHT


def new_names(names: Sequence[str], copied: Sequence[bool]) -> list[str]:
    """Unique image names, without folders if possible, with .png unless copied."""
    plain = [PurePosixPath(name.replace(os.sep, "/")) for name in names]
    bare = [path.name if is_copy else f"{path.stem}.png" for path, is_copy in zip(plain, copied, strict=True)]
    if max(Counter(name.casefold() for name in bare).values()) > 1:
        bare = ["_".join(path.parts) + ("" if is_copy else ".png") for path, is_copy in zip(plain, copied, strict=True)]
    if max(Counter(name.casefold() for name in bare).values()) > 1:
        digits = len(str(len(names)))
        bare = [f"{k:0{digits}d}_{name}" for k, name in enumerate(bare)]
    return bare


def write_straight(path: Path, image: Path | Pixels, lens: Undistortion, *, copied: bool) -> None:
    if copied:
        assert isinstance(image, Path)
        read_stored(image)  # report damage here, not in the trainer
        write_bytes(path, image.read_bytes())
        return
    write_png(path, lens.apply(read_stored(image) if isinstance(image, Path) else image))


def straight_mask(
    mask: NDArray[np.bool_] | Path | None, lens: Undistortion, unseen: NDArray[np.bool_] | None
) -> NDArray[np.bool_]:
    """Valid pixels of an undistorted image: inside the mask and seen by the lens."""
    if isinstance(mask, Path):
        mask = read_mask(mask, (lens.camera.width, lens.camera.height))
    if mask is None:
        valid = np.ones((lens.intrinsic.height, lens.intrinsic.width), bool)
    elif is_straight(lens.camera, lens):
        valid = mask
    else:
        valid = lens.apply(np.where(mask, 255, 0).astype(np.uint8)) >= MASK_THRESHOLD
    return valid if unseen is None else valid & ~unseen


def unseen_of(lens: Undistortion) -> NDArray[np.bool_] | None:
    """Pixels of the undistorted image outside the lens image. None if negligible."""
    if is_straight(lens.camera, lens):
        return None
    unseen = ~lens.seen
    return unseen if unseen.mean() > MIN_UNSEEN else None


TRANSFORMS, IMAGES, MASKS, SPARSE = "transforms.json", "images", "masks", "sparse/0"  # identify such a folder

Image = str | os.PathLike[str] | NDArray[np.uint8]
Mask = str | os.PathLike[str] | NDArray[np.bool_] | NDArray[np.uint8] | None


@dataclass(frozen=True)
class TrainingFolder(Report):
    """Result of `write_training_folder`.

    Attributes:
        folder: Its path.
        image_count: Number of images.
        straightened_count: Undistorted or downscaled images. The others are copies.
        sizes: Unique image widths and heights [px].
        point_count: Sparse points.
        mask_count: Masks: for all images, or none.
        origin: Offset subtracted from all coordinates, float64, or zeros if none.
        off_center: Maximum offset of a principal point from the image center [px], which Inria's trainer ignores.
    """

    folder: str
    image_count: int
    straightened_count: int
    sizes: tuple[tuple[int, int], ...]
    point_count: int
    mask_count: int
    origin: tuple[float, float, float]
    off_center: float

    def fields(self) -> Fields:
        sizes = ", ".join(f"{width} x {height}" for width, height in self.sizes)
        straight = f", {self.straightened_count} straightened" if self.straightened_count else ""
        masks = f", {self.mask_count} masks" if self.mask_count else ""
        rows = [("images", f"{self.image_count} of {sizes}{straight}{masks}")]
        rows.append(("points", f"{self.point_count:,}"))
        if any(self.origin):
            rows.append(
                ("origin", f"{' '.join(f'{value:.0f}' for value in self.origin)}, subtracted from all coordinates")
            )
        rows.append(("principal", f"points up to {self.off_center:.1f} px off the middle"))
        return rows


def write_training_folder(
    folder: FilePath,
    model: SfmModel,
    images: FilePath | Iterable[Image],
    *,
    masks: FilePath | Iterable[Mask] | None = None,
    max_size: int | None = None,
    shift: bool = True,
    device: DeviceLike = None,
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> TrainingFolder:
    """Write a training folder for gsplat, Inria's 3DGS and nerfstudio.

    Contains `images/` (undistorted), `sparse/0` with cameras.bin, images.bin and points3D.bin (with colors and tracks),
    `transforms.json` and `sparse_pc.ply` in OpenGL's convention, and `masks/` if given.

    Args:
        folder: A new folder, or one of this kind with `overwrite`.
        model: Cameras, poses and points: `result.model` of a video, `read_cameras`, or your own.
        images: Folder of the original images; or for each of `model.names` a path or uint8 [h, w, 3] or [h, w].
        masks: Folder of gray masks, IMG_1.jpg.png for IMG_1.jpg, black where excluded; or for each image a path, an
            array [h, w], bool or uint8, or None.
        max_size: Maximum image side [px]; None: no limit.
        shift: Move models beyond 10 km (UTM) near zero by whole meters, since trainers use float32 (half a meter
            there). Recorded in `applied_transform` of transforms.json and in the result.
        device: Device of the undistortion; None: the CPU.
        overwrite: Replace such a folder.
        progress: Called with ("images", done, all).

    Returns:
        A summary, with the coordinate offset.

    Raises:
        TypeError, ValueError: An argument out of range, no image in the model, or a wrong number of images.
        FileError: An image or mask is missing, damaged or of a wrong size. The folder cannot be written or replaced.
        DeviceError: No such device.

    Notes:
        Atomic and byte-for-byte reproducible. Suitable images are copied, the others are PNG. Folders in names are
        removed (Inria). Observations outside the undistorted images are removed. Masks hide blank borders above a
        thousandth of an image. Coordinates are not scaled.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("SIMPLE_RADIAL", 64, 48, [50, 32, 24, -0.1])
        >>> model = loom.SfmModel(["a.png"], [camera], np.eye(4)[None], points=[[0.1, 0.2, 2.0]])
        >>> written = loom.photogrammetry.write_training_folder("scene", model, [np.full((48, 64, 3), 90, np.uint8)])
        >>> written.sizes, loom.read_cameras("scene/sparse/0").cameras[0].model
        (((65, 48),), 'PINHOLE')
    """
    path = check_path("folder", folder)
    _check_given(model, shift=shift, overwrite=overwrite)
    if max_size is not None:
        check_count("max_size", max_size, minimum=16, maximum=2**16, because="no camera has more pixels")
    target, report = resolve_device(device), check_progress(progress)
    given, hidden = find_images(images, model), find_masks(masks, model)
    known = {camera: Undistortion(camera, max_size=max_size, device=target) for camera in dict.fromkeys(model.cameras)}
    unseen = {camera: unseen_of(lens) for camera, lens in known.items()}
    lenses = [known[camera] for camera in model.cameras]
    copied = [is_copied(image, lens.camera, lens) for image, lens in zip(given, lenses, strict=True)]
    with_masks = any(each is not None for each in (*hidden, *unseen.values()))  # all or none, as nerfstudio requires
    names = new_names(model.names, copied)
    with atomic_folder(path, TRANSFORMS, overwrite=overwrite) as part:
        for name in (IMAGES, *([MASKS] if with_masks else [])):
            (part / name).mkdir()
        for k, lens in enumerate(lenses):
            report("images", k, len(lenses))
            write_straight(part / IMAGES / names[k], given[k], lens, copied=copied[k])
            if with_masks:
                write_mask(part / MASKS, names[k], straight_mask(hidden[k], lens, unseen[lens.camera]))
        report("images", len(lenses), len(lenses))
        straight = [lens.intrinsic for lens in lenses]
        positions = np.concatenate([model.centers, model.points])
        origin = choose_origin(positions, in_one_unit=True) if shift else np.zeros(3)
        _write_models(part, model, names, straight, origin, with_masks=with_masks)
    return TrainingFolder(
        folder=os.fspath(path),
        image_count=len(model),
        straightened_count=len(copied) - sum(copied),
        sizes=tuple(dict.fromkeys((camera.width, camera.height) for camera in straight)),
        point_count=len(model.points),
        mask_count=len(model) if with_masks else 0,
        origin=(float(origin[0]), float(origin[1]), float(origin[2])),
        off_center=max(_off_center(camera) for camera in straight),
    )


def _check_given(model: Any, **flags: Any) -> None:
    if not isinstance(model, SfmModel):
        raise TypeError(f"model: expected an SfmModel, got {type(model).__name__}")
    if not len(model):
        raise ValueError("model: expected at least one image, got none")
    for name, value in flags.items():
        if not isinstance(value, bool):
            raise TypeError(f"{name}: expected True or False, got {type(value).__name__}")


def _write_models(
    folder: Path,
    model: SfmModel,
    names: list[str],
    cameras: list[PinholeCameraIntrinsic],
    origin: NDArray[np.float64],
    *,
    with_masks: bool,
) -> None:
    T, more = np.eye(4), {}
    if origin.any():
        T[:3, 3] = -origin
        model = model.transform(T)
        more = {"applied_transform": T[:3].tolist(), "applied_scale": 1.0}
    undistorted = _as_seen(straightened_model(model, names, cameras))
    write_colmap_model(folder / SPARSE, undistorted)
    masks = [f"{MASKS}/{name}.png" for name in undistorted.names] if with_masks else None
    write_content(folder / TRANSFORMS, undistorted, images=IMAGES, masks=masks, more=more)


def _as_seen(model: SfmModel) -> SfmModel:
    sizes = np.array([(camera.width, camera.height) for camera in model.cameras])[model.observations[:, 0]]
    inside = ((model.pixels >= -0.5) & (model.pixels <= sizes - 0.5)).all(axis=1)
    observations, pixels = model.observations[inside], model.pixels[inside]
    off = np.zeros(len(pixels))
    for k, (camera, T) in enumerate(zip(model.cameras, model.T_camera_world, strict=True)):
        mine = observations[:, 0] == k
        at = camera.project(model.points[observations[mine, 1]] @ T[:3, :3].T + T[:3, 3])
        off[mine] = np.linalg.norm(at - pixels[mine], axis=1)
    known = np.isfinite(off)
    count = np.bincount(observations[known, 1], minlength=len(model.points))
    sums = np.bincount(observations[known, 1], off[known], minlength=len(model.points))
    errors = np.divide(sums, count, out=np.full(len(model.points), np.nan), where=count > 0)
    return replace(model, observations=observations, pixels=pixels, errors=errors)


def _off_center(camera: PinholeCameraIntrinsic) -> float:
    return max(abs(camera.cx - (camera.width - 1) / 2), abs(camera.cy - (camera.height - 1) / 2))
