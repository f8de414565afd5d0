"""What the trial runs share: the folder that their results go to, and the table of errors of a surface."""

from __future__ import annotations

import contextlib
import dataclasses
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.errors import FileError
from ...core.reports import Fields
from ...core.wording import format_share, to_json

_SHOWN = (("median", "median"), ("root mean square", "rmse"), ("95 % below", "p95"), ("largest", "largest"))


@dataclasses.dataclass(frozen=True)
class DemoReport:
    """What a trial run says.

    Attributes:
        figures: Its report.json.
        told: The same as labels and values.
    """

    figures: dict[str, Any]
    told: Fields

    def to_json(self) -> dict[str, Any]:
        """The report, in JSON's types; "poor" says why the result is poor, or is None."""
        return self.figures

    def fields(self) -> Fields:
        """The report as labels and values for the terminal."""
        return self.told


@contextlib.contextmanager
def output_folder(folder: Path, names: Sequence[str], *, overwrite: bool) -> Iterator[None]:
    """A folder for files of these names, made if need be once they can be written; taken away if it stays empty.

    Raises:
        FileError: It is no folder and cannot be made one, or a file exists already.
    """
    if folder.exists() and not folder.is_dir():
        raise FileError(folder, "is not a folder", remedy="Give the name of a folder")
    made = not folder.exists()
    if made:
        try:
            folder.mkdir()
        except OSError as error:
            reason = f"the folder cannot be made: {error.strerror or error}"
            raise FileError(folder, reason, remedy="Choose a place that exists and may be written") from error
    try:
        for name in names:
            check_writable(folder / name, overwrite=overwrite)
        yield
    finally:
        if made:
            with contextlib.suppress(OSError):  # it holds the outputs
                folder.rmdir()


def write_report(path: str, report: dict[str, Any], *, overwrite: bool) -> None:
    """Write a report as JSON."""
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(to_json(report).encode() + b"\n")


@dataclass(frozen=True)
class SurfaceErrors:
    """Distances of a mesh's vertices from the true surface [m].

    Attributes:
        median, rmse, p95, largest: Of all vertices.
        within_half_voxel: Share of them that is so near.
        voxel_size: Edge of a voxel.
    """

    median: float
    rmse: float
    p95: float
    largest: float
    within_half_voxel: float
    voxel_size: float

    @classmethod
    def of(cls, errors: NDArray[np.float64], voxel_size: float) -> SurfaceErrors | None:
        """What is told of distances from the true surface [m]; None where there is no finite one."""
        errors = errors[np.isfinite(errors)]
        if not len(errors):
            return None
        return cls(
            median=float(np.median(errors)),
            rmse=float(np.sqrt(np.mean(errors**2))),
            p95=float(np.quantile(errors, 0.95)),
            largest=float(errors.max()),
            within_half_voxel=float(np.mean(errors <= voxel_size / 2)),
            voxel_size=voxel_size,
        )

    @property
    def rmse_voxels(self) -> float:
        """The root mean square in voxels."""
        return self.rmse / self.voxel_size

    def to_json(self) -> dict[str, float]:
        """In JSON's types: in metres, and in voxels."""
        metres = {name: getattr(self, name) for _, name in _SHOWN}
        voxels = {f"{name}_voxels": value / self.voxel_size for name, value in metres.items()}
        return metres | voxels | {"within_half_voxel": self.within_half_voxel}

    def __str__(self) -> str:
        rows = [(label, getattr(self, name)) for label, name in _SHOWN]
        lines = [f"{label:<18}{m * 1000:>8.2f} mm{m / self.voxel_size:>8.3f} voxels" for label, m in rows]
        near = f"{'within half a voxel':<18}{format_share(self.within_half_voxel):>9} of the vertices"
        return "\n".join([*lines, near])


def error_table(errors: SurfaceErrors | None) -> str:
    """The errors of a surface as a value of several lines for the terminal."""
    return "none: the mesh is empty" if errors is None else str(errors)
