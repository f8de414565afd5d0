"""stations: E57 input and output, tables of targets and control points, reports, and exit code 3."""

import json

import numpy as np
import pye57
import pytest

import pointloom as loom
from pointloom.cli.jobs.stations import read_control, read_targets
from pointloom.io.pictures.image_files import read_color

from ..registration.station_scenes import BOXES, COURT, scan_all
from .commands import answer, run, unreliable

FAR = np.array([456_000.0, 5_400_000.0, 300.0])
TARGETS = {"A": [2, -3, 0.5], "B": [9, 4, 1.5], "C": [16, 2, 2], "D": [5, 12, 1]}


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Three scans with approximate poses, a table of their targets, and the same with two names exchanged."""
    folder = tmp_path_factory.mktemp("stations")
    clouds, truth = scan_all(BOXES, COURT[:3], 1, columns=120, rows=40)
    truth[:, :3, 3] += FAR
    rough = truth.copy()
    rough[:, :3, 3] += np.random.default_rng(0).normal(0, 0.2, (3, 3))
    loom.write_stations(folder / "scans.e57", clouds, rough, names=["north", "mid", "east"])
    for file, swapped in (("right.csv", {}), ("wrong.csv", {"A": "B", "B": "A"})):
        rows = ["station;name;x;y;z;sigma"]
        for i, T in enumerate(truth):
            for name, position in TARGETS.items():
                x, y, z = T[:3, :3].T @ (np.array(position) + FAR - T[:3, 3])
                rows.append(f"{i};{swapped.get(name, name) if i == 1 else name};{x:.5f};{y:.5f};{z:.5f};0.002")
        (folder / file).write_text("\n".join(rows) + "\n")
    control = [f"{name} {x} {y} {z}" for name, (x, y, z) in ((n, np.array(p) + FAR) for n, p in TARGETS.items())]
    (folder / "control.csv").write_text("# a comment\n" + "\n".join(control))
    np.save(folder / "truth.npy", truth)
    return folder


def test_scans_are_written_with_their_poses_and_a_report(files):
    words = ["--targets", files / "right.csv", "--control", files / "control.csv", "--voxel", 0.3, "--force"]
    words += ["-o", files / "out.e57", "--report", files / "report"]
    report = answer("stations", files / "scans.e57", *words)
    assert report["reliable"] and [s["name"] for s in report["stations"]] == ["north", "mid", "east"]
    before, after = loom.read_stations(files / "scans.e57"), loom.read_stations(files / "out.e57")
    assert np.abs(after.poses - np.load(files / "truth.npy"))[:, :3, 3].max() < 3e-3
    assert after.names == ("north", "mid", "east")
    for a, b in zip(before.clouds, after.clouds, strict=True):
        assert np.array_equal(a.points, b.points)
    with pye57.E57(str(files / "out.e57")) as file:  # as another library reads it
        assert np.abs(file.get_header(1).translation - after.poses[1][:3, 3]).max() < 1e-9
    assert "STATIONS" in (files / "report" / "report.txt").read_text()
    assert json.loads((files / "report" / "report.json").read_text())["redundancy"] == report["redundancy"]
    assert read_color(files / "report" / "plan.png").shape[:2] == (960, 1280)
    refused = run("stations", files / "scans.e57", "-o", files / "new.e57", "--report", files / "report")
    assert "--force" in refused.stderr


@pytest.mark.slow
def test_exchanged_names_cause_exit_code_3(files):
    words = ("--targets", files / "wrong.csv", "--control", files / "control.csv", "--voxel", 0.3, "--force")
    report = unreliable("stations", files / "scans.e57", "-o", files / "wrong.e57", *words)
    assert "look exchanged" in str(report["warnings"])
    assert {(o["name"], o["exchanged"]) for o in report["outliers"]} == {("A from mid", "B"), ("B from mid", "A")}


def test_invalid_tables_are_rejected(tmp_path):
    for text, message in (
        ("north,A,1,2", "line 1"),
        ("north,A,1,2,3\nsouth,A,1,2,3", "got 'south'"),
        ("", "no row"),
        ("north,A,1,2,3\nmid,A,1,x,3", "line 2"),
        ("north,A,1,2,3,-1", "line 1"),
        ("north,A,1,2,nan", "line 1"),
    ):
        (tmp_path / "t.csv").write_text(text)
        with pytest.raises(loom.FileError, match=message):
            read_targets(tmp_path / "t.csv", ["north", "mid"])


def test_control_has_one_sigma_or_three(tmp_path):
    (tmp_path / "c.csv").write_text("name,x,y,z\nA,1,2,3\nB,1,2,3,0.01\nC\t1\t2\t3\t0.1\t0.2\t0.3\n")
    a, b, c = read_control(tmp_path / "c.csv")
    assert [v.tolist() for v in (a.sigma, b.sigma, c.sigma)] == [[0.002] * 3, [0.01] * 3, [0.1, 0.2, 0.3]]
    with pytest.raises(loom.FileError, match=r"none\.csv"):
        read_control(tmp_path / "none.csv")


def test_invalid_calls_are_rejected(files):
    assert "--free" in run("stations", files / "scans.e57", "-o", files / "x.e57", "--free", "x,up").stderr
    assert "scans" in run("stations", files / "scans.e57", "-o", files / "scans.e57", "--force").stderr
    assert ".e57" in run("stations", files / "right.csv", "-o", files / "x.e57").stderr
