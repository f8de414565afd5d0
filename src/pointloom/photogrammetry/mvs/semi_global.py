"""Depth of both images of a pair by semi-global matching of the rectified images."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from ...kernels.array_types import Integers, Scalars
from ...kernels.lang import int32, uint8
from ...kernels.linear_algebra import inv
from ...kernels.memory import download, empty, full, upload
from ...kernels.stereo.census import LANE_COUNT, NO_CODE, find_codes, rectify_brightness
from ...kernels.stereo.disparities import RectifiedView, find_depth, find_disparities
from ...kernels.stereo.path_sums import sum_paths
from .depth_maps import DepthMap
from .image_slots import read_image
from .plane_search import Setting, no_depth
from .posed_images import PosedCamera
from .rectification import RectifiedPair, rectify

MAX_CELLS = 2**31 - 1  # pixels times disparities, numbered by int32


@dataclasses.dataclass(frozen=True)
class PairSearch:
    """A rectified pair, its first disparity and their number, a multiple of LANE_COUNT."""

    pair: RectifiedPair
    first: int
    count: int


def plan_search(cameras: Sequence[PosedCamera], ranges: Sequence[tuple[float, float]]) -> PairSearch:
    """Rectify two cameras and find the disparities of their depth ranges. Raises ValueError if they are too many."""
    pair = rectify(cameras)
    first, last = pair.disparities(cameras, ranges)
    count = -(-(last - first + 1) // LANE_COUNT) * LANE_COUNT
    if pair.width * pair.height * count > MAX_CELLS:
        raise ValueError(
            f"images: expected at most {MAX_CELLS} pixels times disparities, got {pair.width} x {pair.height} x "
            f'{count}. Reduce the size of the images, or pass method="patch_match".'
        )
    return PairSearch(pair, first, count)


def find_pair_depth(setting: Setting, search: PairSearch, report: Any) -> Iterator[DepthMap]:
    """Yield the depth maps of both images. An image without sources has no depth."""
    pair, first, count = search.pair, search.first, search.count
    found = None
    if pair.height:
        sums = sum_paths(*_codes(setting, pair, first, count), pair.width, pair.height, count)
        found = find_disparities(sums, pair.width, pair.height, count, first)
    for i, camera in enumerate(setting.cameras):
        if found is not None and setting.sources[i]:
            side = pair.order.index(i)
            yield _depth_map(setting, pair, side, first, *found[side])
        else:
            yield no_depth(camera)
        report("depth", i + 1, len(setting.cameras))


def _codes(setting: Setting, pair: RectifiedPair, first: int, count: int) -> tuple[Integers, Integers]:
    """Codes of the left image, and of the right image from right to left with `count` more per row."""
    left = empty(pair.width * pair.height, int32, setting.device)
    right = full((pair.width + count) * pair.height, NO_CODE, int32, setting.device)
    for i, view, codes, step, start in zip(
        pair.order, pair.views, (left, right), (1, -1), (0, pair.width - 1 - first), strict=True
    ):
        pixels = read_image(f"images[{i}]", setting.images[i], setting.cameras[i])
        flat = upload(pixels.reshape(-1), uint8, setting.device, copied=False)
        channels = 3 if pixels.ndim == 3 else 1
        there = None if view.there is None else inv(view.there)
        rows, columns = pixels.shape[:2]
        brightness = rectify_brightness(flat, channels, columns, rows, there, pair.width, pair.height)
        find_codes(brightness, pair.width, pair.height, step=step, start=start, codes=codes)
    return left, right


def _depth_map(
    setting: Setting, pair: RectifiedPair, side: int, first: int, disparities: Scalars, margins: Scalars
) -> DepthMap:
    view, intrinsic = pair.views[side], setting.cameras[pair.order[side]].intrinsic
    shift = first - pair.offset
    seen = RectifiedView(pair.width, pair.height, view.lens, pair.per_unit, shift, view.back)
    found = find_depth(intrinsic.width, intrinsic.height, view.there, seen, disparities, margins)
    depth, normals, confidence = (np.array(download(each)) for each in found)
    size = (intrinsic.height, intrinsic.width)
    return DepthMap(depth.reshape(size), normals.reshape(*size, 3), confidence.reshape(size))
