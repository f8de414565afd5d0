"""Meshes changed: the other winding, fewer triangles, fewer vertices."""

from collections.abc import Iterable
from typing import Any

from ..array_types import Array1, Cells, Indices, Integers, Mask, Triangles, Vectors
from ..arrays.prefix_sum import exclusive_scan, sum_counts
from ..arrays.select import gather_rows, invert_mask, positions_of
from ..lang import array, atomic_min, int32, kernel, launch, tid, uint8, vec2, vec3, vec3i
from ..memory import empty, full, zeros


@kernel
def flip_triangles_kernel(triangles: array(dtype=vec3i), flipped: array(dtype=vec3i)):
    """The other winding."""
    i = tid()
    t = triangles[i]
    flipped[i] = vec3i(t[0], t[2], t[1])


@kernel
def mark_referenced_kernel(triangles: array(dtype=vec3i), used: array(dtype=int32)):
    """used[v] = 1 for the vertices of triangles; whichever thread writes last writes the same."""
    i = tid()
    t = triangles[i]
    used[t[0]] = 1
    used[t[1]] = 1
    used[t[2]] = 1


@kernel
def mark_chosen_kernel(triangles: array(dtype=vec3i), mask: array(dtype=uint8), used: array(dtype=uint8)):
    """1 for the vertices of chosen triangles; whichever thread writes last writes the same."""
    i = tid()
    if mask[i] != 0:
        t = triangles[i]
        for k in range(3):
            used[t[k]] = uint8(1)


@kernel
def mask_whole_triangles_kernel(triangles: array(dtype=vec3i), used: array(dtype=int32), mask: array(dtype=uint8)):
    """1 for the triangles whose three vertices are used."""
    i = tid()
    t = triangles[i]
    mask[i] = uint8(used[t[0]] * used[t[1]] * used[t[2]])


@kernel
def gather_triangles_kernel(triangles: array(dtype=vec3i), rows: array(dtype=int32), gathered: array(dtype=vec3i)):
    """gathered[i] = triangles[rows[i]]."""
    i = tid()
    gathered[i] = triangles[rows[i]]


@kernel
def gather_corners_kernel(values: array(dtype=vec2), rows: array(dtype=int32), gathered: array(dtype=vec2)):
    """The three values of triangle rows[i]."""
    i = tid()
    for k in range(3):
        gathered[3 * i + k] = values[3 * rows[i] + k]


@kernel
def flip_corners_kernel(values: array(dtype=vec2), flipped: array(dtype=vec2)):
    """Values of corners for the other winding."""
    i = tid()
    flipped[3 * i] = values[3 * i]
    flipped[3 * i + 1] = values[3 * i + 2]
    flipped[3 * i + 2] = values[3 * i + 1]


@kernel
def keep_rows_kernel(
    rows: array(dtype=vec3), used: array(dtype=int32), places: array(dtype=int32), kept: array(dtype=vec3)
):
    """The used rows, in their order."""
    i = tid()
    if used[i] == 1:
        kept[places[i]] = rows[i]


@kernel
def renumber_triangles_kernel(
    triangles: array(dtype=vec3i), places: array(dtype=int32), renumbered: array(dtype=vec3i)
):
    """Triangles by the new numbers of their vertices."""
    i = tid()
    t = triangles[i]
    renumbered[i] = vec3i(places[t[0]], places[t[1]], places[t[2]])


@kernel
def compare_triangles_kernel(triangles: array(dtype=vec3i), others: array(dtype=vec3i), unlike: array(dtype=int32)):
    """1 where two triangles are not the same."""
    i = tid()
    t = triangles[i]
    s = others[i]
    same = t[0] == s[0] and t[1] == s[1] and t[2] == s[2]
    unlike[i] = 0 if same else 1


@kernel
def find_first_places_kernel(rows: array(dtype=int32), places: array(dtype=int32)):
    """The first place of each row in a list; the minimum settles which of several it is."""
    i = tid()
    atomic_min(places, rows[i], i)


@kernel
def mark_first_places_kernel(rows: array(dtype=int32), places: array(dtype=int32), mask: array(dtype=uint8)):
    """1 where a row is listed for the first time."""
    i = tid()
    mask[i] = uint8(1 if places[rows[i]] == i else 0)


@kernel
def mark_places_kernel(rows: array(dtype=int32), used: array(dtype=int32), places: array(dtype=int32)):
    """1 for the rows of a list, and their places in it."""
    i = tid()
    used[rows[i]] = 1
    places[rows[i]] = i


def first_listed(rows: Indices, count: int) -> Indices:
    """The rows of a list, each where it comes first."""
    places, mask = full(count, rows.size, int32, rows.device), empty(rows.size, uint8, rows.device)
    launch(find_first_places_kernel, rows.size, [rows, places])
    launch(mark_first_places_kernel, rows.size, [rows, places, mask])
    return gather_rows(rows, positions_of(mask))  # sync


def later_listed(rows: Indices, count: int) -> Indices:
    """The places in a list of all `count` rows where one is listed that came before."""
    places, mask = full(count, rows.size, int32, rows.device), empty(rows.size, uint8, rows.device)
    launch(find_first_places_kernel, rows.size, [rows, places])
    launch(mark_first_places_kernel, rows.size, [rows, places, mask])
    return positions_of(invert_mask(mask), rows.size - count)


def mark_places(rows: Indices, count: int) -> tuple[Integers, Indices]:
    """(used, places): of `count` vertices, 1 for those in a list without repeats, and their places in it; int32."""
    used, places = zeros(count, int32, rows.device), empty(count, int32, rows.device)
    launch(mark_places_kernel, rows.size, [rows, used, places])
    return used, places


