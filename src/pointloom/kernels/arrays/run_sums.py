"""Sums and means over runs of rows, one thread per run and column, in float64 and row order."""

from ..array_types import Array2, Indices, Vectors
from ..lang import array, compute, float64, int32, isfinite, kernel, launch, tid, vec3, vec3d
from ..memory import empty
from .prefix_sum import gather_int_kernel


@kernel
def average_vec3_kernel(
    values: array(dtype=vec3), order: array(dtype=int32), starts: array(dtype=int32), means: array(dtype=vec3)
):
    """Mean of the finite vectors of each run. NaN if none is finite."""
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    count = float64(0.0)
    for j in range(starts[i], starts[i + 1]):
        v = values[order[j]]
        if isfinite(v):
            total += vec3d(float64(v[0]), float64(v[1]), float64(v[2]))
            count += 1.0
    means[i] = vec3(float(total[0] / count), float(total[1] / count), float(total[2] / count))


@kernel
def sum_columns_kernel(
    values: array(dtype=float64, ndim=2),
    order: array(dtype=int32),
    starts: array(dtype=int32),
    columns: int,
    mean: int,
    totals: array(dtype=float64, ndim=2),
):
    """Sum of each column over each run, or mean over its finite rows (NaN if none). Sums of means are compensated
    (Neumaier 1974), so means of large numbers, such as epoch times, are exact to 1 ulp."""
    i = tid()
    run = i // columns
    column = i % columns
    total = float64(0.0)
    lost = float64(0.0)
    count = float64(0.0)
    for j in range(starts[run], starts[run + 1]):
        row = order[j]
        is_counted = int(1)
        if mean == 1:
            for k in range(columns):
                if not isfinite(values[row, k]):
                    is_counted = 0
        if is_counted == 1:
            value = values[row, column]
            new_total = total + value
            if mean == 1:
                if abs(total) >= abs(value):
                    lost += (total - new_total) + value
                else:
                    lost += (value - new_total) + total
            total = new_total
            count += 1.0
    if mean == 1:
        if isfinite(lost):  # not if the sum overflows
            total += lost
        total = total / count
    totals[run, column] = total


def average_vec3(values: Vectors, order: Indices, starts: Indices) -> Vectors:
    """Means of vec3 rows over runs `order[starts[i]:starts[i + 1]]`, shape (runs)."""
    return compute(average_vec3_kernel, starts.size - 1, [values, order, starts], vec3, values.device)


def sum_columns(values: Array2[float64], order: Indices, starts: Indices, mean: bool = False) -> Array2[float64]:
    """Sums (or means over finite rows) of a float64 device array (n, c) over runs, shape (runs, c)."""
    columns = values.shape[1]
    totals = empty((starts.size - 1, columns), float64, values.device)
    launch(sum_columns_kernel, totals.size, [values, order, starts, columns, int(mean), totals])
    return totals


def first_rows(order: Indices, starts: Indices) -> Indices:
    return compute(gather_int_kernel, starts.size - 1, [order, starts], int32, order.device)
