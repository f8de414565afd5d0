"""Claims about every operation on clouds, derived from its record in benchmarks/operations_on_clouds.py.

- The result does not depend on the position of the cloud.
- An element with NaN or infinity causes an error that names the argument, or the result of the other elements.
- Clouds that occur in real files cause no warning but those that are right for them.

Other derived tests: hostile arguments (pcd/test_hostile_arguments.py), equal runs (pcd/test_cloud_operations.py), equal
results of both compilers (test_compilers.py), and streams, orders and failed allocations on the emulated CUDA device.
test_translation.py and test_non_finite.py test operations on meshes, volumes and pairs of scans.
"""

from __future__ import annotations

import dataclasses
import warnings
from functools import cache
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from .hostile import hostile_clouds, warnings_of
from .registration.poses import as_pose
from .small_scenes import COUNT, ON_CLOUDS, SmallScenes, digest_scenes, parts_of
from .test_non_finite import ARGUMENT, agree, is_better
from .test_translation import OFFSETS

SPACING = 0.125  # [m] divides the offsets by 3, 4 and 12 times, so grids at multiples of the spacing match
POSITIONS = {"points", "vertices", "center", "middle", "min_bound", "max_bound"}
IN_FILES = ("pickle", "write and read")  # files contain the numbers as they are


def numbers_of(value: Any, name: str = "") -> dict[str, np.ndarray]:
    """The numbers of a result by name, with positions in the coordinates of the caller."""
    if value is None or isinstance(value, str):
        return {}
    if isinstance(value, bool | int | float | np.generic | np.ndarray):
        return {name: np.asarray(value)}
    if isinstance(value, loom.PointCloud):
        parts = {"points": value.points} | {key: value[key] for key in ("normals", "colors") if key in value}
        parts |= dict(value.attributes)
    elif hasattr(value, "_asdict"):
        parts = value._asdict()
    elif isinstance(value, list | tuple):
        parts = {f"[{k}]": part for k, part in enumerate(value)}
    else:
        parts = value if isinstance(value, dict) else parts_of(value)
    numbers: dict[str, np.ndarray] = {}
    for key, part in parts.items():
        if key != "origin":
            numbers |= numbers_of(part, name + (key if key.startswith("[") else f".{key}"))
    return numbers


