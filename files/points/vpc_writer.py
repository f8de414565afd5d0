"""Writing a virtual point cloud (.vpc): an index of LAS files as STAC items, which QGIS and PDAL open as one cloud.

Source: Lutra Consulting, "Virtual Point Cloud (VPC)"; STAC 1.0.0 with its extensions pointcloud 1.0.0 and projection
1.1.0.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .geodetic import Geodesy
from .las import COLORS, LasFile

_EXTENSIONS = [
    f"https://stac-extensions.github.io/{name}/schema.json" for name in ("pointcloud/v1.0.0", "projection/v1.1.0")
]
_DATE = "1970-01-01T00:00:00Z"  # STAC wants one; when the points were measured is not told
# PDAL's names of what laspy calls otherwise than by the same words in one
_NAMES = {"scan_angle": "ScanAngleRank", "nir": "Infrared"}
_KINDS = {"i": "signed", "u": "unsigned", "f": "floating"}


@dataclass
class Statistics:
    """Count, range and moments of each dimension, gathered part by part."""

    count: int = 0
    told: dict[str, list[float]] = field(default_factory=dict)  # least, most, mean, squares about the mean, count

    def add(self, columns: dict[str, NDArray[Any]]) -> None:
        """Take further points in; values that are not finite do not count, since JSON cannot hold them."""
        for name, column in columns.items():
            values = column[np.isfinite(column)].astype(np.float64)
            if not len(values):
                continue
            mean, size = float(values.mean()), len(values)
            own = [float(values.min()), float(values.max()), mean, float(((values - mean) ** 2).sum()), size]
            if name in self.told:
                low, high, before, squares, known = self.told[name]
                step, total = mean - before, known + size
                own[:3] = min(low, own[0]), max(high, own[1]), before + step * size / total
                own[3:] = own[3] + squares + step * step * known * size / total, total
            self.told[name] = own
        self.count += len(next(iter(columns.values())))

    def items(self) -> list[dict[str, Any]]:
        """As the pointcloud extension wants them."""
        items = []
        for place, (name, (low, high, mean, squares, count)) in enumerate(self.told.items()):
            variance = squares / max(count - 1, 1)
            numbers = {"average": mean, "minimum": low, "maximum": high, "variance": variance, "stddev": variance**0.5}
            items.append({"name": name, "position": place, "count": int(count), **numbers})
        return items


def dimensions_of(file: LasFile, rows: NDArray[Any]) -> dict[str, NDArray[Any]]:
    """Each dimension of some points by PDAL's name."""
    decoded = file.decode(rows)
    columns = {name: decoded["points"][:, axis] for axis, name in enumerate("XYZ")}
    if "colors" in decoded:
        columns |= {name.title(): rows[name] for name in COLORS}
    standard = {dimension.name for dimension in file.layout.standard_dimensions}
    for key, values in decoded.items():
        name = key[1:]
        if key.startswith(".") and values.ndim == 1:
            columns[_NAMES.get(name, name.title().replace("_", "") if name in standard else name)] = values
    return columns


def item_of(file: LasFile, href: str, statistics: Statistics, overview: str | None = None) -> dict[str, Any]:
    """The STAC item of a file.

    Args:
        file: The file.
        href: Its path from the index on, with "./" before.
        statistics: Of its points.
        overview: The path of a coarse version of all files.

    Raises:
        FileError: Its coordinate system cannot be read, or pyproj is missing.
    """
    low = [statistics.told[name][0] for name in "XYZ"]
    high = [statistics.told[name][1] for name in "XYZ"]
    ring = np.array([[x, y, z] for z in (low[2], high[2]) for x, y in _corners(low, high)])
    globe = Geodesy(file.path, file.header)
    degrees = globe.to_degrees(ring) if globe.system is not None else ring
    schemas = [
        {"name": name, "size": values.dtype.itemsize, "type": _KINDS[values.dtype.kind]}
        for name, values in dimensions_of(file, np.zeros(1, file.layout.dtype())).items()
    ]
    properties = {
        "datetime": _DATE,
        "pc:count": statistics.count,
        "pc:type": "lidar",
        "pc:encoding": "application/vnd.laszip+copc" if href.endswith(".copc.laz") else "application/vnd.laszip",
        "pc:schemas": schemas,
        "pc:statistics": statistics.items(),
        "proj:bbox": [*low, *high],
        "proj:geometry": {"type": "Polygon", "coordinates": [ring[:5].tolist()]},
    }
    if globe.system is not None:
        properties |= {"proj:wkt2": globe.system.to_wkt(), "proj:projjson": globe.system.to_json_dict()}
        properties["proj:epsg"] = globe.system.to_epsg()
    assets = {"data": {"href": href, "roles": ["data"]}}
    if overview:
        assets["overview"] = {"href": overview, "roles": ["overview"]}
    return {
        "type": "Feature",
        "stac_version": "1.0.0",
        "stac_extensions": _EXTENSIONS,
        "id": Path(href).name.split(".")[0],
        "geometry": {"type": "Polygon", "coordinates": [degrees[:5].tolist()]},
        "bbox": [*degrees.min(axis=0).tolist(), *degrees.max(axis=0).tolist()],
        "properties": properties,
        "links": [],
        "assets": assets,
    }


def _corners(low: list[float], high: list[float]) -> list[tuple[float, float]]:
    return [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1]), (low[0], low[1])]


def write_index(path: Path, items: list[dict[str, Any]]) -> None:
    """Write an index of items."""
    path.write_text(json.dumps({"type": "FeatureCollection", "features": items}, indent=1, allow_nan=False))
