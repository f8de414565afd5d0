"""Values at vertices in float64, and back: what passes over a mesh work on, so that only their end is rounded."""

from ..algebra.transform import narrow, widen
from ..array_types import Positions, Vectors
from ..lang import array, kernel, launch, length, tid, vec3, vec3d
from ..memory import empty


@kernel
def widen_rows_kernel(rows: array(dtype=vec3), wide: array(dtype=vec3d)):
    """The same rows in float64."""
    i = tid()
    wide[i] = widen(rows[i])


@kernel
def narrow_rows_kernel(wide: array(dtype=vec3d), rows: array(dtype=vec3)):
    """The nearest rows in float32."""
    i = tid()
    rows[i] = narrow(wide[i])


@kernel
def narrow_directions_kernel(wide: array(dtype=vec3d), earlier: array(dtype=vec3), first: int, rows: array(dtype=vec3)):
    """Rows of unit length from `first` on, the earlier ones before; without a length the earlier or else (0, 0, 1)."""
    i = tid()
    row = vec3(0.0, 0.0, 1.0)
    if i < earlier.shape[0]:
        row = earlier[i]
    if i >= first:
        size = length(wide[i])
        if not size == 0.0:
            row = narrow(wide[i] / size)
    rows[i] = row


def widen_rows(rows: Vectors) -> Positions:
    """vec3 rows as vec3d."""
    wide = empty(rows.size, vec3d, rows.device)
    launch(widen_rows_kernel, rows.size, [rows, wide])
    return wide


def narrow_rows(wide: Positions) -> Vectors:
    """vec3d rows as vec3."""
    rows = empty(wide.size, vec3, wide.device)
    launch(narrow_rows_kernel, wide.size, [wide, rows])
    return rows


def narrow_directions(wide: Positions, earlier: Vectors, first: int = 0) -> Vectors:
    """vec3d rows as vec3 of unit length.

    Args:
        wide: vec3d [n].
        earlier: vec3 [m], m up to n: what the first m rows were; stays where a row has no length, and below `first`.
        first: The first row that is new.
    """
    rows = empty(wide.size, vec3, wide.device)
    launch(narrow_directions_kernel, wide.size, [wide, earlier, first, rows])
    return rows
