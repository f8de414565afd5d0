"""Monocular depth estimation with an ONNX network, and the point cloud of the result."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera
from ...cameras.camera_models import CameraModel
from ...cameras.depth_range import DEPTH_SCALE
from ...cameras.images import RGBDImage, check_intrinsic
from ...core.checks import check_count, check_name, check_numeric, check_positive, check_progress, check_seed, shown
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from ...core.reports import Assessed, failed
from ...core.wording import few_of
from ...io.images.image_files import read_depth
from ...io.models.colmap import read_colmap_model
from ...io.models.sfm_model import SfmModel
from ...io.number_tables import TableForm, read_number_table
from ...kernels.images.flying_pixels import drop_flying
from ...pcd.cloud import PointCloud
from .alignment import MAX_DISTANCES, Alignment, align_inverse_depth, align_to_distances
from .inputs import Map
from .network import DepthModel
from .network_outputs import OwnCamera, Reading
from .photos import Photo, camera_of, take_photo
from .presets import NETWORK_PRESETS, Preset
from .tiles import MAX_TILES, refine_by_tiles

SPARSE = "the sparse model"
AXIS_ANGLE = 1e-3  # [rad] about the axis, where distortion is negligible
NO_DEPTH = 65535  # invalid integer depth besides 0, as in 7-Scenes
FORMS = "a sparse model, a depth map [h, w], or distances [n, 3] of u, v and meters; or the path of one"


@dataclasses.dataclass(frozen=True, eq=False)
class References:
    """Known `depths` [n] at `pixels` (column, row), [n, 2]; `are_few`: measured by hand, two suffice."""

    pixels: NDArray[np.float64]
    depths: NDArray[np.float64]
    are_few: bool = False
    unit: str = "m"
    camera: PinholeCameraIntrinsic | None = None
    source: str = ""


def find_references(align: Any, name: str | None, size: tuple[int, int], depth_scale: float) -> References:
    scale = check_positive("depth_scale", depth_scale)
    if isinstance(align, str | os.PathLike):
        align = _read(Path(align))
    if isinstance(align, tuple) and len(align) == 2 and isinstance(align[0], SfmModel):
        align, name = align[0], check_name("align", align[1])
    if isinstance(align, SfmModel):
        return _of_model(align, name, size)
    array = check_numeric("align", align)
    if array.ndim != 2 or 0 in array.shape:
        raise ValueError(f"align: expected {FORMS}, got {shown(align)} of shape {list(array.shape)}")
    return _of_distances(array, size) if array.shape[1] == 3 else _of_sensor(array, size, scale)


def _read(path: Path) -> Any:
    if path.is_dir():
        return read_colmap_model(path)
    suffix = path.suffix.lower()
    if suffix in (".png", ".npy"):
        return read_depth(path)
    if suffix in (".txt", ".csv"):
        return read_distances(path)
    remedy = "Use .png or .npy (a depth map), .txt or .csv (u v meters), or the folder of a COLMAP model"
    raise FileError(path, f"unknown extension {suffix!r}", remedy=remedy)


def read_distances(path: FilePath) -> NDArray[np.float64]:
    """Read lines of column, row and meters. A header may name them in any order; # begins a comment."""
    rows = read_number_table(path, DISTANCES)
    return np.array([[row.numbers[name] for name in ("u", "v", "meters")] for row in rows])


_COLUMNS = {"u": "u x column col", "v": "v y row", "meters": "meters metres m depth distance range"}
DISTANCES = TableForm(("u v meters",), synonyms=_COLUMNS)


def _of_distances(array: NDArray[Any], size: tuple[int, int]) -> References:
    rows = array.astype(np.float64)
    if not (np.isfinite(rows).all() and (rows[:, 2] > 0).all() and (rows[:, 2] < 1e30).all()):
        raise ValueError("align: expected finite pixels and distances above 0, one row of u, v and meters each")
    outside = ~_inside(rows[:, :2], size)
    if outside.any():
        u, v, _ = rows[outside][0]
        raise ValueError(f"align: pixel ({u:g}, {v:g}) is outside the image of {size[1]} x {size[0]}")
    return References(rows[:, :2], rows[:, 2], are_few=True)


def _of_sensor(array: NDArray[Any], size: tuple[int, int], depth_scale: float) -> References:
    _check_shape("the depth map", array.shape[1], array.shape[0], size)
    depth = array.astype(np.float64) / (1.0 if array.dtype.kind == "f" else depth_scale)
    if array.dtype.kind != "f":
        depth[array == NO_DEPTH] = 0
    with np.errstate(invalid="ignore"):
        rows, columns = np.nonzero(np.isfinite(depth) & (depth > 1e-30) & (depth < 1e30))
    pixels = _scaled(np.stack([columns, rows], 1).astype(np.float64), array.shape[1], array.shape[0], size)
    return References(pixels, depth[rows, columns])


