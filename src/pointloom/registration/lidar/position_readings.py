"""Given positions of a scanner over time, of GNSS for example: `PositionReadings`."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.trajectory import read_trajectory
from ...core.checks import check_finite, check_numeric, check_positive, check_shape, shown
from ...core.errors import FileError, FilePath
from ...core.time_checks import check_seconds
from ...io.ascii_rows import is_float
from ...io.number_tables import TableForm, read_number_table, split_fields, table_lines

Array = NDArray[np.float64]

MIN_SIGMA, MAX_SIGMA = 1e-4, 1e6  # [m] below the resolution of a LiDAR; beyond the size of any map: unknown
CORRELATION_TIME = 1.0  # [s] GNSS receivers filter their positions: faster ones repeat the error of the last
FORM = TableForm(("time x y z", "time x y z sigma", "time x y z sigma_x sigma_y sigma_z"), optional=())
TUM_WIDTH = 8  # columns


@dataclass(frozen=True, eq=False)
class PositionReadings:
    """Positions of a scanner over time, in a level frame of its own, such as UTM coordinates of GNSS.

    Args:
        times: Times [s], float64 (n,), increasing, on the clock of the scans.
        positions: [m], shape (n, 3). The z axis points up.
        sigma: Standard deviation of the coordinates [m]: one number, or shape (n,), (3,) or (n, 3); 1e6 for an unknown
            height. Three numbers are those of x, y and z.
        offset: Position of the antenna in the frame of the scanner [m], shape (3,).

    Raises:
        TypeError: Not numbers.
        ValueError: Shapes that do not match, NaN or infinity, times that do not increase, or a sigma beyond 1e-4..1e6.

    Notes:
        The arrays are read-only. All positions within one second together have the weight of one position. Pass a
        larger `sigma` if errors last longer.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> positions = [[500_000.0, 5_400_000.0, 120.0], [500_001.0, 5_400_000.0, 120.0]]
        >>> loom.registration.PositionReadings([0.0, 1.0], positions, sigma=[0.5, 0.5, 1.5])
        PositionReadings(2 positions from 0.000 to 1.000)
    """

    times: Array
    positions: Array
    sigma: ArrayLike = 1.0
    offset: ArrayLike = (0.0, 0.0, 0.0)

    def __post_init__(self):
        times = check_finite("times", check_numeric("times", self.times))
        check_seconds("times", times)
        if times.ndim != 1:
            raise ValueError(f"times: expected shape [n], got {list(times.shape)}")
        times, count = times.astype(np.float64), len(times)
        if (unsorted := np.flatnonzero(np.diff(times) <= 0)).size:
            row = int(unsorted[0]) + 1
            reason = f"expected times that increase, got {times[row]:.6f} after {times[row - 1]:.6f} at index {row}"
            raise ValueError(f"times: {reason}. Sort the positions by time")
        positions = check_finite("positions", check_shape("positions", self.positions, (count, 3)))
        given = check_numeric("sigma", self.sigma)
        if not given.ndim:
            given = np.array(check_positive("sigma", self.sigma))  # rejects True
        given = given.astype(np.float64)
        if given.shape not in ((), (count,), (3,), (count, 3)):
            raise ValueError(f"sigma: expected one number, or shape [{count}], [3] or [{count}, 3], got {shown(given)}")
        if not ((given >= MIN_SIGMA) & (given <= MAX_SIGMA)).all():
            wrong = given[~((given >= MIN_SIGMA) & (given <= MAX_SIGMA))].flat[0]
            raise ValueError(f"sigma: expected standard deviations from {MIN_SIGMA:g} to {MAX_SIGMA:g} m, got {wrong}")
        each = given.shape == (count,) != (3,)
        sigma = np.broadcast_to(given[:, None] if each else given, (count, 3))
        offset = check_finite("offset", check_shape("offset", self.offset, (3,)))
        for name, values in (("times", times), ("positions", positions), ("sigma", sigma), ("offset", offset)):
            values = values.copy()
            values.flags.writeable = False
            object.__setattr__(self, name, values)

    def __len__(self) -> int:
        return len(self.times)

    def __repr__(self) -> str:
        span = f" from {self.times[0]:.3f} to {self.times[-1]:.3f}" if len(self) else ""
        return f"PositionReadings({len(self):,} positions{span})"

    @property
    def shares(self) -> Array:
        """Weight of each position: 1, or less if it follows the one before within a second."""
        steps = np.diff(self.times, prepend=-np.inf)
        return np.minimum(steps / CORRELATION_TIME, 1.0)

    @classmethod
    def read(cls, path: FilePath, sigma: ArrayLike = 1.0) -> PositionReadings:
        """Read positions from lines of `time x y z`, `time x y z sigma` or `time x y z sigma_x sigma_y sigma_z`.

        Args:
            path: The file, separated by blanks, commas, semicolons or tabs; or a TUM trajectory. A header names the
                columns in any order: time or timestamp, x or easting, y or northing, z or height, sigma or sigma_x,
                sigma_y, sigma_z. Unknown columns are ignored with a warning. Numbers may have decimal commas if
                semicolons or tabs separate them.
            sigma: Standard deviation [m] for files without one.

        Raises:
            FileError: Unreadable, a malformed line, an unknown unit or missing column in the header, or values as of
                the class.
        """
        if _is_tum(path):
            trajectory = read_trajectory(path)
            times, positions = trajectory.timestamps, trajectory.poses[:, :3, 3]
        else:
            rows = read_number_table(path, FORM)
            for row in rows:
                if row.numbers.keys() != rows[0].numbers.keys():
                    reason = f"expected {len(rows[0].numbers)} columns as in line {rows[0].line}"
                    raise FileError(path, f"{reason}, got {len(row.numbers)}", where=f"line {row.line}")
            columns = {name: np.array([row.numbers[name] for row in rows]) for name in rows[0].numbers}
            times, positions = columns["time"], np.stack([columns[axis] for axis in "xyz"], axis=1)
            if "sigma" in columns:
                sigma = np.broadcast_to(columns["sigma"][:, None], positions.shape)
            elif "sigma_x" in columns:
                sigma = np.stack([columns[f"sigma_{axis}"] for axis in "xyz"], axis=1)
        try:
            return cls(times, positions, sigma)  # type: ignore[arg-type]
        except ValueError as error:
            raise FileError(path, str(error)) from error


def _is_tum(path: FilePath) -> bool:
    """True if the first line that is no comment has eight numbers."""
    first = next((line for line in table_lines(path) if line.strip() and not line.lstrip().startswith("#")), "")
    fields = split_fields(first)[0]
    fields = fields if len(fields) == TUM_WIDTH else first.replace(",", " ").split()
    return len(fields) == TUM_WIDTH and "\t" not in first.strip() and all(map(is_float, fields))
