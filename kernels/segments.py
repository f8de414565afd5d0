"""Means over runs of rows: one thread a run, summed in float64 in the rows' own order."""

from .lang import array, float64, int32, isfinite, kernel, launch, tid, vec3, vec3d
from .memory import empty


@kernel
def average_vec3_kernel(
    values: array(dtype=vec3), order: array(dtype=int32), starts: array(dtype=int32), means: array(dtype=vec3)
):
    """The mean of the finite vectors of each run; NaN where none is finite."""
    i = tid()
    total = vec3d(float64(0.0), float64(0.0), float64(0.0))
    count = float64(0.0)
    for j in range(starts[i], starts[i + 1]):
        v = values[order[j]]
        if isfinite(v):
            total += vec3d(float64(v[0]), float64(v[1]), float64(v[2]))
            count += float64(1.0)
    means[i] = vec3(float(total[0] / count), float(total[1] / count), float(total[2] / count))


@kernel
def average_columns_kernel(
    values: array(dtype=float64, ndim=2),
    order: array(dtype=int32),
    starts: array(dtype=int32),
    columns: int,
    means: array(dtype=float64, ndim=2),
):
    """The mean of each column over each run."""
    i = tid()
    run = i // columns
    column = i % columns
    total = float64(0.0)
    for j in range(starts[run], starts[run + 1]):
        total += values[order[j], column]
    means[run, column] = total / float64(starts[run + 1] - starts[run])


@kernel
def first_rows_kernel(order: array(dtype=int32), starts: array(dtype=int32), rows: array(dtype=int32)):
    """The first row of each run."""
    i = tid()
    rows[i] = order[starts[i]]


def average_vec3(values, order, starts):
    """Means of vec3 rows over runs `order[starts[i]:starts[i + 1]]`, shape [runs]."""
    means = empty(starts.size - 1, vec3, values.device)
    launch(average_vec3_kernel, means.size, [values, order, starts, means])
    return means


def average_columns(values, order, starts):
    """Means of a float64 device array of shape [n, c] over runs, shape [runs, c]."""
    columns = values.shape[1]
    means = empty((starts.size - 1, columns), float64, values.device)
    launch(average_columns_kernel, means.size, [values, order, starts, columns, means])
    return means


def first_rows(order, starts):
    """The first row of each run, int32 [runs]."""
    rows = empty(starts.size - 1, int32, order.device)
    launch(first_rows_kernel, rows.size, [order, starts, rows])
    return rows
