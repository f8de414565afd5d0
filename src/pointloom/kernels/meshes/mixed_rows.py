"""Interpolated vertex values: each is a weighted sum of up to three rows.

Floats are mixed in float64, without rows of weight zero: unchanged vertices keep their bits, and NaN does not spread.
Integers take the row with the greatest weight, the first of equal ones.
"""

from typing import Any

from ..array_types import AnyArray, Array1, Doubles, Indices, Triangles
from ..arrays.select import gather_rows
from ..lang import array, compute, float64, int32, kernel, launch, struct, tid, vec3d, vec3i
from ..memory import cast, empty

FLOATING = ("float16", "float32", "float64")  # types that are interpolated


@struct
class MixedRows:
    """Vertices mixed from old ones: `rows` vec3i [n], `weights` vec3d [n], sum 1. The first `kept` are unchanged."""

    rows: array(dtype=vec3i)
    weights: array(dtype=vec3d)

    def __init__(self, rows: Triangles, weights: Array1[vec3d]) -> None:
        self.rows, self.weights, self.count = rows, weights, rows.size

    def nearest(self) -> Indices:
        return compute(choose_heaviest_kernel, self.count, [self], int32, self.rows.device)

    def of(self, values: AnyArray) -> Any:
        if values.dtype.__name__ not in FLOATING:
            return gather_rows(values, self.nearest())
        width = 1 if values.ndim == 1 else values.shape[1]
        shape = (self.count, *values.shape[1:])
        if not self.count * width:
            return empty(shape, values.dtype, values.device)
        wide, mixed = cast(values, float64).reshape((-1, width)), empty((self.count, width), float64, values.device)
        launch(mix_rows_kernel, self.count, [wide, self, mixed])
        return cast(mixed.reshape(shape), values.dtype)


@kernel
def mix_rows_kernel(values: array(dtype=float64, ndim=2), made: MixedRows, mixed: array(dtype=float64, ndim=2)):
    i = tid()
    rows = made.rows[i]
    weights = made.weights[i]
    for c in range(values.shape[1]):
        total = float64(0.0)
        if weights[0] != 0.0:
            total += weights[0] * values[rows[0], c]
        if weights[1] != 0.0:
            total += weights[1] * values[rows[1], c]
        if weights[2] != 0.0:
            total += weights[2] * values[rows[2], c]
        mixed[i, c] = total


@kernel
def choose_heaviest_kernel(made: MixedRows, nearest: array(dtype=int32)):
    i = tid()
    rows = made.rows[i]
    weights = made.weights[i]
    row = rows[0]
    max_weight = weights[0]
    if weights[1] > max_weight:
        row = rows[1]
        max_weight = weights[1]
    if weights[2] > max_weight:
        row = rows[2]
    nearest[i] = row


@kernel
def keep_rows_kernel(rows: array(dtype=vec3i), weights: array(dtype=vec3d)):
    i = tid()
    rows[i] = vec3i(i, i, i)
    weights[i] = vec3d(1.0, 0.0, 0.0)


@kernel
def mix_ends_kernel(
    numbers: array(dtype=int32),
    lows: array(dtype=int32),
    highs: array(dtype=int32),
    fractions: array(dtype=float64),
    rows: array(dtype=vec3i),
    weights: array(dtype=vec3d),
):
    i = tid()
    rows[numbers[i]] = vec3i(lows[i], highs[i], lows[i])
    weights[numbers[i]] = vec3d(1.0 - fractions[i], fractions[i], 0.0)


def with_vertices_on_edges(
    count: int, numbers: Indices, lows: Indices, highs: Indices, fractions: Doubles
) -> MixedRows:
    """Keep `count` vertices and append those `numbers`, one per edge, at the fraction `fractions` between its ends."""
    total, device = count + lows.size, lows.device
    rows, weights = empty(total, vec3i, device), empty(total, vec3d, device)
    launch(keep_rows_kernel, count, [rows, weights])
    launch(mix_ends_kernel, lows.size, [numbers, lows, highs, fractions, rows, weights])
    return MixedRows(rows, weights)
