"""Attributes of LAS points that two generations of point formats store differently: 0 to 5, and 6 to 10 of LAS 1.4.

The older formats store `scan_angle_rank` in whole degrees. The newer ones store `scan_angle` in steps of 0.006 degrees,
and the flags `overlap` and `scanner_channel`. ASPRS, LAS Specification 1.4-R15, tables 8, 9, 15 and 17.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from .point_arrays import PointArrays

RANK, ANGLE = "scan_angle_rank", "scan_angle"
_SCAN_ANGLE_STEP = 0.006  # degrees per step of `scan_angle`
_MAX_DEGREES = 180  # larger angles have no step in 16 bits
_OVERLAP_CLASS = 12  # overlap points of the older formats, which have no flag for them
_FLAGS = ("overlap", "scanner_channel")


def with_scan_angles(attributes: Mapping[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """The attributes with `scan_angle` in place of `scan_angle_rank`, unless they have both or no whole degrees."""
    degrees = attributes.get(RANK)
    if degrees is None or ANGLE in attributes or degrees.ndim != 1:
        return {**attributes}
    if not ((np.abs(degrees.astype(np.float64)) <= _MAX_DEGREES) & (degrees == np.rint(degrees))).all():
        return {**attributes}
    steps = np.rint(degrees / _SCAN_ANGLE_STEP).astype(np.int16)
    return {ANGLE if name == RANK else name: steps if name == RANK else values for name, values in attributes.items()}


def with_common_las_attributes(parts: Sequence[PointArrays]) -> Sequence[PointArrays]:
    """The clouds with the scan angles and flags of the newer formats, if they are of both generations.
    Points of the older formats are from channel 0. Those of class 12 overlap."""
    newer = [part for part in parts if ANGLE in part]
    older = [part for part in parts if ANGLE not in part and RANK in part]
    if not newer or not older or any(part[ANGLE].dtype != np.int16 or part[ANGLE].ndim != 1 for part in newer):
        return parts
    flags = {name: newer[0][name].dtype for name in _FLAGS if all(name in part for part in newer)}
    return [part if ANGLE in part or RANK not in part else _as_newer(part, flags) for part in parts]


def _as_newer(part: PointArrays, flags: Mapping[str, np.dtype[Any]]) -> PointArrays:
    converted = with_scan_angles({RANK: part[RANK]})
    if ANGLE not in converted:
        return part
    for name, dtype in flags.items():
        if name in part:
            continue
        is_set = np.zeros(len(part), bool)
        if name == "overlap" and "classification" in part:
            is_set = part["classification"] == _OVERLAP_CLASS
        converted[name] = is_set.astype(dtype)
    added = part.without(RANK)
    for name, values in converted.items():
        added[name] = values
    return added
