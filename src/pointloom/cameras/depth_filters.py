"""Filters on depth images: denoising, edge removal, holes, normals, pyramids.

Depth is an array (h, w), divided by `depth_scale` and returned as float32 [m], or an RGBDImage, returned on its device.
Pixels without depth (0) are ignored. Only `fill_depth_holes` fills them. Bitwise reproducible. Memory for one more
image.
"""

from __future__ import annotations

from typing import Any, TypeVar, cast

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import Form, form_of
from ..core.checks import check_count, check_number, check_numeric, check_positive
from ..core.devices import DeviceLike
from ..core.gpu_arrays import device_for, take_numbers
from ..kernels.images.depth import PixelGrid, pixel_normals
from ..kernels.images.depth_filters import erode_edges, filter_bilateral, halve_color, halve_depth
from ..kernels.lang import float32
from ..kernels.memory import download, upload
from .camera import MAX_IN_ALL, MAX_PIXELS, PinholeCameraIntrinsic
from .images import RGBDImage, check_intrinsic, upload_color, upload_depth

Depth = TypeVar("Depth", RGBDImage, NDArray[Any])

MAX_KERNEL = 255  # [px] 51,000 products per pixel: minutes per image on a few cores
MAX_RESIDUAL = 1e-10  # of interpolated inverse depth, relative to that of the border
DEPTH_DIFF = 0.14  # [m] Open3D's threshold of another surface when it halves depth


def filter_depth_bilateral(
    depth: Depth,
    kernel_size: int = 5,
    value_sigma: float = 0.03,
    dist_sigma: float = 2.0,
    *,
    depth_scale: float | None = None,
    device: DeviceLike = None,
) -> Depth:
    """Smooth depth with a bilateral filter, which preserves edges.

    A pixel at distance r whose depth differs by v has weight exp(-r^2 / (2 dist_sigma^2) - v^2 / (2 value_sigma^2)).

    Args:
        depth: Shape (h, w), or an RGBDImage, whose colors are unchanged.
        kernel_size: Diameter of the disc of pixels [px], up to 255. The radius is kernel_size // 2.
        value_sigma: Standard deviation of the depth weight [m].
        dist_sigma: Standard deviation of the pixel weight [px].
        depth_scale: Units per meter of an array; None: 1000 for integers, 1 for floats.
        device: Device for an array; None: the GPU that it is on, else the CPU.

    Returns:
        Depth [m] of the same size. 0 where there was none.

    Raises:
        ValueError: A wrong shape, or a number out of range.

    Notes:
        As Open3D's Image.filter_bilateral on the CPU, but without counting holes as depth 0. Tomasi and Manduchi,
        "Bilateral filtering for gray and color images", ICCV 1998.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> depth = np.array([[1.0, 1.01, 2.0, 2.02, 0.0]])
        >>> loom.filter_depth_bilateral(depth, 3).round(3)
        array([[1.002, 1.008, 2.004, 2.016, 0.   ]], dtype=float32)
    """
    reason = "the time grows with its square; halve the image with create_depth_pyramid, or filter twice"
    radius = check_count("kernel_size", kernel_size, maximum=MAX_KERNEL, because=reason) // 2
    value, distance = check_positive("value_sigma", value_sigma), check_positive("dist_sigma", dist_sigma)
    metric, height, width = _metric(depth, depth_scale, device)
    return _like(depth, filter_bilateral(metric, width, height, radius, value, distance), height, width)


