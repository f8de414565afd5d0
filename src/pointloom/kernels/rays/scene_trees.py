"""Trees of several meshes in shared arrays, and a tree over the objects (posed instances). Pose changes rewrite only
the object rows and the upper tree. Objects are in Hilbert order of their centers.
"""

import itertools
from collections.abc import Sequence

import numpy as np

from ..array_types import Array1, Element
from ..lang import array, float32, float64, int32, struct, vec3
from ..memory import copy, download, empty, upload
from ..search.hilbert_order import HilbertOrder
from ..search.point_tree import FAN, SIDES
from .triangle_tree import TriangleTree

MAX_LEVELS = 12  # sufficient for 2^31 triangles
ROW_INTEGERS = 16  # per object: MAX_LEVELS level starts, root, first leaf, object number
ROOT_AT, FIRST_LEAF_AT, NUMBER_AT = 12, 13, 14
MOTION_NUMBERS = 18  # per object: rotation and shift from scene to mesh, mesh box
BOX_ENLARGEMENT = 1.0e-5  # relative enlargement of an object's box: float32 rounds differently in the mesh frame


@struct
class SceneTrees:
    """Trees of a scene's meshes, and poses (mesh to scene) of its objects. `rows` (ROW_INTEGERS) and `motions`
    (MOTION_NUMBERS) per object, in the order of the upper tree `object_boxes`, `object_levels`, `object_root`.
    """

    boxes: array(dtype=float32)
    corners: array(dtype=float32)
    order: array(dtype=int32)
    rows: array(dtype=int32)
    motions: array(dtype=float64)
    object_count: int
    object_boxes: array(dtype=float32)
    object_levels: array(dtype=int32)
    object_root: int
    low: vec3
    high: vec3

    def __init__(self, trees: Sequence[TriangleTree], tree_of: Sequence[int] | np.ndarray, poses: np.ndarray) -> None:
        self.trees, self.device = trees, trees[0].device
        self.tree_of = np.asarray(tree_of, np.int64)
        for name, dtype in (("boxes", float32), ("corners", float32), ("order", int32)):
            setattr(self, name, _joined(trees, name, dtype))
        self.put(poses)

    def put(self, poses: np.ndarray) -> None:
        count = self.object_count = len(self.tree_of)
        motions = np.empty((count, MOTION_NUMBERS))
        R = poses[:, :3, :3]
        motions[:, :9] = R.transpose(0, 2, 1).reshape(count, 9)
        motions[:, 9:12] = -np.einsum("nji,nj->ni", R, poses[:, :3, 3])
        motions[:, 12:15] = [self.trees[t].low for t in self.tree_of]
        motions[:, 15:] = [self.trees[t].high for t in self.tree_of]
        low, high = _boxes_of_objects(motions[:, 12:15], motions[:, 15:], poses)
        middles = np.where(low <= high, low / 2, 0) + np.where(low <= high, high / 2, 0)
        # an empty box is infinite: use a point instead, since infinity - infinity is NaN
        motions[:, 12:][~(low <= high).all(axis=1)] = 0
        order = np.zeros(1, np.int32)
        if count > 1:
            order = download(HilbertOrder(upload(middles, vec3, self.device)).order)  # sync
        self.rows = upload(self._rows()[order].ravel(), int32, self.device)
        self.motions = upload(motions[order].ravel(), float64, self.device)
        self.low, self.high = (np.where(np.isfinite(v), v, 0) for v in (low.min(axis=0), high.max(axis=0)))
        boxes, first = _stacked_boxes(low[order], high[order])
        self.object_boxes = upload(boxes, float32, self.device)
        self.object_levels, self.object_root = upload(first, int32, self.device), len(first) - 2

    def _rows(self) -> np.ndarray:
        record = np.cumsum([0, *(len(tree.boxes) // SIDES for tree in self.trees)])
        leaf = np.cumsum([0, *(tree.leaf_count for tree in self.trees)])
        table = np.zeros((len(self.trees), ROW_INTEGERS), np.int64)
        for number, tree in enumerate(self.trees):
            levels = tree.level_firsts[:-1]
            table[number, : len(levels)] = record[number] + levels
            table[number, ROOT_AT], table[number, FIRST_LEAF_AT] = tree.root, leaf[number]
        rows = table[self.tree_of]
        rows[:, NUMBER_AT] = np.arange(len(rows))
        return rows


def _joined(trees: Sequence[TriangleTree], name: str, dtype: type[Element]) -> Array1[Element]:
    parts = [getattr(tree, name) for tree in trees]
    if len(parts) == 1:
        return parts[0]
    firsts = np.cumsum([0, *(part.size for part in parts)])
    joined = empty(int(firsts[-1]), dtype, trees[0].device)
    for tree, part, first in zip(trees, parts, firsts, strict=False):
        copy(joined, part, count=part.size, offset=int(first))
        if part.size:
            setattr(tree, name, joined[int(first) : int(first) + part.size])
    return joined


def _boxes_of_objects(low: np.ndarray, high: np.ndarray, poses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Boxes of posed meshes, enlarged by BOX_ENLARGEMENT and rounded outwards to float32."""
    corners = np.stack([np.where(pick, high, low) for pick in itertools.product((False, True), repeat=3)], axis=1)
    empty_rows = ~np.isfinite(corners).all(axis=(1, 2))
    corners[empty_rows] = 0
    moved = np.einsum("nij,nkj->nki", poses[:, :3, :3], corners) + poses[:, None, :3, 3]
    a, b = moved.min(axis=1), moved.max(axis=1)
    slack = BOX_ENLARGEMENT * np.maximum(np.abs(a), np.abs(b)).max(axis=1, initial=0.0, keepdims=True)
    a, b = (a - slack).astype(np.float32), (b + slack).astype(np.float32)
    a[empty_rows], b[empty_rows] = np.inf, -np.inf
    return a, b


def _stacked_boxes(low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Boxes of all levels above some boxes, float32 (SIDES per record), and the start and end of each level."""
    records, first = [], [0]
    while True:
        count = max(1, -(-len(low) // FAN))
        padding = count * FAN - len(low)
        low = np.concatenate([low, np.full((padding, 3), np.inf, np.float32)]).reshape(count, FAN, 3)
        high = np.concatenate([high, np.full((padding, 3), -np.inf, np.float32)]).reshape(count, FAN, 3)
        records.append(np.stack([low, high], axis=1).transpose(0, 1, 3, 2).reshape(count, SIDES))
        first.append(first[-1] + count)
        low, high = low.min(axis=1), high.max(axis=1)
        if count == 1:
            return np.concatenate(records).ravel(), np.array(first, np.int32)
