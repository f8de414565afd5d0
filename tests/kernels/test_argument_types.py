"""A wrong element type, rank, order, kind or count of an argument of a host function is a type error."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
# (a planted mistake, its correct twin)
PAIRS = [
    ('gather_rows("rows", rows)', "gather_rows(points, rows)"),
    ("gather_rows(points, 3.5)", "gather_rows(table, rows)"), ("gather_rows(rows, points)", "gather_rows(keys, rows)"),
    ("gather_rows(points)", "gather_rows(values=points, rows=rows)"), ("positions_of(rows)", "positions_of(mask)"),
    ("positions_of(table)", "positions_of(invert_mask(mask))"), ("positions_of(points[:2])", "positions_of(mask[:2])"),
    ("invert_mask(host)", "invert_mask(mask)"), ("bound_points(positions)", "bound_points(points)"),
    ("bound_points(empty((3, 2), vec3, device))", "bound_points(empty(3, vec3, device))"),
    ("bound_points(upload(host, vec3d, device))", "bound_points(upload(host, vec3, device))"),
    ("subtract_origin(points, host)", "subtract_origin(positions, host)"),
    ("transform_points(host, host, host)", "transform_points(points, host, host)"),
    ("find_key_starts(rows, keys)", "find_key_starts(keys, rows)"), ("argsort_keys(doubles)", "argsort_keys(keys)"),
    ("PointTree(table)", "PointTree(points)"), ("find_nearest(points, tree)", "find_nearest(tree, points)"),
    ("average_vec3(points, rows)", "average_vec3(points, rows, rows)"), ("numbered(device, 3)", "numbered(3, device)"),
    ("HashTable(8)", "HashTable(device)"),
]  # fmt: skip
HEAD = """
import numpy as np
from pointloom.kernels.algebra.transform import transform_points
from pointloom.kernels.array_types import Array2, Device, Doubles, Indices, Keys, Mask, Points, Positions
from pointloom.kernels.arrays.bounds import bound_points
from pointloom.kernels.arrays.hash_table import HashTable
from pointloom.kernels.arrays.key_starts import find_key_starts
from pointloom.kernels.arrays.origins import subtract_origin
from pointloom.kernels.arrays.run_sums import average_vec3
from pointloom.kernels.arrays.select import gather_rows, invert_mask, positions_of
from pointloom.kernels.arrays.sort import argsort_keys, positions as numbered
from pointloom.kernels.lang import float32, vec3, vec3d
from pointloom.kernels.memory import empty, upload
from pointloom.kernels.search.nearest_point import find_nearest
from pointloom.kernels.search.point_tree import PointTree

def use(points: Points, positions: Positions, rows: Indices, keys: Keys, mask: Mask, doubles: Doubles,
        table: Array2[float32], device: Device, tree: PointTree, host: np.ndarray) -> None:
"""


def lines_with_errors(folder: Path, sources: dict[str, str]) -> dict[str, set[str]]:
    """The lines of each file that pyright finds an error in, as they are written."""
    paths = {"include": ["."], "extraPaths": [str(ROOT / "src")], "stubPath": str(ROOT / "typings")}
    settings = {"pythonVersion": "3.11", "typeCheckingMode": "standard", **paths}
    (folder / "pyrightconfig.json").write_text(json.dumps(settings))
    for name, source in sources.items():
        (folder / name).write_text(source)
    command = [Path(sys.executable).with_name("pyright"), "-p", folder, "--pythonpath", sys.executable, "--outputjson"]
    environment = os.environ | {"PYRIGHT_PYTHON_IGNORE_WARNINGS": "1"}
    ran = subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True)
    lines: dict[str, set[str]] = {name: set() for name in sources}
    for diagnostic in json.loads(ran.stdout)["generalDiagnostics"]:
        name = Path(diagnostic["file"]).name
        lines[name].add(sources[name].splitlines()[diagnostic["range"]["start"]["line"]].strip())
    return lines


@pytest.mark.slow
def test_each_planted_mistake_is_an_error_and_its_correct_twin_is_none(tmp_path):
    mistakes, twins = zip(*PAIRS, strict=True)
    parts = {"mistakes.py": mistakes, "twins.py": twins}
    sources = {name: HEAD + "".join(f"    {line}\n" for line in lines) for name, lines in parts.items()}
    assert lines_with_errors(tmp_path, sources) == {"mistakes.py": set(mistakes), "twins.py": set()}
