"""Feature matching of two clouds: nearest neighbors, mutual filter, ratio test."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import hand_out, library_of
from ..core.checks import check_numeric, check_positive, is_on_gpu
from ..core.devices import DeviceLike, check_same_device, resolve_device
from ..core.gpu_arrays import take_numbers
from ..kernels.features.feature_matching import pair_features
from ..kernels.lang import float32
from ..kernels.memory import cast, move, upload

Pairs = NDArray[np.int32]


def correspondences_from_features(
    source_features: ArrayLike,
    target_features: ArrayLike,
    mutual_filter: bool = False,
    mutual_consistency_ratio: float = 0.1,
    *,
    ratio: float | None = None,
    device: DeviceLike = None,
) -> Pairs:
    """Pair each source point with the target point of the nearest feature.

    Args:
        source_features: One row per point, shape [n, d], as from `compute_fpfh_feature` (transpose Open3D's columns).
        target_features: Likewise, shape [m, d].
        mutual_filter: Keep only mutual nearest neighbors, unless fewer than `mutual_consistency_ratio` n pairs remain.
        mutual_consistency_ratio: That fraction of source points, rounded down.
        ratio: Keep pairs closer than `ratio` times the second nearest distance, in (0, 1] (Lowe: 0.8); None: all.
        device: Compute device; None: the GPU of the features, else the CPU.

    Returns:
        int32 [k, 2], (source index, target index), by source index, in the array library of the source features. Ties
        go to the first target row. Rows with NaN, infinity or values beyond 1e15 have no pair.

    Raises:
        ValueError: Wrong shapes, different feature lengths, or a ratio out of range.
        TypeError, DeviceError: Features that are not real numbers, or on two devices.

    Notes:
        Exact nearest rows in float32. At most 4 d + 200 B per row and 1 MB. Bitwise reproducible. Same rules as Open3D,
        which uses float64 and does not define ties. Lowe, "Distinctive image features from scale-invariant keypoints",
        IJCV 60(2), 2004, section 7.1.

    Example:
        >>> import pointloom as loom
        >>> source, target = [[0, 0], [9, 9], [8, 8]], [[9, 8], [1, 0], [0, 2]]
        >>> loom.registration.correspondences_from_features(source, target).tolist()
        [[0, 1], [1, 0], [2, 0]]
        >>> loom.registration.correspondences_from_features(source, target, mutual_filter=True).tolist()
        [[0, 1], [1, 0]]
        >>> loom.registration.correspondences_from_features(source, target, ratio=0.4).tolist()
        [[1, 0], [2, 0]]
    """
    fraction = check_positive("mutual_consistency_ratio", mutual_consistency_ratio, allow_zero=True)
    if ratio is not None:
        ratio = check_positive("ratio", ratio)
        if ratio > 1:
            raise ValueError(f"ratio: expected a number above 0 and at most 1, got {ratio!r}")
    on_device = features_on_device(source_features, target_features, device)
    pairs = pair_features(*on_device, mutual=bool(mutual_filter), mutual_consistency_ratio=fraction, ratio=ratio)
    return hand_out(pairs, library_of(source_features), on_host=not is_on_gpu(source_features))


def features_on_device(
    source_features: ArrayLike, target_features: ArrayLike, device: DeviceLike = None
) -> list[wp.array]:
    sides = [_check_features("source_features", source_features), _check_features("target_features", target_features)]
    _check_lengths(*(tuple(side.shape) for side in sides))
    common = _common_device(sides, device)
    return [move(side, common) if isinstance(side, wp.array) else _upload(side, common) for side in sides]


def _upload(features: np.ndarray, device: wp.Device) -> wp.array:
    return upload(features, float32, device, copied=False)


def _check_features(name: str, features: object) -> Any:
    if is_on_gpu(features):
        given = take_numbers(name, features)
        values: Any = given if given.dtype == float32 else cast(given, float32)
    else:
        if hasattr(features, "dimension") and hasattr(features, "num"):
            raise TypeError(f"{name}: expected an array, got {type(features).__name__}; pass its `data.T`")
        values = check_numeric(name, features)
        with np.errstate(over="ignore"):
            values = values.astype(np.float32, copy=False)  # beyond float32: infinite, hence without a pair
    if len(values.shape) != 2 or values.shape[1] == 0:
        raise ValueError(f"{name}: expected shape [n, d], one row per point, got {list(values.shape)}")
    return values


def _check_lengths(source: tuple[int, ...], target: tuple[int, ...]) -> None:
    if source[1] == target[1]:
        return
    hint = "; these look transposed: Open3D's features are columns, pass .T" if source[0] == target[0] else ""
    raise ValueError(
        f"source_features, target_features: expected shapes [n, d] and [m, d] with the same d, got {list(source)} and "
        f"{list(target)}{hint}"
    )


def _common_device(sides: list[Any], device: DeviceLike) -> Any:
    devices = [side.device for side in sides if isinstance(side, wp.array)]
    if len(devices) == 2:
        check_same_device("source_features, target_features", *devices)
    return resolve_device(device if device is not None else devices[0] if devices else None)
