"""Each mistake of docs/mistakes.md gives the message listed there, and its fix gives none."""

from __future__ import annotations

import fnmatch
import pathlib
import re
import warnings

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom

from .test_imports import ROOT

ROW = re.compile(r"\| `(.+)` \| (\w+): (.+) \| `(.+)` \|")
LINES = (ROOT / "docs/mistakes.md").read_text().splitlines()
MISTAKES = [ROW.fullmatch(line) for line in LINES if line.startswith("| `")]


@pytest.fixture(scope="module")
def scene():
    """The variables of the page's code: a scan of a room without normals, a mesh, two images and their camera."""
    room = loom.TriangleMesh.create_box(1.0, 2.0, 3.0)
    sampled = room.sample_points_uniformly(1500, seed=1)
    rng = np.random.default_rng(0)
    cloud = loom.PointCloud(sampled.points, colors=rng.random((1500, 3)))
    ball = rng.normal(size=(400, 3))
    ball /= np.linalg.norm(ball, axis=1, keepdims=True)
    normals = ball * np.where(rng.random((400, 1)) < 0.5, 1, -1)
    other = cloud.translate([0.01, 0, 0])
    return {
        "cloud": cloud, "other": other, "mesh": room, "reg": loom.registration, "loom": loom, "np": np,
        "pair": [other.estimate_normals(), cloud.estimate_normals()], "Rotation": Rotation, "pathlib": pathlib,
        "color": np.full((48, 64, 3), 128, np.uint8), "depth": np.full((48, 64), 1500, np.uint16),
        "camera": loom.PinholeCameraIntrinsic(64, 48, 52.5, 52.5, 31.5, 23.5),
        "ball": loom.PointCloud(ball, normals=ball), "inside_out": loom.PointCloud(ball, normals=normals),
    }  # fmt: skip


@pytest.fixture(scope="module")
def files(scene, tmp_path_factory):
    folder = tmp_path_factory.mktemp("mistakes")
    (folder / "scans").mkdir()
    for name in ("scan.ply", "scans/a.ply", "scans/b.ply"):
        loom.write_point_cloud(folder / name, scene["cloud"])
    loom.write_triangle_mesh(folder / "chair.obj", scene["mesh"])
    loom.write_image(folder / "color.png", scene["color"])
    loom.write_image(folder / "depth.png", scene["depth"])
    return folder


def error_of(code, names):
    """The class and the message of a line's error, or of its only warning; None without either."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            exec(compile(code, "<user>", "exec"), names)
        except Exception as error:
            return type(error).__name__, str(error)
    assert len(caught) <= 1, [str(warning.message) for warning in caught]
    return (type(caught[0].message).__name__, str(caught[0].message)) if caught else None


def pattern(words):
    return fnmatch.translate(re.sub(r"([\[*?])", r"[\1]", words).replace("...", "*"))


@pytest.mark.parametrize("row", MISTAKES, ids=lambda row: row[1][:60] if row else "no row")
def test_a_mistake_raises_the_documented_error_and_its_fix_does_not(row, scene, files, monkeypatch):
    assert row, "a row that is no mistake, words and mend"
    monkeypatch.chdir(files)
    mistake, kind, words, fix = row.groups()
    names = dict(scene, cloud=scene["cloud"].copy())
    error = error_of(mistake, names)
    assert error is not None, f"{mistake} says nothing"
    assert error[0] == kind and re.match(pattern(words), error[1]), f"{mistake}: {error[0]}: {error[1]}"
    assert error_of(fix, dict(scene, cloud=scene["cloud"].copy())) is None