def erode_depth_edges(
    depth: Depth,
    radius: int = 3,
    depth_threshold: float = 0.1,
    *,
    depth_scale: float | None = None,
    device: DeviceLike = None,
) -> Depth:
    """Remove pixels near depth edges and holes, where sensors mix foreground and background.

    Args:
        depth: Shape (h, w), or an RGBDImage, whose colors are unchanged.
        radius: Pixels to remove on each side of an edge and around a hole [px]. Diagonals count as one.
        depth_threshold: Depth difference of neighboring pixels that makes an edge [m].
        depth_scale: Units per meter of an array; None: 1000 for integers, 1 for floats.
        device: Device for an array; None: the GPU that it is on, else the CPU.

    Returns:
        Depth [m] of the same size. 0 where removed. The image border is no edge.

    Raises:
        ValueError: A wrong shape, or a number out of range.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> loom.erode_depth_edges(np.array([[1.0, 1.0, 1.0, 2.0, 2.0, 2.0]]), 1).tolist()
        [[1.0, 1.0, 0.0, 0.0, 2.0, 2.0]]
    """
    reason = "no image is larger"
    size = check_count("radius", radius, minimum=0, maximum=MAX_PIXELS, because=reason)
    jump = check_positive("depth_threshold", depth_threshold)
    metric, height, width = _metric(depth, depth_scale, device)
    return _like(depth, erode_edges(metric, width, height, size, jump), height, width)


def fill_depth_holes(
    depth: Depth,
    max_pixels: int = 100,
    depth_threshold: float = 0.1,
    *,
    depth_scale: float | None = None,
    device: DeviceLike = None,
) -> tuple[Depth, NDArray[np.bool_]]:
    """Fill small holes whose border is one surface. Larger holes, and those at depth edges and at the border, remain.

    Inverse depth is interpolated from the border of a hole by Laplace's equation, which is exact for planes: inverse
    depth is linear in the pixel coordinates. Filled pixels are no measurements: leave them out of registration.

    Args:
        depth: Shape (h, w), or an RGBDImage, whose colors are unchanged.
        max_pixels: Maximum size of a hole [px]. Its pixels are connected by their sides.
        depth_threshold: Maximum difference of the depths around a hole [m].
        depth_scale: Units per meter of an array; None: 1000 for integers, 1 for floats.
        device: Device for an array; None: the GPU that it is on, else the CPU.

    Returns:
        Depth [m] of the same size, 0 where a hole remains; and the mask of the filled pixels, bool (h, w).

    Raises:
        ValueError: A wrong shape, or a number out of range.

    Notes:
        On the host, also for images on a GPU. Bitwise reproducible.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> depth = np.full((5, 6), 2.0)
        >>> depth[2, 2:4] = 0  # a hole
        >>> depth[0, 0] = 0  # at the border
        >>> filled, mask = loom.fill_depth_holes(depth)
        >>> filled[2].tolist(), float(filled[0, 0]), int(mask.sum())
        ([2.0, 2.0, 2.0, 2.0, 2.0, 2.0], 0.0, 2)
    """
    largest = check_count("max_pixels", max_pixels, maximum=MAX_IN_ALL, because="no image is larger")
    threshold = check_positive("depth_threshold", depth_threshold)
    metric, height, width = _metric(depth, depth_scale, device)
    values = download(metric).reshape(height, width)  # sync
    mask = _fillable(values, largest, threshold)
    if mask.any():
        values = values.copy()
        values[mask] = 1 / _harmonic(np.divide(1.0, values, where=values > 0, out=np.zeros(values.shape)), mask)
    return _like(depth, upload(values.reshape(-1), float32, metric.device), height, width), mask


def _fillable(depth: NDArray[np.float32], max_pixels: int, threshold: float) -> NDArray[np.bool_]:
    """Pixels of the holes of at most `max_pixels` inside the image, whose border has one depth up to the threshold."""
    from scipy import ndimage  # slow import

    labels = np.zeros(depth.shape, np.int32)
    count: Any = ndimage.label(depth <= 0, output=labels)
    sizes = np.bincount(labels.ravel(), minlength=count + 1)
    low, high = np.full(count + 1, np.inf), np.zeros(count + 1)
    for a, b in ((np.s_[1:], np.s_[:-1]), (np.s_[:-1], np.s_[1:])):
        for hole, beside in ((np.s_[a, :], np.s_[b, :]), (np.s_[:, a], np.s_[:, b])):
            is_border = (labels[hole] > 0) & (depth[beside] > 0)
            at, border = labels[hole][is_border], depth[beside][is_border].astype(np.float64)
            np.minimum.at(low, at, border)
            np.maximum.at(high, at, border)
    is_kept = (sizes > 0) & (sizes <= max_pixels) & (high - low <= threshold)
    for edge in (labels[0], labels[-1], labels[:, 0], labels[:, -1]):
        is_kept[edge] = False
    is_kept[0] = False
    return is_kept[labels]


