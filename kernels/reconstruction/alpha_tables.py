"""What points hand out of their stars: tables in which a thread's rows begin anywhere, and the same rows in order.

A thread does not know how many rows the others have. It takes room from one counter by an atomic, and afterwards each
owner's rows are copied to where they belong: the result is the same whichever thread came first.
"""

from ..array_types import Array1, Device, Element, Indices, Integers, Mask
from ..arrays.packed_keys import pack_bits
from ..arrays.prefix_sum import offsets_of
from ..lang import Kernel, array, int32, kernel, launch, struct, tid, uint8, vec3i, vec4i
from ..memory import empty, zeros

COLUMNS = 5  # of what is found: a face's corners and its two classes, or a tetrahedron's corners and its class


@struct
class Found:
    """Rows that points hand out, in an order of their own.

    Args:
        device: Where.
        owners: Rows of the cloud.
        capacity: Rows there is room for.
        total: int32 [1], zero.

    Attributes:
        table: int32 [capacity * COLUMNS].
        starts, counts: int32 [owners]: each owner's rows.
        total: int32 [1]: how many there are, with those that found no room.
    """

    table: array(dtype=int32)
    starts: array(dtype=int32)
    counts: array(dtype=int32)
    total: array(dtype=int32)
    capacity: int

    def __init__(self, device: Device, owners: int, capacity: int, total: Integers) -> None:
        self.device, self.capacity, self.total = device, capacity, total
        self.table = empty(capacity * COLUMNS, int32, device)
        self.starts, self.counts = zeros(owners, int32, device), zeros(owners, int32, device)

    def sorted_table(self, total: int) -> Integers:
        """The rows, so many as there are: the owners in order, the rows of each by their second and third number."""
        table = empty(total * COLUMNS, int32, self.device)
        launch(sort_found_kernel, self.counts.size, [self, offsets_of(self.counts), table])
        return table


@kernel
def sort_found_kernel(found: Found, offsets: array(dtype=int32), table: array(dtype=int32)):
    """Put an owner's rows where they belong, by their second and third number, which no two share."""
    i = tid()
    first = found.starts[i]
    last = first + found.counts[i]
    for j in range(first, last):
        key = pack_bits(found.table[j * COLUMNS + 1], found.table[j * COLUMNS + 2])
        place = offsets[i]
        for k in range(first, last):
            if pack_bits(found.table[k * COLUMNS + 1], found.table[k * COLUMNS + 2]) < key:
                place += 1
        for column in range(COLUMNS):
            table[place * COLUMNS + column] = found.table[j * COLUMNS + column]


@kernel
def mark_faces_kernel(table: array(dtype=int32), kind: int, mask: array(dtype=uint8)):
    """1 for the faces between a class up to `kind` and one beyond."""
    i = tid()
    inside = 0
    if table[i * COLUMNS + 3] <= kind and kind < table[i * COLUMNS + 4]:
        inside = 1
    mask[i] = uint8(inside)


@kernel
def mark_tetrahedra_kernel(table: array(dtype=int32), kind: int, mask: array(dtype=uint8)):
    """1 for the tetrahedra of a class up to `kind`."""
    i = tid()
    inside = 0
    if table[i * COLUMNS + 4] <= kind:
        inside = 1
    mask[i] = uint8(inside)


@kernel
def read_faces_kernel(table: array(dtype=int32), rows: array(dtype=int32), triangles: array(dtype=vec3i)):
    """The corners of some rows."""
    i = tid()
    at = rows[i] * COLUMNS
    triangles[i] = vec3i(table[at], table[at + 1], table[at + 2])


@kernel
def read_tetrahedra_kernel(table: array(dtype=int32), rows: array(dtype=int32), corners: array(dtype=vec4i)):
    """The corners of some rows."""
    i = tid()
    at = rows[i] * COLUMNS
    corners[i] = vec4i(table[at], table[at + 1], table[at + 2], table[at + 3])


def mark_rows(mark: Kernel, table: Integers, kind: int) -> Mask:
    """1 for the rows of a table that belong to one alpha."""
    count = table.size // COLUMNS
    mask = empty(count, uint8, table.device)
    launch(mark, count, [table, kind, mask])
    return mask


def read_rows(read: Kernel, kind_of_row: type[Element], table: Integers, rows: Indices) -> Array1[Element]:
    """Chosen rows of a table."""
    out = empty(rows.size, kind_of_row, table.device)
    launch(read, rows.size, [table, rows, out])
    return out
