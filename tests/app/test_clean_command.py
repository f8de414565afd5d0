"""clean: what each filter removes, and what the command tells of it."""

import pytest

import pointloom as loom

from .commands import answer, names_in, poor_answer, refusal, run
from .toolbox_scene import NOT_FINITE, REPEATED, STRAY, rows_of


def test_clean_removes_what_is_not_finite_and_statistical_outliers(scene, tmp_path, points, device):
    report = answer("clean", scene, tmp_path / "out.npz", "--device", device)
    finite = loom.PointCloud(points, device=device).remove_non_finite_points()
    _, expected = finite.remove_statistical_outlier(20, 2.0)
    assert rows_of(tmp_path / "out.npz") == expected.tolist()  # the point that is not finite is the last
    removed = len(finite) - len(expected)
    statistical = {"removed": removed, "neighbors": 20, "ratio": 2.0}
    assert report["filters"] == {"non_finite": {"removed": 1}, "statistical": statistical}
    assert STRAY not in expected
    assert removed >= 1


@pytest.mark.parametrize(
    ("options", "filters", "gone"),
    [
        (["--non-finite"], {"non_finite": 1}, {NOT_FINITE}),
        (["--duplicates"], {"non_finite": 1, "duplicate": 1}, {NOT_FINITE, REPEATED}),
        (["--radius", "0.3", "--min-neighbors", "1"], {"non_finite": 1, "radius": 1}, {NOT_FINITE, STRAY}),
        (
            ["--duplicates", "--radius", "0.3", "--min-neighbors", "1", "--deviations", "20"],
            {"non_finite": 1, "duplicate": 1, "statistical": 1, "radius": 0},
            {NOT_FINITE, REPEATED, STRAY},
        ),
    ],
)
def test_clean_runs_the_filters_that_are_asked_for(scene, points, tmp_path, options, filters, gone):
    output, removed = tmp_path / "out.npz", tmp_path / "removed.npz"
    report = answer("clean", scene, output, *options, "--removed", removed)
    assert {name: figures["removed"] for name, figures in report["filters"].items()} == filters
    assert rows_of(output) == [row for row in range(len(points)) if row not in gone]
    assert rows_of(removed) == sorted(gone)
    assert report["files"] == [str(removed), str(output)]
    shown = run("clean", scene, output, *options, "--force").stdout
    assert "1 non-finite" in shown
    assert ("(radius 0.3, min neighbors 1)" in shown) == ("radius" in filters)


def test_clean_writes_no_file_of_removed_points_where_none_is(cloud, tmp_path):
    report = answer("clean", cloud, tmp_path / "out.ply", "--non-finite", "--removed", tmp_path / "gone.ply")
    assert report["files"] == [str(tmp_path / "out.ply")]
    assert names_in(tmp_path) == ["cloud.ply", "out.ply"]


def test_clean_checks_the_file_of_removed_points_first(cloud, tmp_path):
    (tmp_path / "gone.ply").write_bytes(b"kept")
    assert "gone.ply: exists already" in refusal(
        "clean", cloud, tmp_path / "out.ply", "--removed", tmp_path / "gone.ply"
    )
    assert names_in(tmp_path) == ["cloud.ply", "gone.ply"]


def test_a_radius_that_removes_most_points_is_a_poor_result(cloud, tmp_path):
    words = ["clean", cloud, tmp_path / "out.ply", "--min-neighbors", "3", "--radius"]
    report = poor_answer(*words, "0.05")
    assert "have fewer than 3 others within 0.05 m" in report["poor"]
    better = report["poor"].split("as many within ")[1].split(" m")[0]
    assert answer(*words, better, "--force")["points"] >= 250
    report = poor_answer(*words, "0.0001", "--force")
    assert (report["points"], report["files"]) == (0, [])
    assert "nothing was written" in report["poor"]