def renumber_triangles(triangles: Triangles, places: Integers) -> Triangles:
    """Triangles by the new numbers of their vertices."""
    renumbered = empty(triangles.size, vec3i, triangles.device)
    launch(renumber_triangles_kernel, triangles.size, [triangles, places, renumbered])
    return renumbered


@kernel
def shift_triangles_kernel(triangles: array(dtype=vec3i), step: int, shifted: array(dtype=vec3i)):
    """The same triangles of vertices that stand further back."""
    i = tid()
    shifted[i] = triangles[i] + vec3i(step, step, step)


@kernel
def raise_numbers_kernel(numbers: array(dtype=int32), step: int, raised: array(dtype=int32)):
    """Each number and so many more."""
    i = tid()
    raised[i] = numbers[i] + step


def shift_triangles(triangles: Triangles, step: int) -> Triangles:
    """Triangles whose vertices stand `step` rows further back, as after those of another mesh."""
    shifted = empty(triangles.size, vec3i, triangles.device)
    launch(shift_triangles_kernel, triangles.size, [triangles, step, shifted])
    return shifted


def raise_numbers(numbers: Integers, step: int) -> Integers:
    """int32 numbers, each by so many more."""
    raised = empty(numbers.size, int32, numbers.device)
    launch(raise_numbers_kernel, numbers.size, [numbers, step, raised])
    return raised


def flip_triangles(triangles: Triangles) -> Triangles:
    """The same triangles wound the other way."""
    flipped = empty(triangles.size, vec3i, triangles.device)
    launch(flip_triangles_kernel, triangles.size, [triangles, flipped])
    return flipped


def flip_corners(values: Array1[vec2]) -> Array1[vec2]:
    """Values vec2 [3 t] of corners for triangles wound the other way."""
    flipped = empty(values.size, vec2, values.device)
    launch(flip_corners_kernel, values.size // 3, [values, flipped])
    return flipped


def count_referenced(triangles: Triangles, vertex_count: int) -> int:
    """How many vertices triangles use; one sync."""
    return sum_counts(mark_referenced(triangles, vertex_count))


def count_unlike(triangles: Triangles, others: Cells) -> int:
    """How many triangles are not those at the same places of a list that is as long or longer; one sync."""
    unlike = empty(triangles.size, int32, triangles.device)
    launch(compare_triangles_kernel, triangles.size, [triangles, others, unlike])
    return sum_counts(unlike)


def mark_referenced(triangles: Triangles, vertex_count: int) -> Integers:
    """int32 [m]: 1 for the vertices that triangles use."""
    used = zeros(vertex_count, int32, triangles.device)
    launch(mark_referenced_kernel, triangles.size, [triangles, used])
    return used


def mark_chosen(triangles: Triangles, mask: Mask, vertex_count: int) -> Mask:
    """uint8 [m]: 1 for the vertices of the triangles that a mask, uint8 [t], chooses."""
    used = zeros(vertex_count, uint8, triangles.device)
    launch(mark_chosen_kernel, triangles.size, [triangles, mask, used])
    return used


def keep_vertices(triangles: Triangles, used: Integers, per_vertex: Iterable[Vectors]) -> tuple[Triangles, list[Any]]:
    """Cut arrays to the vertices that are used, and renumber triangles, none of which has another.

    Args:
        triangles: vec3i [t].
        used: int32 [m], 1 or 0.
        per_vertex: vec3 [m] arrays.

    Returns:
        (triangles, arrays): the order of the vertices is kept.
    """
    places, count = exclusive_scan(used)  # sync
    return keep_counted(triangles, used, places, count, per_vertex)


@kernel
def list_rows_kernel(used: array(dtype=int32), places: array(dtype=int32), rows: array(dtype=int32)):
    """The rows that are used, by their places."""
    i = tid()
    if used[i] != 0:
        rows[places[i]] = i


def keep_counted(
    triangles: Triangles, used: Integers, places: Integers, count: int, per_vertex: Iterable[Vectors]
) -> tuple[Triangles, list[Any]]:
    """As `keep_vertices`, where it is known how many are used, and which place each gets; no sync."""
    device = triangles.device
    kept = []
    for rows in per_vertex:
        target = empty(count, vec3, device)
        launch(keep_rows_kernel, used.size, [rows, used, places, target])
        kept.append(target)
    return renumber_triangles(triangles, places), kept


def gather_triangles(triangles: Triangles, rows: Indices) -> Triangles:
    """triangles[rows] on the device."""
    gathered = empty(rows.size, vec3i, triangles.device)
    launch(gather_triangles_kernel, rows.size, [triangles, rows, gathered])
    return gathered


def keep_triangles(triangles: Triangles, mask: Mask) -> Triangles:
    """The triangles where a uint8 device mask [t] is not zero, in their order."""
    return gather_triangles(triangles, positions_of(mask))  # sync


def gather_corners(values: Array1[vec2], rows: Indices) -> Array1[vec2]:
    """The values vec2 [3 t] of the corners of triangles `rows`."""
    gathered = empty(3 * rows.size, vec2, values.device)
    launch(gather_corners_kernel, rows.size, [values, rows, gathered])
    return gathered


def whole_triangles(triangles: Triangles, used: Integers) -> Indices:
    """The rows of the triangles whose vertices are all used; `used` is an int32 device array [m] of 1 or 0."""
    mask = empty(triangles.size, uint8, triangles.device)
    launch(mask_whole_triangles_kernel, triangles.size, [triangles, used, mask])
    return positions_of(mask)  # sync
