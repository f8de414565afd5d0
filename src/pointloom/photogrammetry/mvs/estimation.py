"""Multi-view stereo: input checks and the pipeline of `loom.photogrammetry.estimate_depth_maps`."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_list, check_numeric, check_progress, check_seed
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.paths import path_of
from ...core.progress import ReportProgress
from ...io.images.image_files import read_color, read_image_header
from .depth_maps import DepthMap, DepthMaps, made_folder, unlinked_folder
from .image_slots import Image, other_size
from .plane_search import Setting, find_depth, motion_of
from .posed_images import PosedCamera, SparsePoints, check_cameras, check_sources, check_sparse
from .semi_global import find_pair_depth, plan_search
from .sources import choose_sources, depth_in_view

Mask = str | os.PathLike[str] | NDArray[np.bool_] | NDArray[np.uint8] | None
MASK_THRESHOLD = 128  # brightness threshold of masks


def check_image_masks(masks: Any, cameras: Sequence[PosedCamera]) -> list[Path | NDArray[np.bool_] | None]:
    given = check_list("masks", masks, "masks")
    if len(given) != len(cameras):
        raise ValueError(f"masks: expected one, or None, for each of the {len(cameras)} images, got {len(given)}")
    out: list[Path | NDArray[np.bool_] | None] = []
    for i, (each, camera) in enumerate(zip(given, cameras, strict=True)):
        lens = camera.intrinsic
        if isinstance(each, str | os.PathLike):
            header = read_image_header(each)
            if (header.width, header.height) != (lens.width, lens.height):
                reason = (
                    f"expected a mask of {lens.width} x {lens.height} pixels as its image, got "
                    f"{header.width} x {header.height}"
                )
                raise FileError(each, reason, remedy="Create masks of the size of their images")
            out.append(Path(each))
        else:
            out.append(None if each is None else _checked(f"masks[{i}]", each, (lens.height, lens.width)))
    return out


def _checked(name: str, mask: Any, size: tuple[int, int]) -> NDArray[np.bool_]:
    if not isinstance(mask, np.ndarray) or mask.dtype not in (np.bool_, np.uint8):
        kind = mask.dtype if isinstance(mask, np.ndarray) else type(mask).__name__
        raise TypeError(f"{name}: expected a path, or an array of bool or uint8, got {kind}")
    if mask.shape != size:
        raise ValueError(f"{name}: expected shape {list(size)} as of its image, got {list(mask.shape)}")
    return mask.copy() if mask.dtype == np.bool_ else mask >= MASK_THRESHOLD


def emptied(
    maps: Iterator[DepthMap], masks: Sequence[Path | NDArray[np.bool_] | None], cameras: Sequence[PosedCamera]
) -> Iterator[DepthMap]:
    for each, mask, camera in zip(maps, masks, cameras, strict=True):
        if mask is None:
            yield each
            continue
        visible = read_color(mask).max(axis=2) >= MASK_THRESHOLD if isinstance(mask, Path) else mask
        if visible.shape != (camera.intrinsic.height, camera.intrinsic.width):
            raise FileError(str(mask), "was changed during the estimation", remedy="Begin again")
        normals = np.where(visible[..., None], each.normals, np.float32(0))
        yield DepthMap(
            np.where(visible, each.depth, np.float32(0)), normals, np.where(visible, each.confidence, np.float32(0))
        )


MIN_IMAGE = 8  # [px] minimum side
MAX_SOURCES = 8  # device code counts sources in vectors of eight
MIN_POINTS = 3  # minimum points per image for a depth range
LOW_DEPTH_QUANTILE, HIGH_DEPTH_QUANTILE = 0.02, 0.98  # quantiles of the point depths: some are wrong
MIN_DEPTH_FACTOR, MAX_DEPTH_FACTOR = 0.7, 1.5  # margin of the depth range
MIN_MOTION = 1.0  # [px] minimum image motion over the depth range in a useful source
DEVICE_BYTES = 2**30
NO_POINTS = SparsePoints(np.zeros((0, 3)), np.zeros((0, 2), np.int64))
METHODS = ("patch_match", "sgm")
REMEDY = "move the camera between images, instead of only rotating it"


def estimate_depth_maps(
    images: Iterable[Image],
    cameras: Iterable[PosedCamera],
    sparse: Any = None,
    *,
    sources: Iterable[Iterable[int]] | None = None,
    masks: Iterable[Mask] | None = None,
    method: str = "patch_match",
    seed: int = 0,
    device: DeviceLike = None,
    folder: FilePath | None = None,
    resume_from: FilePath | None = None,
    device_bytes: int = DEVICE_BYTES,
    progress: ReportProgress | None = None,
) -> DepthMaps:
    """Estimate depth maps of images with known cameras by multi-view stereo.

    PatchMatch over planes from a quarter to full resolution. The last passes enforce consistency with the sources.
    Textureless regions take a plane fitted to reliable depth around them. Then use `filter_depth_maps`. For a pair,
    `method="sgm"` is semi-global matching: about a tenth of the time, less complete, and without depth where the images
    disagree or have no texture.

    Args:
        images: Undistorted images: paths of PNG or JPEG files, or uint8 arrays [h, w] or [h, w, 3] of any sizes.
        cameras: A PosedCamera for each.
        sparse: An object with `points` [m, 3] and `observations` [k, 2] (image, point), such as an SfmModel, for depth
            ranges and source selection. None or empty: estimated from frustum intersections, slightly less complete;
            `photogrammetry.triangulate` computes points.
        sources: Numbers of up to 8 source images for each image; None: `choose_sources`.
        masks: For each image a gray PNG of its size (path, black where excluded), an array [h, w], bool or uint8, or
            None. Excluded pixels get no depth, and none from sources in `filter_depth_maps`.
        method: "patch_match", or "sgm" for exactly two images from cameras side by side, rectified or not.
        seed: Seed of the plane hypotheses; no effect on "sgm".
        device: "cpu", "cuda:0", "auto"; None: the CPU.
        folder: Folder for the maps, one file per image; None: in memory.
        resume_from: Checkpoint folder: a repeated call with the same arguments resumes from it, bitwise identical.
            Delete it afterward. Do not use it with other arguments.
        device_bytes: Device memory limit for images and maps, exceeded if one image with its sources needs more.
        progress: Called with ("depth", steps done, steps in all).

    Returns:
        Maps at the image sizes. An image without sources from other positions has no depth and no `sources`. One with
        fewer than three points is searched within frustum intersections.

    Raises:
        TypeError: Arguments of other types, or images that are not uint8.
        ValueError: Fewer than two images, a wrong number of cameras, a wrong image size, or only rotations. With "sgm"
            also more images, cameras behind each other, or 2^31 pixels times disparities.
        FileError: An image or the folder cannot be read or written.
        DeviceError: No such device.

    Notes:
        Bitwise reproducible for any number of threads. Device memory: 24 B per pixel of each cached image, up to 96 B
        more for the current one. Host memory (or `folder`): 32 B per pixel of all images. Galliani et al. 2015. Xu and
        Tao, "Multi-scale geometric consistency guided multi-view stereo", CVPR 2019, and "Planar prior assisted
        PatchMatch multi-view stereo", AAAI 2020. "sgm": 3 B per pixel and disparity of the depth range, whatever
        `device_bytes` is, and no checkpoints. Hirschmueller, "Stereo processing by semiglobal matching and mutual
        information", PAMI 2008.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.photogrammetry.mvs.posed_images import SparsePoints
        >>> wall = np.random.default_rng(0).integers(0, 255, (40, 60), dtype=np.uint8).repeat(2, 0).repeat(2, 1)
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> right = np.eye(4)
        >>> right[0, 3] = -0.2  # 6 pixels at 2 m
        >>> cameras = [loom.photogrammetry.PosedCamera(camera, pose) for pose in (np.eye(4), right)]
        >>> points = [[x, y, 2.0] for x in (-0.5, 0.0, 0.5) for y in (-0.4, 0.4)]
        >>> sparse = SparsePoints(points, [[i, k] for i in (0, 1) for k in range(6)])
        >>> images = [wall[:48, 10:74], wall[:48, 16:80]]
        >>> maps = loom.photogrammetry.estimate_depth_maps(images, cameras, sparse, sources=[[1], [0]])
        >>> round(float(np.median(maps[0].depth)), 1)
        2.0
        >>> pair = loom.photogrammetry.estimate_depth_maps(images, cameras, sparse, method="sgm")
        >>> depth = pair[0].depth
        >>> round(float(np.median(depth[depth > 0])), 1)
        2.0
    """
    posed = check_cameras("cameras", cameras)
    given = _checked_images(images, posed)
    _check_method(method, len(posed))
    points = check_sparse("sparse", NO_POINTS if sparse is None else sparse)
    ranges = [_depth_range(points, i, posed) for i in range(len(posed))]
    if sources is None:
        wanted = choose_sources(posed, points)
    else:
        wanted = check_sources("sources", sources, len(posed))
        for i, each in enumerate(wanted):
            if len(each) > MAX_SOURCES:
                raise ValueError(f"sources[{i}]: expected up to {MAX_SOURCES} images, got {len(each)}")
    check_seed(seed)
    report = check_progress(progress)
    check_count("device_bytes", device_bytes, minimum=0, maximum=2**40, because="no device has more memory")
    target = resolve_device(device)
    informative = _informative_sources(wanted, posed, ranges)
    if not any(informative):
        raise ValueError(f"cameras: no image has a source image from another position; {REMEDY}")
    known = [each or (1.0, 2.0) for each in ranges]
    search = plan_search(posed, known) if method == "sgm" else None
    output = None if folder is None else made_folder(folder)
    hidden = [None] * len(posed) if masks is None else check_image_masks(masks, posed)
    setting = Setting(given, posed, informative, known, seed, target, device_bytes)
    so_far = None if resume_from is None else unlinked_folder(path_of(resume_from, "resume_from"))
    found = find_depth(setting, output, report, so_far) if search is None else find_pair_depth(setting, search, report)
    maps = emptied(found, hidden, posed)
    return DepthMaps(posed, informative, maps, folder=output)


def _check_method(method: Any, count: int) -> None:
    if not isinstance(method, str):
        raise TypeError(f"method: expected a name, got {type(method).__name__}")
    if method not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    if method == "sgm" and count != 2:
        raise ValueError(f'images: expected 2 with method="sgm", got {count}. Pass method="patch_match".')


def _checked_images(images: Any, cameras: Sequence[PosedCamera]) -> list[Image]:
    given = check_list("images", images, "images")
    if len(given) < 2:
        raise ValueError(f"images: expected at least 2, got {len(given)}; depth is estimated by comparing images")
    if len(given) != len(cameras):
        raise ValueError(f"cameras: expected one for each of the {len(given)} images, got {len(cameras)}")
    out: list[Image] = []
    for i, (image, camera) in enumerate(zip(given, cameras, strict=True)):
        size = (camera.intrinsic.height, camera.intrinsic.width)
        if min(size) < MIN_IMAGE:
            raise ValueError(f"cameras[{i}]: expected at least {MIN_IMAGE} pixels a side, got {size[1]} x {size[0]}")
        if isinstance(image, str | os.PathLike):
            _check_file(Path(image), size)
            out.append(Path(image))
        else:
            out.append(_check_array(f"images[{i}]", image, size))
    return out


def _check_file(path: Path, size: tuple[int, int]) -> None:
    from ...io.images.image_files import check_color_header, read_image_header

    header = read_image_header(path)
    check_color_header(path, header)
    if (header.height, header.width) != size:
        reason = other_size("", (header.height, header.width), size)
        raise FileError(path, reason, remedy="Give the camera of this image")


def _check_array(name: str, image: Any, size: tuple[int, int]) -> NDArray[np.uint8]:
    array = check_numeric(name, image)
    if array.ndim not in (2, 3) or (array.ndim == 3 and array.shape[2] != 3):
        raise ValueError(f"{name}: expected shape [h, w] or [h, w, 3], got {list(array.shape)}")
    if array.dtype != np.uint8:
        remedy = "; divide 16-bit images by 256 first" if array.dtype == np.uint16 else ""
        raise TypeError(f"{name}: expected uint8, got {array.dtype}{remedy}")
    if array.shape[:2] != size:
        raise ValueError(other_size(f"{name}: ", array.shape, size))
    return np.ascontiguousarray(array)


def _depth_range(sparse: SparsePoints, index: int, cameras: tuple[PosedCamera, ...]) -> tuple[float, float] | None:
    """Depth range of an image by its points or frustum intersections. None if there are none."""
    seen, T = sparse.points[sparse.seen_by(index)], cameras[index].T_camera_world
    z = seen @ T[2, :3] + T[2, 3]
    z = z[z > 0]
    if len(z) < MIN_POINTS:
        span = depth_in_view(index, cameras, LOW_DEPTH_QUANTILE, HIGH_DEPTH_QUANTILE)
    else:
        span = tuple(float(each) for each in np.quantile(z, [LOW_DEPTH_QUANTILE, HIGH_DEPTH_QUANTILE]))
    return None if span is None else (span[0] * MIN_DEPTH_FACTOR, span[1] * MAX_DEPTH_FACTOR)


def _informative_sources(
    sources: Sequence[Sequence[int]], cameras: Sequence[PosedCamera], ranges: Sequence[tuple[float, float] | None]
) -> tuple[tuple[int, ...], ...]:
    """The sources with parallax. None for images without a depth range."""
    out = []
    for i, (numbers, span) in enumerate(zip(sources, ranges, strict=True)):
        inverse_range = 0.0 if span is None else 1 / span[0] - 1 / span[1]
        out.append(tuple(j for j in numbers if motion_of(cameras[i], cameras[j]) * inverse_range >= MIN_MOTION))
    return tuple(out)
