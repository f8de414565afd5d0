"""The steps that there are by name, and those of a list or a TOML file."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from itertools import pairwise
from pathlib import Path
from typing import Any

from ...core.checks import shown
from ...core.errors import FileError, values_of_file
from ...core.known_names import nearest_name
from .clusters import ClusterDbscan, ClusterEuclidean
from .comparison import Change, Distance
from .crop import Crop
from .features import Features
from .function import Function
from .ground import ClassifyGround, HeightAboveGround
from .normals import EstimateNormals
from .outliers import RadiusOutlier, StatisticalOutlier
from .raster import Rasterize
from .reprojection import Reproject
from .smoothing import SmoothMls
from .step import Step
from .thinning import Thin
from .voxels import VoxelDownSample

WHOLE = {
    "segment_plane": "a plane is found among all points; thin them here and find it in memory",
    "detect_planar_patches": "patches reach across any number of tiles; thin the points here and find them in memory",
    "farthest_point_down_sample": "each choice depends on all before it",
    "orient_normals_consistent_tangent_plane": "signs spread over the whole cloud",
    "random_down_sample": "the choice depends on the number of all points",
    "uniform_down_sample": "the choice depends on the rows of all points",
}

KNOWN: dict[str, type[Step]] = {
    kind.name: kind
    for kind in (VoxelDownSample, RadiusOutlier, EstimateNormals, StatisticalOutlier, Crop, SmoothMls, Function)
}
KNOWN |= {kind.name: kind for kind in (ClusterDbscan, ClusterEuclidean)}
KNOWN |= {kind.name: kind for kind in (ClassifyGround, HeightAboveGround, Rasterize)}
KNOWN |= {kind.name: kind for kind in (Features, Thin, Distance, Change, Reproject)}


def parse_steps(steps: Any) -> list[Step]:
    """The steps of a list of dictionaries, or of a TOML file of [[step]] tables; "step" names each.

    Raises:
        FileError: The file cannot be read, or the steps in it are wrong.
        ValueError: No such step, one that needs the whole cloud, or a parameter that it does not have or take.
    """
    with naming_file(steps):
        return _parse(read_toml(Path(steps)) if isinstance(steps, str | Path) else steps)


@contextmanager
def naming_file(steps: Any) -> Iterator[None]:
    """Turn errors about steps into a `FileError` if the steps came from a file."""
    with values_of_file(steps) if isinstance(steps, str | Path) else nullcontext():
        yield


def _parse(steps: Any) -> list[Step]:
    if isinstance(steps, dict) or not hasattr(steps, "__iter__"):
        raise TypeError(f"steps: expected a list of dictionaries or a .toml file, got {shown(steps)}")
    parsed = []
    for given in steps:
        if not isinstance(given, dict) or not isinstance(given.get("step"), str):
            raise ValueError(f"steps: expected a dictionary with the name of a 'step', got {shown(given)}")
        params = {name: value for name, value in given.items() if name != "step"}
        name = given["step"]
        if name in WHOLE:
            raise ValueError(f"steps: {name} needs the whole cloud at once: {WHOLE[name]}")
        if name not in KNOWN:
            raise ValueError(f"steps: there is no step {name!r}{nearest_name(name, KNOWN)}; {', '.join(KNOWN)}")
        parsed.append(KNOWN[name](params))
        _check_json(name, parsed[-1].params)
    names = [step.raster for step in parsed if isinstance(step, Rasterize)]
    if len({*names}) < len(names):
        raise ValueError(f"steps: rasters of one name: {', '.join(names)}; give each a 'name' of its own")
    _check_order(parsed)
    return parsed


def _check_json(name: str, params: dict[str, Any]) -> None:
    """Check that a manifest can hold parameters."""
    try:
        json.dumps(params, allow_nan=False)
    except (ValueError, TypeError, RecursionError) as error:
        raise ValueError(f"steps: {name}: expected numbers, strings, lists and tables of them: {error}") from error


def _check_order(steps: list[Step]) -> None:
    """Hold that no step whose halo may grow stands behind one that was joined with the halo that was planned."""
    for before, step in pairwise(steps):
        if isinstance(before, Reproject):
            reason = "reproject is the last step: tiles and halos are lengths of the files' own system"
            raise ValueError(f"steps: {step.name} behind reproject: {reason}")
    joined = ""
    for step in steps:
        if joined and step.neighbors is not None:
            reason = f"the halo that {step.name} of the nearest wants is known too late for {joined}"
            raise ValueError(f"steps: {reason}; put {joined} behind it, or give a radius")
        joined = step.name if step.joins else joined


def read_toml(path: Path) -> list[Any]:
    """The [[step]] tables of a file."""
    import tomllib

    try:
        content = tomllib.loads(path.read_text("utf-8"))
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    except (ValueError, RecursionError) as error:
        raise FileError(path, f"not TOML: {error}") from error
    tables = content.get("step")
    if len(content) != 1 or not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise FileError(path, "expected [[step]] tables and nothing else")
    return [table if "step" in table else {"step": table.pop("name", None), **table} for table in tables]