def _harmonic(values: NDArray[np.float64], mask: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Values of the pixels of a mask inside an image that are the mean of their four neighbors, by conjugate gradients.

    NumPy adds in a fixed order, unlike sparse solvers that call BLAS.
    """
    rows, columns = np.nonzero(mask)
    number = np.full(mask.shape, len(rows))
    number[mask] = np.arange(len(rows))
    beside = [(rows, columns + 1), (rows, columns - 1), (rows + 1, columns), (rows - 1, columns)]
    others = np.stack([number[pixels] for pixels in beside])
    known = np.sum([np.where(mask[pixels], 0.0, values[pixels]) for pixels in beside], axis=0)
    x = np.full(len(rows), known.sum() / max(int((others == len(rows)).sum()), 1))

    def laplacian(x: NDArray[np.float64]) -> NDArray[np.float64]:
        return 4 * x - np.append(x, 0.0)[others].sum(axis=0)

    residual = known - laplacian(x)
    direction, square = residual.copy(), float((residual * residual).sum())
    limit = MAX_RESIDUAL**2 * float((known * known).sum())
    for _ in range(2 * len(rows)):
        if square <= limit:
            break
        image = laplacian(direction)
        step = square / float((direction * image).sum())
        x, residual = x + step * direction, residual - step * image
        square, before = float((residual * residual).sum()), square
        direction = residual + square / before * direction
    return x


def create_normal_map(
    depth: RGBDImage | ArrayLike,
    intrinsic: PinholeCameraIntrinsic,
    invalid_fill: float = 0.0,
    *,
    depth_scale: float | None = None,
    device: DeviceLike = None,
) -> NDArray[np.float32]:
    """Estimate a normal for each pixel from the differences to the points on the right and below.

    Args:
        depth: Shape (h, w), or an RGBDImage.
        intrinsic: The camera, of the image's size.
        invalid_fill: Value where one of the three pixels has no depth, and in the last row and column.
        depth_scale: Units per meter of an array; None: 1000 for integers, 1 for floats.
        device: Device for an array.

    Returns:
        Unit normals in the camera frame, toward the camera, float32 (h, w, 3).

    Raises:
        ValueError: A wrong shape, or a camera of another size.

    Notes:
        Open3D's Image.create_vertex_map and create_normal_map in one, in float64. Apply `filter_depth_bilateral` to
        noisy depth first; `erode_depth_edges` removes normals across two surfaces.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.cameras.depth_filters import create_normal_map
        >>> camera = loom.PinholeCameraIntrinsic(3, 2, 1.0, 1.0, 1.0, 0.5)
        >>> create_normal_map(np.ones((2, 3)), camera)[0, 0].tolist()
        [0.0, 0.0, -1.0]
    """
    fill = check_number("invalid_fill", invalid_fill, allow_nan=True, allow_infinite=True)
    metric, height, width = _metric(depth, depth_scale, device)
    camera = check_intrinsic(intrinsic, width, height)
    normals, _ = pixel_normals(metric, PixelGrid(width, height, 1), camera, np.eye(3), fill)
    form = Form(depth.array_library, False) if isinstance(depth, RGBDImage) else form_of(depth)
    return form.hand_out(normals, shape=(height, width))


def pyrdown_depth(
    depth: Depth, diff_threshold: float = DEPTH_DIFF, *, depth_scale: float | None = None, device: DeviceLike = None
) -> Depth:
    """Halve a depth image: the next level of `create_depth_pyramid`, of shape (h // 2, w // 2)."""
    jump = check_positive("diff_threshold", diff_threshold)
    metric, height, width = _metric(depth, depth_scale, device)
    _check_even("depth", height, width)
    halved = halve_depth(metric, width, height, jump)
    if isinstance(depth, RGBDImage):
        color = halve_color(depth.color_array, width, height)
        return RGBDImage.from_device_arrays(color, halved, height // 2, width // 2, depth.array_library)
    return _like(depth, halved, height // 2, width // 2)


def pyrdown_color(color: ArrayLike, *, device: DeviceLike = None) -> NDArray[np.uint8]:
    """Halve a color image: every second pixel after a 5 x 5 Gaussian filter with a standard deviation of 1.

    Args:
        color: 8-bit colors, shape (h, w, 3), or gray (h, w).
        device: Device to use.

    Returns:
        Colors, uint8 (h // 2, w // 2, 3), gray repeated; rounded, halves up.

    Raises:
        ValueError: A wrong shape, or fewer than 2 rows or columns.
        TypeError: Not 8-bit.

    Notes:
        As Open3D's Image.pyrdown for even sizes. For odd sizes Open3D samples off the grid of the depth.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.cameras.depth_filters import pyrdown_color
        >>> pyrdown_color(np.full((480, 640), 7, np.uint8)).shape
        (240, 320, 3)
    """
    where, form = device_for(color, device), form_of(color)
    image = check_numeric("color", color) if form.on_host else take_numbers("color", color, where)
    height, width = image.shape[:2] if image.ndim >= 2 else (0, 0)
    _check_even("color", height, width)
    pixels = upload_color(image, height, width, where)
    return form.hand_out(halve_color(pixels, width, height), shape=(height // 2, width // 2, 3))


def create_depth_pyramid(
    depth: Depth,
    levels: int = 3,
    diff_threshold: float = DEPTH_DIFF,
    *,
    depth_scale: float | None = None,
    device: DeviceLike = None,
) -> list[Depth]:
    """A pyramid of depth images, the largest first. Each level has every second pixel of the previous one.

    A pixel is averaged over 5 x 5 pixels of the same surface. The camera of a level has half of fx, fy, cx and cy of
    the previous one, unlike `PinholeCameraIntrinsic.scaled`, since pixel (u, v) is pixel (2 u, 2 v) there.

    Args:
        depth: Shape (h, w), or an RGBDImage, whose colors are halved, too.
        levels: Number of images.
        diff_threshold: Pixels whose depth differs from the center's by this or more are ignored [m].
        depth_scale: Units per meter of an array; None: 1000 for integers, 1 for floats.
        device: Device for an array; None: the GPU that it is on, else the CPU.

    Raises:
        ValueError: A wrong shape, a threshold that is not positive, or levels < 1 or more than the size can be halved.

    Notes:
        As Open3D's PyrDownDepth. Newcombe et al., "KinectFusion", ISMAR 2011, section 3.3.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.cameras.depth_filters import create_depth_pyramid
        >>> [image.shape for image in create_depth_pyramid(np.ones((480, 640)))]
        [(480, 640), (240, 320), (120, 160)]
    """
    count = check_count("levels", levels)
    if isinstance(depth, RGBDImage):
        first = depth
    else:
        metric, height, width = _metric(depth, depth_scale, device)
        first = _like(depth, metric, height, width)
    images = [first]
    for _ in range(count - 1):
        images.append(pyrdown_depth(images[-1], diff_threshold, device=device))
    return cast("list[Depth]", images)


def _metric(depth: RGBDImage | ArrayLike, depth_scale: float | None, device: DeviceLike) -> tuple[wp.array, int, int]:
    if isinstance(depth, RGBDImage):
        return depth.depth_array, depth.height, depth.width
    metric, _, height, width = upload_depth(depth, depth_scale, np.inf, device_for(depth, device))
    return metric, height, width


def _like(depth: RGBDImage | ArrayLike, metric: wp.array, height: int, width: int) -> Any:
    if isinstance(depth, RGBDImage):
        return RGBDImage.from_device_arrays(depth.color_array, metric, height, width, depth.array_library)
    return form_of(depth).hand_out(metric, shape=(height, width))


def _check_even(name: str, height: int, width: int) -> None:
    if min(height, width) < 2:
        raise ValueError(f"{name}: expected at least 2 x 2 pixels to halve, got {width} x {height}")