def _of_model(model: SfmModel, name: str | None, size: tuple[int, int]) -> References:
    if name is None:
        raise ValueError(
            "align: a sparse model identifies images by name; give the path of the image, or (model, name)"
        )
    number = _number_of(model, name)
    camera, T = model.cameras[number], model.T_camera_world[number]
    _check_shape("the image of the model", camera.width, camera.height, size)
    seen = np.unique(model.observations[model.observations[:, 0] == number, 1])
    points = model.points[seen] @ T[:3, :3].T + T[:3, 3]
    pixels = _scaled(camera.project(points), camera.width, camera.height, size)
    valid = np.isfinite(pixels).all(1) & _inside(pixels, size)
    source = SPARSE if camera.is_pinhole else f"{SPARSE}, its distortion left out"
    return References(
        pixels[valid], points[valid, 2], unit=f"{SPARSE}'s", camera=_pinhole_of(camera, size), source=source
    )


def _number_of(model: SfmModel, name: str) -> int:
    if name in model.names:
        return model.index_of(name)
    matches = [number for number, other in enumerate(model.names) if Path(other).name == name]
    if len(matches) != 1:
        raise ValueError(
            f"align: expected one image {name!r} in the model, got {len(matches)}; it contains "
            f"{few_of(model.names, 3) or 'none'}"
        )
    return matches[0]


def _pinhole_of(camera: CameraModel, size: tuple[int, int]) -> PinholeCameraIntrinsic:
    ahead, right, left, below, above = camera.project(
        [[0, 0, 1], [AXIS_ANGLE, 0, 1], [-AXIS_ANGLE, 0, 1], [0, AXIS_ANGLE, 1], [0, -AXIS_ANGLE, 1]]
    )
    focal = np.array([right[0] - left[0], below[1] - above[1]]) / (2 * AXIS_ANGLE)
    if camera.is_pinhole:
        exact = camera.intrinsic
        focal = np.array([exact.fx, exact.fy])
    fx, fy = focal * (size[1] / camera.width, size[0] / camera.height)
    cx, cy = _scaled(ahead[None], camera.width, camera.height, size)[0]
    return PinholeCameraIntrinsic(size[1], size[0], fx, fy, cx, cy)


def _check_shape(what: str, width: int, height: int, size: tuple[int, int]) -> None:
    if abs(width * size[0] - height * size[1]) > max(width, height, *size):
        is_rotated = (width - height) * (size[1] - size[0]) < 0
        hint = "; if EXIF rotated the image upright, rotate this too" if is_rotated else ""
        raise ValueError(
            f"align: expected {what} with the aspect ratio of the image, {size[1]} x {size[0]}, got {width} x "
            f"{height}{hint}"
        )


def _scaled(pixels: NDArray[np.float64], width: int, height: int, size: tuple[int, int]) -> NDArray[np.float64]:
    return (pixels + 0.5) * (size[1] / width, size[0] / height) - 0.5


def _inside(pixels: NDArray[np.float64], size: tuple[int, int]) -> NDArray[np.bool_]:
    return (pixels >= -0.5).all(1) & (pixels[:, 0] <= size[1] - 0.5) & (pixels[:, 1] <= size[0] - 0.5)


def sample(values: Map, pixels: NDArray[np.float64]) -> NDArray[np.float64]:
    """Sample a map bilinearly. Values are clamped beyond the border."""
    height, width = values.shape
    u, v = np.clip(pixels[:, 0], 0, width - 1), np.clip(pixels[:, 1], 0, height - 1)
    left, top = np.minimum(u.astype(np.int64), max(width - 2, 0)), np.minimum(v.astype(np.int64), max(height - 2, 0))
    right, bottom = np.minimum(left + 1, width - 1), np.minimum(top + 1, height - 1)
    a, b = u - left, v - top
    upper = values[top, left] * (1 - a) + values[top, right] * a
    return upper * (1 - b) + (values[bottom, left] * (1 - a) + values[bottom, right] * a) * b


ARBITRARY = "arbitrary"
# Maximum depth of unaligned maps (the nearest is 1), and of aligned ones relative to the farthest reference.
MAX_DEPTH_RATIO = 10.0
FLYING_JUMP = 0.03  # minimum relative inverse depth difference of a flying pixel to both surfaces
EDGE_BLUR_PIXELS = 3  # network pixels of the transition between two surfaces
FEW_INLIERS = 0.3  # fraction of the references below which the result is unreliable
MAX_RADIUS = 32  # [px] 512 loads per pixel


