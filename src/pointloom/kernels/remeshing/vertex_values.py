"""Vertex values in float64 for multi-pass filters, so that only the result is rounded."""

from ..algebra.transform import narrow
from ..array_types import Positions, Vectors
from ..lang import array, compute, kernel, length, tid, vec3, vec3d


@kernel
def narrow_directions_kernel(wide: array(dtype=vec3d), earlier: array(dtype=vec3), first: int, rows: array(dtype=vec3)):
    """Unit rows from `first` on, earlier ones before. Without a length the earlier one, else (0, 0, 1)."""
    i = tid()
    row = vec3(0.0, 0.0, 1.0)
    if i < earlier.shape[0]:
        row = earlier[i]
    if i >= first:
        size = length(wide[i])
        if not size == 0.0:
            row = narrow(wide[i] / size)
    rows[i] = row


def narrow_directions(wide: Positions, earlier: Vectors, first: int = 0) -> Vectors:
    """Convert vec3d rows to unit vec3. `earlier` (vec3 [m]) replaces rows without a length and those below `first`."""
    return compute(narrow_directions_kernel, wide.size, [wide, earlier, first], vec3, wide.device)