def result_on(operation: Any, scene: Any) -> tuple[dict[str, np.ndarray], Any]:
    """The numbers of a result, and the result."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        result = operation(scene)
    return numbers_of(result), result


# ------------------------------------------------------------------------------------------------ positions


@cache
def surface_at(offset: tuple[float, float, float]) -> digest_scenes.SampledSurface:
    """A surface whose coordinates float32 represents exactly about the offset."""
    surface = SmallScenes("cpu").sample(COUNT, 10, offset, change=lambda points: np.round(points * 2**16) / 2**16)
    return dataclasses.replace(surface, spacing=SPACING)


def moved_back(name: str, value: np.ndarray, offset: np.ndarray) -> list[np.ndarray]:
    """The forms of a result at zero: unchanged, or a position, a pose, a plane or heights moved back."""
    forms, leaf = [value], name.rpartition(".")[2]
    if value.shape[-1:] == (3,) and (leaf in POSITIONS or "." not in name):
        forms.append(value - offset)
    if value.shape == (4, 4):
        forms.append(as_pose([0, 0, 0], -offset) @ value @ as_pose([0, 0, 0], offset))
    elif value.shape[-1:] == (4,):
        forms.append(np.concatenate([value[..., :3], value[..., 3:] + (value[..., :3] @ offset)[..., None]], axis=-1))
    if not name:
        forms.append(value - offset[2])
    return forms


@pytest.mark.parametrize("name", [name for name, record in ON_CLOUDS.items() if record.offset_tolerance is not None])
def test_a_result_does_not_depend_on_the_position_of_the_cloud(name):
    operation, offsets = ON_CLOUDS[name], [np.asarray(offset, np.float64) for offset in OFFSETS[1:]]
    first, _ = result_on(operation, surface_at((0, 0, 0)))
    assert sum(array.size for array in first.values()) > 0
    for offset in offsets:
        result, _ = result_on(operation, surface_at(tuple(offset)))
        assert {key: array.shape for key, array in result.items()} == {key: a.shape for key, a in first.items()}
        for key, array in result.items():
            if array.dtype.kind in "biu":
                np.testing.assert_array_equal(array, first[key], err_msg=f"{key} at {offset}")
                continue
            forms = moved_back(key, array.astype(np.float64), offset)
            with np.errstate(invalid="ignore"):  # infinite distances
                nearest = min(forms, key=lambda form: np.nan_to_num(np.abs(form - first[key])).max(initial=0))
            np.testing.assert_allclose(
                nearest, first[key], rtol=0, atol=operation.offset_tolerance, err_msg=f"{key} at {offset}"
            )


# ------------------------------------------------------------------------------------------------ not finite


class Noted:
    """A scene that notes the names of the inputs that an operation reads."""

    def __init__(self, scene: Any) -> None:
        self.scene, self.read = scene, set()

    def __getattr__(self, name: str) -> Any:
        self.read.add(name)
        return getattr(self.scene, name)


def grown(cloud: loom.PointCloud, part: str, value: float) -> loom.PointCloud:
    """The cloud with one more point, of which a number is this one."""
    rows = {name: np.asarray(cloud[name]) for name in ("normals", "colors", *cloud.attributes) if name in cloud}
    rows = {"points": np.asarray(cloud.points), **rows}
    rows = {name: np.concatenate([array, array[:1]]) for name, array in rows.items()}
    rows["points"][-1] *= 1.01
    rows[part][-1, 0] = value
    return loom.PointCloud(rows.pop("points"), device=cloud.device, **rows)


CHANGES = (  # cloud and what is changed in it
    *(("cloud", "points"), ("other", "points"), ("facing", "points")),
    *(("facing", "normals"), ("source", "points"), ("source", "normals")),
)


def changed(scene: Any, name: str, part: str, value: float) -> Any:
    """The scene with one more point in a cloud, of which a number is this one."""
    result = dataclasses.replace(scene)
    for each in ("cloud", "other", "facing", "source"):
        result.__dict__[each] = getattr(scene, each)
    result.__dict__[name] = grown(getattr(scene, name), part, value)
    return result


@pytest.fixture(scope="module")
def surfaces() -> dict[str, Any]:
    return {}


def agrees(numbers: dict[str, np.ndarray], expected: dict[str, np.ndarray], key: str, rows: Any, tolerance: float):
    """True if a result has the numbers of another one, apart from those of the added point."""
    count = len(rows) if rows.ndim else 0
    return key in expected and agree(
        *(np.asarray(each[key], np.float64) for each in (numbers, expected)), count, tolerance
    )


@pytest.mark.slow_on_emulated_cuda("110 operations, some eight hundred runs")
@pytest.mark.parametrize("name", [name for name in ON_CLOUDS if not name.startswith(IN_FILES)])
def test_an_element_that_is_not_finite_is_rejected_or_left_out(name, device, surfaces):
    scene = surfaces[device] = surfaces.get(device) or SmallScenes(device).sample(COUNT, 10)
    operation, noted = ON_CLOUDS[name], Noted(scene)
    without, plain = result_on(operation, noted)
    for cloud, part in [change for change in CHANGES if change[0] in noted.read]:
        finite = None
        for value in (np.nan, np.inf):
            case = f"{value} in {part} of {cloud}"
            try:
                numbers, result = result_on(operation, changed(scene, cloud, part, value))
            except ValueError as error:
                assert ARGUMENT.match(str(error)), f"{case}: {error}"
                continue
            differing = [
                key
                for key, rows in without.items()
                if not agrees(numbers, without, key, rows, operation.neighbor_tolerance)
            ]
            if numbers.keys() == without.keys() and not differing and not is_better(result, plain):
                continue
            finite = finite or result_on(operation, changed(scene, cloud, part, 0.0))
            assert numbers.keys() == finite[0].keys(), case
            for key in differing:
                assert agrees(numbers, finite[0], key, without[key], operation.neighbor_tolerance), f"{case}: {key}"
            assert not is_better(result, plain) or not is_better(result, finite[1]), case


# ------------------------------------------------------------------------------------------------ hostile clouds


@pytest.mark.parametrize("name", [name for name in ON_CLOUDS if not name.startswith(IN_FILES)])
def test_a_hostile_cloud_causes_no_warning(name):
    faults = []
    good = loom.PointCloud(np.random.default_rng(0).random((60, 3))).estimate_normals(max_nn=10)
    for title, hostile in hostile_clouds().items():
        for pair in ((hostile, hostile), (hostile, good), (good, hostile)):
            scene = digest_scenes.SampledSurface(*pair, spacing=0.2, size=1.0, middle=np.full(3, 0.5))
            scene.__dict__ |= {"facing": pair[0], "source": pair[1]}
            faults += [f"{title}: {fault}" for fault in warnings_of(lambda scene=scene: ON_CLOUDS[name](scene))]
    assert not faults, "\n".join(faults)