def estimate_warnings(inlier_fraction: float | None, references: int, intrinsic_source: str) -> tuple[str, ...]:
    few = assumed = None
    if inlier_fraction is not None and inlier_fraction < FEW_INLIERS:
        few = (
            f"only {inlier_fraction:.0%} of the {references} references agree with the map within 10%: check that they "
            "belong to this image, and that the preset matches the model"
        )
    if not _is_known(intrinsic_source):
        assumed = (
            f"the camera is {intrinsic_source}, since the image has no EXIF focal length: shapes are distorted if it "
            "differs; pass intrinsic (--intrinsic)"
        )
    return failed(few, assumed)


@dataclasses.dataclass(frozen=True, eq=False)
class DepthEstimate(Assessed):
    """Estimated depth of an image.

    Args:
        depth: Depth along the optical axis, float32 [h, w], in `unit`. 0 where unknown.
        is_metric: True if depth is in meters.
        scale, shift: 1 / depth = scale * d + shift, with d the network output or its inverse if it outputs depth.
        inlier_fraction: Fraction of references that agree. None if there are too few to check.
        provider: onnxruntime provider: "CUDAExecutionProvider" or "CPUExecutionProvider".
        unit: "m", "the sparse model's", or "arbitrary".
        color: The upright image, uint8 [h, w, 3].
        intrinsic: The camera of the point cloud.
        intrinsic_source: "given", "the sparse model", "EXIF", "the network", or "assumed 60 degrees".
        input_size: Rows and columns of the network input for the complete image.
        enlargement: Image pixels per pixel of the network's map.
        references: Number of references.
        tiles: Number of tiles that agreed with the complete image, and of all tiles. None without tiles.
    """

    depth: NDArray[np.float32]
    is_metric: bool
    scale: float
    shift: float
    inlier_fraction: float | None
    provider: str
    unit: str
    color: NDArray[np.uint8]
    intrinsic: PinholeCameraIntrinsic
    intrinsic_source: str
    input_size: tuple[int, int]
    enlargement: float
    references: int = 0
    tiles: tuple[int, int] | None = None

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks, each with its remedy. Empty if the result is reliable."""
        return estimate_warnings(self.inlier_fraction, self.references, self.intrinsic_source)

    def __repr__(self) -> str:
        height, width = self.depth.shape
        return f"DepthEstimate({width} x {height}, unit {self.unit}, {self.provider})"

    def to_point_cloud(self, *, keep_edges: bool = False, stride: int = 1, device: DeviceLike = None) -> PointCloud:
        """Unproject the image to a colored point cloud in the camera frame.

        Args:
            keep_edges: Keep flying pixels at depth edges. If False, pixels are removed that deviate from the planes on
                both sides by more than 3% in inverse depth. Slanted planes are kept.
            stride: Use every stride-th row and column.
            device: Device of the cloud.

        Raises:
            ValueError: The stride is below 1.
            DeviceError: No such device.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> from pointloom.photogrammetry.depth.estimation import DepthEstimate
            >>> color, camera = np.zeros((2, 3, 3), np.uint8), loom.PinholeCameraIntrinsic(3, 2, 2.0, 2.0, 1.0, 0.5)
            >>> wall = np.full((2, 3), 4.0, np.float32)
            >>> given = (wall, True, 1.0, 0.0, None, "CPUExecutionProvider", "m", color, camera, "given", (2, 3), 1.0)
            >>> DepthEstimate(*given).to_point_cloud().points[0].tolist()
            [-2.0, -1.0, 4.0]
        """
        step = check_count("stride", stride)
        image = RGBDImage(self.color, self.depth, depth_trunc=np.inf, device=resolve_device(device))
        if not keep_edges:
            radius = min(max(round(EDGE_BLUR_PIXELS * self.enlargement), EDGE_BLUR_PIXELS), MAX_RADIUS)
            filtered = drop_flying(image.depth_array, image.width, image.height, radius, FLYING_JUMP)
            image = RGBDImage.from_device_arrays(image.color_array, filtered, image.height, image.width)
        return PointCloud.create_from_rgbd_image(image, self.intrinsic, stride=step)


def estimate_depth(
    image: Any,
    model: FilePath | DepthModel,
    *,
    intrinsic: PinholeCameraIntrinsic | None = None,
    align: Any = None,
    depth_scale: float = DEPTH_SCALE,
    tiles: int = 1,
    seed: int = 0,
    progress: ReportProgress | None = None,
) -> DepthEstimate:
    """Estimate the depth of an image with an ONNX network that you provide. Nothing is downloaded.

    Args:
        image: PNG or JPEG file (rotated by its EXIF orientation), or uint8 or uint16 [h, w], [h, w, 3] or [h, w, 4].
        model: A `DepthModel`, or the path of an .onnx file for its default preset and device.
        intrinsic: Camera of the upright image; None: that of the sparse model, else the EXIF focal length, else a field
            of view of 60 degrees across the longer side.
        align: Known depths for scale and shift: a sparse model (from `read_cameras`, its folder, or (model, name))
            that contains the image. A depth map [h, w] of any size, 0 where unknown (.png, .npy); or distances [n, 3]
            of column, row and meters (.txt, .csv), of which two suffice without a check.
        depth_scale: Units per meter of integer depth maps.
        tiles: Number of tiles along the longer side; above 1, tiles refine the depth of a large image.
        seed: Seed of the alignment.
        progress: Called with ("tiles", done, all).

    Returns:
        Depth at the image size: in meters for metric networks (with a known focal length if they need one) or after
        alignment to meters, in the unit of the sparse model after alignment to one, else in an arbitrary unit with the
        nearest pixel at 1 (and the farthest at 10 for networks with inverse depth).

    Raises:
        FileError: An unreadable file, or a model that does not match the preset or outputs no map.
        ValueError: An option out of range, or references that do not fit the image or no scale and shift (fewer than 20
            within 10%; of up to 50 distances not more than half).

    Notes:
        1 / z = scale * d + shift is fitted by RANSAC and refined on the inliers with weights z^2. Only the scale for
        networks that output depth. Depth beyond 10 times the farthest inlier is removed. About 40 B per pixel besides
        the network. Bitwise reproducible on one machine.

    Example:
        >>> import numpy as np, onnx, pointloom as loom
        >>> from onnx import TensorProto, helper  # a network that takes what is bright for near
        >>> x = helper.make_tensor_value_info("x", TensorProto.FLOAT, [1, 3, "h", "w"])
        >>> d = helper.make_tensor_value_info("d", TensorProto.FLOAT, [1, 1, "h", "w"])
        >>> node = helper.make_node("ReduceMean", ["x"], ["d"], axes=[1], keepdims=1)
        >>> graph = helper.make_graph([node], "brightness", [x], [d])
        >>> onnx.save(helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], ir_version=8), "b.onnx")
        >>> image = np.tile(np.linspace(0, 255, 64).astype(np.uint8), (48, 1))
        >>> estimate = loom.photogrammetry.estimate_depth(image, "b.onnx", align=[(10, 20, 4.0), (50, 20, 2.0)])
        >>> estimate.is_metric, estimate.depth[20, [10, 50]].round(3).tolist()
        (True, [4.0, 2.0])
        >>> len(estimate.to_point_cloud())
        3072
    """
    count = check_count("tiles", tiles, maximum=MAX_TILES, because="smaller tiles lack context")
    seed, report = check_seed(seed), check_progress(progress)
    photo = take_photo(image)
    references = None if align is None else find_references(align, photo.name, photo.color.shape[:2], depth_scale)
    camera, source = _camera(photo, intrinsic, references)
    network = _network(model)
    kind = NETWORK_PRESETS[network.preset]
    reading = network._read(photo.color, camera, is_known=_is_known(source))
    if reading.camera is not None and not _is_known(source):
        camera, source = _own_camera(reading.camera, photo), "the network"
    inverse, tiled = _inverse_depth(reading, network, camera), None
    if count > 1:
        inverse, *tiled = refine_by_tiles(
            photo.color, inverse, count, _of_parts(network, camera, source),
            seed=seed, report=lambda done, total: report("tiles", done, total),
        )  # fmt: skip
    alignment = None if references is None else _align(inverse, references, kind, seed)
    if alignment is None:
        scale, shift, farthest = _default_units(inverse, kind)
    else:
        scale, shift, farthest = alignment.scale, alignment.shift, MAX_DEPTH_RATIO * alignment.farthest
    unit = _unit(kind, references, source, reading.is_metric)
    return DepthEstimate(
        depth=_depth(inverse, scale, shift, farthest),
        is_metric=unit == "m",
        scale=scale,
        shift=shift,
        inlier_fraction=None if alignment is None else alignment.inlier_fraction,
        provider=network.provider,
        unit=unit,
        color=photo.color,
        intrinsic=camera,
        intrinsic_source=source,
        input_size=(reading.placement.rows, reading.placement.columns),
        enlargement=max(1 / factor for factor in reading.placement.scale),
        references=0 if alignment is None else alignment.references,
        tiles=None if tiled is None else (tiled[0], tiled[1]),
    )


def _unit(kind: Preset, references: References | None, camera_source: str, is_metric: bool | None) -> str:
    if references is not None:
        return references.unit
    if is_metric is None:
        is_metric = kind.focal is None or _is_known(camera_source)
    return "m" if kind.output == "metric" and is_metric else ARBITRARY


def _is_known(camera_source: str) -> bool:
    return not camera_source.startswith("assumed")


def _own_camera(estimated: OwnCamera, photo: Photo) -> PinholeCameraIntrinsic:
    height, width = photo.color.shape[:2]
    return PinholeCameraIntrinsic(width, height, estimated.fx, estimated.fy, estimated.cx, estimated.cy)


def _network(model: Any) -> DepthModel:
    if isinstance(model, str | os.PathLike):
        return DepthModel(model)
    if not isinstance(model, DepthModel):
        raise TypeError(f"model: expected the path of an .onnx file or a DepthModel, got {shown(model)}")
    return model


def _camera(photo: Photo, intrinsic: Any, references: References | None) -> tuple[PinholeCameraIntrinsic, str]:
    height, width = photo.color.shape[:2]
    if intrinsic is None and references is not None and references.camera is not None:
        return references.camera, references.source
    if intrinsic is None:
        return camera_of(photo)
    given = check_camera("intrinsic", intrinsic, (width, height))
    if photo.is_rotated and (given.height, given.width) == (width, height) and height != width:
        raise ValueError(
            f"intrinsic: expected {width} x {height} pixels, since EXIF rotates the image upright, got "
            f"{given.width} x {given.height}; rotate the camera too"
        )
    return check_intrinsic(given, width, height), "given"


def _inverse_depth(reading: Reading, network: DepthModel, camera: PinholeCameraIntrinsic) -> Map:
    """The network output as inverse depth, up to scale and shift ([1/m] for metric networks). NaN where unknown."""
    kind, values = NETWORK_PRESETS[network.preset], reading.values
    if not kind.gives_scale:
        return values
    if kind.focal is not None and not reading.is_metric:
        across, down = reading.placement.scale
        focal = camera.fx * across if kind.reading == "canonical" else (camera.fx * across + camera.fy * down) / 2
        values = values * np.float32(focal / kind.focal)
    with np.errstate(divide="ignore", over="ignore"):
        inverse = np.float32(1) / values
    inverse = np.where((values > 0) & np.isfinite(inverse), inverse, np.float32(np.nan)).astype(np.float32)
    if not np.isfinite(inverse).any():
        reason = "returned no depth above 0 for any pixel"
        raise FileError(network.path, reason, remedy="Check that the preset matches the model")
    return inverse


def _of_parts(network: DepthModel, camera: PinholeCameraIntrinsic, source: str) -> Callable[[NDArray[np.uint8]], Map]:
    return lambda part: _inverse_depth(network._read(part, camera, is_known=_is_known(source)), network, camera)


def _align(inverse: Map, references: References, kind: Preset, seed: int) -> Alignment:
    d, y = sample(inverse, references.pixels), 1 / references.depths
    seen = np.isfinite(d) & ((d > 0) | (not kind.gives_scale))
    d, y = d[seen], y[seen]
    if references.are_few and len(d) <= MAX_DISTANCES:
        return align_to_distances(d, y, with_shift=not kind.gives_scale)
    return align_inverse_depth(d, y, seed=seed, with_shift=not kind.gives_scale)


def _default_units(inverse: Map, kind: Preset) -> tuple[float, float, float]:
    """Scale and shift without references, and the maximum depth."""
    if kind.output == "metric":
        return 1.0, 0.0, np.inf
    low, high = float(np.nanmin(inverse)), float(np.nanmax(inverse))
    if kind.gives_scale:
        return 1.0 / high, 0.0, np.inf
    scale = (1 - 1 / MAX_DEPTH_RATIO) / max(high - low, 1e-30)
    return scale, 1 - scale * high, np.inf


def _depth(inverse: Map, scale: float, shift: float, farthest: float) -> NDArray[np.float32]:
    """Depth in float32. 0 if unknown, behind the camera, or beyond the maximum."""
    w = inverse * np.float32(scale) + np.float32(shift)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        seen = w * np.float32(farthest) >= np.float32(1 - 1e-6) if np.isfinite(farthest) else w > 0
        z = np.float32(1) / w
    return np.where(seen & np.isfinite(z), z, np.float32(0))
