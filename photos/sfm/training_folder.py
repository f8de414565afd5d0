"""A folder that gsplat, the 3DGS of Inria and nerfstudio train from.

Straight pictures, COLMAP's model and transforms.json.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.undistortion import Undistortion
from ...core.atomic import atomic_folder
from ...core.checks import check_count, check_progress
from ...core.coordinates import choose_origin
from ...core.devices import resolve_device
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...core.reports import Fields, Report
from ...files.models.colmap import write_colmap_model
from ...files.models.sfm_model import SfmModel
from ...files.models.transforms_writer import write_content
from .masks import write_mask
from .picture_folder import check_place
from .straightened import straightened_model
from .training_pictures import find_masks, find_pictures, is_copied, new_names, straight_mask, unseen_of, write_straight

TRANSFORMS, IMAGES, MASKS, SPARSE = "transforms.json", "images", "masks", "sparse/0"  # by what a folder is known

Picture = str | os.PathLike[str] | NDArray[np.uint8]
Mask = str | os.PathLike[str] | NDArray[np.bool_] | NDArray[np.uint8] | None


@dataclass(frozen=True)
class TrainingFolder(Report):
    """What `write_training_folder` wrote.

    Attributes:
        folder: Where.
        picture_count: Pictures in it.
        straightened_count: Of them those that were straightened or made smaller; the others are copies.
        sizes: Width and height of the pictures, each once [px].
        point_count: Sparse points.
        mask_count: Masks; of all pictures, or none.
        origin: What was taken from all coordinates, float64; zeros where nothing was. A place of the folder and this
            are the place in the model's frame.
        off_center: How far a principal point is from the middle of its picture, at most [px]: trainers that know
            focal lengths alone, as that of Inria, are wrong by so much.
    """

    folder: str
    picture_count: int
    straightened_count: int
    sizes: tuple[tuple[int, int], ...]
    point_count: int
    mask_count: int
    origin: tuple[float, float, float]
    off_center: float

    def fields(self) -> Fields:
        """The same as labels and values."""
        sizes = ", ".join(f"{width} x {height}" for width, height in self.sizes)
        straight = f", {self.straightened_count} straightened" if self.straightened_count else ""
        masks = f", {self.mask_count} masks" if self.mask_count else ""
        rows = [("pictures", f"{self.picture_count} of {sizes}{straight}{masks}")]
        rows.append(("points", f"{self.point_count:,}"))
        if any(self.origin):
            rows.append(("origin", f"{' '.join(f'{value:.0f}' for value in self.origin)}, taken from all coordinates"))
        rows.append(("principal", f"points up to {self.off_center:.1f} px off the middle"))
        return rows


def write_training_folder(
    folder: FilePath,
    model: SfmModel,
    pictures: FilePath | Iterable[Picture],
    *,
    masks: FilePath | Iterable[Mask] | None = None,
    max_size: int | None = None,
    shift: bool = True,
    device: Any = None,
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> TrainingFolder:
    """Write a folder that gsplat, the 3DGS of Inria and nerfstudio train from.

    It holds `images/`, without distortion (these trainers want pinholes), `sparse/0` with cameras.bin, images.bin and
    points3D.bin (colours, and which pictures see a point), `transforms.json` and `sparse_pc.ply` with the same in
    OpenGL's convention, and `masks/` where there are some.

    Args:
        folder: A new folder, or one of this kind with `overwrite`.
        model: Lenses, poses and points: `result.model` of a video, `read_colmap_model`, `read_cameras`, or your own.
        pictures: The folder of the pictures that the model names, as they came from the lens; or for each of
            `model.names` a path or an array, uint8 [h, w, 3] or [h, w].
        masks: A folder of grey masks, IMG_1.jpg.png of IMG_1.jpg, black where the picture is left out; or for each
            picture a path, an array [h, w], bool or uint8, or None.
        max_size: Longer pictures are made smaller [px]; None for none.
        shift: Whether a model whose coordinates are beyond 10 km, as of UTM, comes near zero: trainers hold places in
            float32, half a metre there. By whole metres; `applied_transform` of transforms.json and the result tell it.
        device: Where pictures are straightened; None for the CPU.
        overwrite: Replace such a folder.
        progress: Called with "pictures", how many are written, and how many there are.

    Returns:
        What was written, with what was taken from the coordinates.

    Raises:
        TypeError, ValueError: An argument out of range, no picture in the model, not as many pictures as it has.
        FileError: A picture that is missing, damaged or of another size than its camera, a mask likewise; a place that
            cannot be written, or that holds something else.
        DeviceError: No such device.

    Notes:
        Whole or not at all. The same bytes from run to run. Pictures without distortion, upright, and not too large are
        copied as they are; the others are PNG. Folders in names are left out, since the trainer of Inria knows none.
        What lies outside of the straightened pictures is seen by none of them. Where a lens leaves more than a
        thousandth of a picture blank, masks hide that. The unit is the model's, and nothing is scaled.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("SIMPLE_RADIAL", 64, 48, [50, 32, 24, -0.1])
        >>> model = loom.SfmModel(["a.png"], [camera], np.eye(4)[None], points=[[0.1, 0.2, 2.0]])
        >>> written = loom.sfm.write_training_folder("scene", model, [np.full((48, 64, 3), 90, np.uint8)])
        >>> written.sizes, loom.read_colmap_model("scene/sparse/0").cameras[0].model
        (((65, 48),), 'PINHOLE')
    """
    place = check_place("folder", folder)
    _check_given(model, shift=shift, overwrite=overwrite)
    if max_size is not None:
        check_count("max_size", max_size, minimum=16, maximum=2**16, because="no camera has more pixels")
    target, say = resolve_device(device), check_progress(progress)
    given, hidden = find_pictures(pictures, model), find_masks(masks, model)
    known = {camera: Undistortion(camera, max_size=max_size, device=target) for camera in dict.fromkeys(model.cameras)}
    unseen = {camera: unseen_of(lens) for camera, lens in known.items()}
    lenses = [known[camera] for camera in model.cameras]
    copied = [is_copied(picture, lens.camera, lens) for picture, lens in zip(given, lenses, strict=True)]
    with_masks = any(each is not None for each in (*hidden, *unseen.values()))  # of all or none: nerfstudio wants that
    names = new_names(model.names, copied)
    with atomic_folder(place, TRANSFORMS, overwrite=overwrite) as part:
        for name in (IMAGES, *([MASKS] if with_masks else [])):
            (part / name).mkdir()
        for k, lens in enumerate(lenses):
            say("pictures", k, len(lenses))
            write_straight(part / IMAGES / names[k], given[k], lens, copied=copied[k])
            if with_masks:
                write_mask(part / MASKS, names[k], straight_mask(hidden[k], lens, unseen[lens.camera]))
        say("pictures", len(lenses), len(lenses))
        straight = [lens.intrinsic for lens in lenses]
        origin = _origin_of(model) if shift else np.zeros(3)
        _write_models(part, model, names, straight, origin, with_masks=with_masks)
    return TrainingFolder(
        folder=os.fspath(place),
        picture_count=len(model),
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
        raise ValueError("model: expected at least one picture, got none")
    for name, value in flags.items():
        if not isinstance(value, bool):
            raise TypeError(f"{name}: expected True or False, got {type(value).__name__}")


def _origin_of(model: SfmModel) -> NDArray[np.float64]:
    """Where the model lies, in whole metres; zeros where float32 holds it as it is."""
    return choose_origin(np.concatenate([model.centers, model.points]))


def _write_models(
    folder: Path,
    model: SfmModel,
    names: list[str],
    cameras: list[PinholeCameraIntrinsic],
    origin: NDArray[np.float64],
    *,
    with_masks: bool,
) -> None:
    """The same model in COLMAP's files and in nerfstudio's."""
    T, more = np.eye(4), {}
    if origin.any():
        T[:3, 3] = -origin
        model = model.transform(T)
        more = {"applied_transform": T[:3].tolist(), "applied_scale": 1.0}
    whole = _as_seen(straightened_model(model, names, cameras))
    write_colmap_model(folder / SPARSE, whole)
    masks = [f"{MASKS}/{name}.png" for name in whole.names] if with_masks else None
    write_content(folder / TRANSFORMS, whole, pictures=IMAGES, masks=masks, more=more)


def _as_seen(model: SfmModel) -> SfmModel:
    """The model without what lies outside of the straightened pictures, and with the errors that points have there."""
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
    """How far the principal point is from the middle of the picture [px]."""
    return max(abs(camera.cx - (camera.width - 1) / 2), abs(camera.cy - (camera.height - 1) / 2))
