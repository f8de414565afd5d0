"""The unknowns of a level of an octree's Poisson system: corners all of whose cells exist, listed colour by colour.

12 B a slot on CUDA while they are listed, 4 B after.
"""

import numpy as np

from ..array_types import Indices, Integers, Mask
from ..arrays.prefix_sum import inclusive_scan
from ..arrays.select import positions_of
from ..lang import array, int32, kernel, launch, tid, uint8
from ..memory import download, empty, upload
from .octree_levels import SLOTS, OctreeLevel, is_cell, neighbor_slot, slot_place


@kernel
def mark_unknowns_kernel(level: OctreeLevel, blocks: int, mask: array(dtype=uint8)):
    """1 for corners within the cube whose cells all exist, by colour and block; outside the cube they need not."""
    i = tid()
    color = i // blocks
    slot = SLOTS * (i - color * blocks) + color
    place = slot_place(slot, level)
    cells = 1 << level.depth
    unknown = 1
    if place[0] > cells or place[1] > cells or place[2] > cells:
        unknown = 0
    n = int(8)
    for corner in range(n):
        x = corner & 1
        y = (corner >> 1) & 1
        z = (corner >> 2) & 1
        outside = 0
        if place[0] - x < 0 or place[1] - y < 0 or place[2] - z < 0:
            outside = 1
        if place[0] - x >= cells or place[1] - y >= cells or place[2] - z >= cells:
            outside = 1
        if outside == 0:
            if is_cell(neighbor_slot(slot, -x, -y, -z, level), level) == 0:
                unknown = 0
    mask[i] = uint8(unknown)


@kernel(for_cpu=True)
def name_corners_kernel(places: array(dtype=int32), blocks: int, corners: array(dtype=int32)):
    """The slots of corners that are listed by colour and block."""
    i = tid()
    color = places[i] // blocks
    corners[i] = SLOTS * (places[i] - color * blocks) + color


@kernel
def count_unknowns_kernel(mask: array(dtype=uint8), counts: array(dtype=int32)):
    """The mask as numbers to be added up."""
    i = tid()
    counts[i] = int(mask[i])


@kernel
def list_unknowns_kernel(
    mask: array(dtype=uint8),
    ranks: array(dtype=int32),
    blocks: int,
    corners: array(dtype=int32),
    firsts: array(dtype=int32),
):
    """The slots of unknowns by colour and block, and where each colour's begin; ranks count from one."""
    i = tid()
    color = i // blocks
    if mask[i] != 0:
        corners[ranks[i] - 1] = SLOTS * (i - color * blocks) + color
    if i == 0:
        firsts[0] = 0
    if i + 1 == (color + 1) * blocks:
        firsts[color + 1] = ranks[i]


def list_unknowns(mask: Mask, blocks: int) -> tuple[Indices, Integers, list[int]]:
    """The unknowns of a level, colour by colour.

    Args:
        mask: uint8 [8 * blocks], 1 for unknowns by colour and block.
        blocks: Of the level.

    Returns:
        (corners, firsts, counts): their slots, int32; where each colour's begin and the last ends, int32 [9]; and how
        many of a colour there are at most: on CUDA as many as blocks, which spares a wait.
    """
    device = mask.device
    if device.is_cuda:
        ranks, corners, firsts = (empty(size, int32, device) for size in (mask.size, mask.size, SLOTS + 1))
        launch(count_unknowns_kernel, mask.size, [mask, ranks])
        inclusive_scan(ranks, ranks)
        launch(list_unknowns_kernel, mask.size, [mask, ranks, blocks, corners, firsts])
        return corners, firsts, [blocks] * SLOTS
    places = positions_of(mask)
    begins = np.searchsorted(download(places), np.arange(SLOTS + 1) * blocks)
    corners = empty(places.size, int32, device)
    launch(name_corners_kernel, places.size, [places, blocks, corners])
    return corners, upload(begins, int32, device), np.diff(begins).tolist()
