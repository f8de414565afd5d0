"""How long the normals of samples are on average: a length over that is a weight that no unit changes.

Two float64 sums by a reduction; 12 B read a point.
"""

from ..algebra.transform import widen
from ..array_types import Indices, Vectors
from ..lang import array, int32, length, reduce, reduction, tid, vec2d, vec3
from ..memory import download


@reduction
def sum_lengths(normals: array(dtype=vec3), rows: array(dtype=int32)) -> vec2d:
    """(length, 1) of a sample's normal."""
    i = tid()
    return vec2d(length(widen(normals[rows[i]])), 1.0)


def mean_length(normals: Vectors, rows: Indices) -> float:
    """The mean length of chosen normals; 1 where none is chosen."""
    total, count = download(reduce(sum_lengths, rows.size, [normals, rows]))[0]  # sync
    return float(total) / float(count) if count else 1.0
