"""Tiles of files other than LAS: points and errors of each format, in bounded memory."""

import json

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.points import text_parts
from pointloom.io.points.by_extension import read_points
from pointloom.io.points.las import open_las
from pointloom.io.points.text_parts import TextInParts
from pointloom.tiling import plan as plan_module
from pointloom.tiling import unindexed_files
from pointloom.tiling.status import tile_status

from .scenes import plan_of, written

STEPS = [{"step": "remove_radius_outlier", "nb_points": 2, "radius": 3.0}]


def cloud(count=4000):
    rng = np.random.default_rng(4)
    points = np.round(rng.random((count, 3)) * (40, 40, 3), 3) + np.array([455_000, 5_420_000, 300])
    points[:200, :2] = np.round(points[:200, :2] / 10) * 10  # borders and corners of tiles
    colors = rng.integers(0, 256, (count, 3)) / 255
    return loom.PointCloud(points, colors=colors, intensity=rng.integers(0, 60000, count).astype(np.uint16))


def rows(cloud):
    table = np.column_stack([np.round(cloud.points * 1e4).astype(np.int64), np.round(cloud.colors * 255).astype(int)])
    return table[np.lexsort(table.T)]


def write(cloud, path):
    if path.suffix == ".csv":
        table = np.column_stack([cloud.points, np.round(cloud.colors * 255), cloud["intensity"]])
        body = "\n".join(",".join(f"{v:.3f}" if k < 3 else f"{v:.0f}" for k, v in enumerate(row)) for row in table)
        path.write_text("# measured\nX,Y,Z,R,G,B,Intensity\n" + body)
    elif path.suffix == ".xyzrgb":
        loom.write_point_cloud(path, loom.PointCloud(cloud.points, colors=cloud.colors))
    else:
        loom.write_point_cloud(path, cloud)


@pytest.fixture(scope="module")
def of_las(tmp_path_factory):
    folder = tmp_path_factory.mktemp("las")
    write(cloud(), folder / "a.laz")
    return loom.read_point_cloud(written(folder / "a.laz", STEPS, folder / "job", size=20.0))


SLOW = [pytest.param(name, marks=pytest.mark.slow) for name in ("a.pcd", "a.pts", "a.xyzrgb", "a.e57")]


@pytest.mark.parametrize("name", ["a.ply", "a.csv", *SLOW])
def test_points_of_every_format_match_las(tmp_path, name, monkeypatch, of_las):
    monkeypatch.setattr(text_parts, "BLOCK_BYTES", 10_000)
    monkeypatch.setattr(unindexed_files, "ROWS_PER_PART", 1500)
    path, job = tmp_path / name, tmp_path / "job"
    write(cloud(), path)
    result = loom.read_point_cloud(written(path, STEPS, job, size=20.0))
    assert loom.tiling.plan_tiles(path, STEPS, job, size=20.0).is_finished  # the same plan
    np.testing.assert_array_equal(rows(result), rows(of_las))
    assert len(result) > 3500
    if name != "a.xyzrgb":
        np.testing.assert_array_equal(np.sort(result["intensity"]), np.sort(of_las["intensity"]))
    with pytest.raises(loom.FileError, match="has changed since"):
        path.write_bytes(path.read_bytes() + b"\n")
        loom.tiling.run_tiles(job)


def test_text_read_in_parts_matches_text_read_at_once(tmp_path, monkeypatch):
    for block in (64, 1000, 1 << 20):
        monkeypatch.setattr(text_parts, "BLOCK_BYTES", block)
        for name, body in [
            ("a.xyz", "// x y z time\r\n1 2 3 4\r\n\r\n# no\r\n5 6 7 8\r\n9 1 2 3"),
            ("b.csv", "x;y;z;r;g;b\n1;2;3;0;0;255\n4;5;6;7;8;9\n"),
            ("c.txt", "x y z nx ny nz\n1 2 3 0 0 1\n4 5 6 1 0 0\n"),
            ("d.pts", "2\n1 2 3 7 255 0 0\n4 5 6 8 0 1 0\n"),
            ("e.xyzn", "1 2 3 0 0 1\n" * 40),
            ("f.csv", "x,y,z,r,g,b\n1,2,3,0.5,0,1\n" + "1,2,3,0,0,1\n" * 30),
        ]:
            path = tmp_path / name
            path.write_bytes(body.encode())
            complete, parts = read_points(path), [*TextInParts(path).parts(7)]
            for field in ("points", "normals", "colors"):
                values = [getattr(part, field) for part in parts]
                expected = getattr(complete, field)
                assert (expected is None) == (values[0] is None)
                if expected is not None:
                    np.testing.assert_array_equal(np.concatenate(values), expected)
            for key, values in complete.attributes.items():
                np.testing.assert_array_equal(np.concatenate([part.attributes[key] for part in parts]), values)


@pytest.mark.parametrize(
    ("name", "body", "message"),
    [
        ("a.xyz", "1 2 3\n" * 30 + "4 5\n" + "1 2 3\n" * 30, "line 31"),
        ("a.csv", "x,y,z\n" + "1,2,3\n" * 30 + "1,,3\n", "line 32|column 2"),
        ("a.pts", "9\n1 2 3\n", "9"),
        ("a.pts", "2\n1 2 3 0 0 255\n1 2 3 0 0 300\n", "line 3"),
        ("a.xyz", "1 2 3\nnan 2 3\n", "not finite"),
        ("a.xyz", "1 2 3 4 5\n", "without names"),
        ("a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 9\nproperty float x\nproperty float y\n"
         "property float z\nend_header\n123", "truncated"),
        ("a.e57", "ASTM-E57 and no more", "E57"),
        ("a.docx", "1 2 3", "expected one of"),
    ],
)  # fmt: skip
def test_invalid_files_are_named_and_leave_nothing(tmp_path, monkeypatch, name, body, message):
    monkeypatch.setattr(text_parts, "BLOCK_BYTES", 64)
    (tmp_path / name).write_text(body)
    with pytest.raises(loom.FileError, match=message):
        loom.tiling.plan_tiles(tmp_path / name, STEPS, tmp_path / "job")
    assert not (tmp_path / "job").exists() or not [*(tmp_path / "job").iterdir()]


def test_different_units_and_an_interrupted_plan(tmp_path, monkeypatch):
    points = np.random.default_rng(0).random((50, 3))
    meters = loom.PointCloud(points, unit="m")
    loom.write_point_cloud(tmp_path / "a.ply", meters)
    loom.write_point_cloud(tmp_path / "b.ply", meters.to_unit("ft"))
    with pytest.raises(loom.FileError, match=r"/b\.ply:"):
        loom.tiling.plan_tiles([tmp_path / "a.ply", tmp_path / "b.ply"], STEPS, tmp_path / "job")
    with monkeypatch.context() as patch:
        patch.setattr(plan_module, "write_manifest", lambda *_: (_ for _ in ()).throw(KeyboardInterrupt))
        with pytest.raises(KeyboardInterrupt):
            loom.tiling.plan_tiles(tmp_path / "a.ply", STEPS, tmp_path / "job")
    assert loom.tiling.plan_tiles(tmp_path / "a.ply", STEPS, tmp_path / "job").points == 50
    loom.tiling.run_tiles(tmp_path / "job")


def item_of(path):
    header = open_las(path).header
    properties = {"pc:count": header.point_count, "proj:bbox": np.ravel(header.bounds).tolist()}
    return {"properties": properties, "assets": {"data": {"href": f"./{path.name}", "roles": ["data"]}}}


@pytest.mark.slow
def test_an_index_gives_the_points_of_its_files(tmp_path):
    (tmp_path / "made").mkdir()
    full_cloud = cloud()
    for k, rows in enumerate(np.array_split(np.arange(len(full_cloud)), 2)):
        loom.write_point_cloud(tmp_path / "made" / f"{k}.laz", full_cloud.select_by_index(rows))
    items = {"features": [item_of(tmp_path / "made" / f"{k}.laz") for k in range(2)]}
    index = tmp_path / "made" / "index.vpc"
    index.write_text(json.dumps(items))
    assert loom.tiling.plan_tiles(index, STEPS, tmp_path / "job").points == len(full_cloud)
    sources = [source["path"] for source in plan_of(tmp_path / "job")["sources"]]
    assert sources == [str(tmp_path / "made" / f"{k}.laz") for k in range(2)]
    for change, message in [
        (lambda one: one["properties"].update({"pc:count": 7}), "lists 7 points of"),
        (lambda one: one["properties"]["proj:bbox"].__setitem__(0, 0.0), "lists the bounds"),
        (lambda one: one["properties"].update({"proj:bbox": ["w", 1, 2, 3]}), "lists invalid bounds of"),
        (lambda one: one["assets"]["data"].update(href="./gone.laz"), "lists ./gone.laz, which does not exist"),
        (lambda one: one["assets"]["data"].update(href="https://x/y.laz"), "which is not a file on this machine"),
        (lambda one: one["assets"]["data"].update(href="index.vpc"), "neither .las nor .laz"),
        (lambda one: one.pop("assets"), "is not a virtual point cloud"),
        (lambda one: one.update(assets=[]), "is not a virtual point cloud"),
        (lambda one: one.update(properties=[1]), "expected an object of properties"),
        (lambda one: one["properties"].update({"proj:bbox": [10**400, 0, 0, 1, 1, 1]}), "too large"),
        (lambda one: one["assets"]["data"].update(href="\ud800.las"), "surrogates not allowed"),
        (lambda one: one["assets"]["data"].update(href="a\0.las"), "which is not a file on this machine"),
        (lambda one: one["assets"]["data"].update(href="a" * 5000 + ".las"), "too long"),
    ]:
        changed = json.loads(json.dumps(items))
        change(changed["features"][0])
        (tmp_path / "made" / "other.vpc").write_text(json.dumps(changed))
        with pytest.raises(loom.FileError, match=message):
            loom.tiling.plan_tiles(tmp_path / "made" / "other.vpc", STEPS, tmp_path / "x")


def test_an_index_may_use_other_asset_names(tmp_path):
    points = np.random.default_rng(0).random((50, 3))
    loom.write_point_cloud(tmp_path / "a b.laz", loom.PointCloud(points))
    roles = {"overview": "overview", "points": "data"}
    assets = {name: {"href": "a%20b.laz", "roles": [role]} for name, role in roles.items()}
    (tmp_path / "one.vpc").write_text(json.dumps({"features": [{"assets": assets}]}))
    assert loom.tiling.plan_tiles(tmp_path / "one.vpc", STEPS, tmp_path / "job").points == 50
    del assets["points"]["roles"], assets["overview"]["roles"]
    (tmp_path / "one.vpc").write_text(json.dumps({"features": [{"assets": assets}]}))
    with pytest.raises(loom.FileError, match=r"/one\.vpc:"):
        loom.tiling.plan_tiles(tmp_path / "one.vpc", STEPS, tmp_path / "other")


def test_incompatible_files_are_named_as_given_and_leave_nothing(tmp_path):
    points = np.random.default_rng(0).random((50, 3))
    loom.write_point_cloud(tmp_path / "a.laz", loom.PointCloud(points))
    loom.write_point_cloud(tmp_path / "b.ply", loom.PointCloud(points, extra=points[:, 0]))
    with pytest.raises(loom.FileError, match=r"/b\.ply:.*a\.laz"):
        loom.tiling.plan_tiles([tmp_path / "a.laz", tmp_path / "b.ply"], STEPS, tmp_path / "job")
    assert not (tmp_path / "job").exists()


def test_names_and_values_invalid_in_las_get_another_name(tmp_path):
    points = np.random.default_rng(0).random((50, 3))
    columns = {"a" * 33: points[:, 0], "intensity": points[:, 1], "intensity_value": points[:, 2]}
    columns["label"] = np.arange(50, dtype=np.int32)
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(points, **columns))
    result = loom.read_point_cloud(written(tmp_path / "a.ply", [], tmp_path / "job", tmp_path / "a.laz"))
    for name, axis in {"a" * 32: 0, "intensity_value_2": 1, "intensity_value": 2}.items():
        np.testing.assert_allclose(result[name], result.points[:, axis], atol=1e-4)
    assert sorted(np.asarray(result["label"]).tolist()) == list(range(50))


def test_a_missing_converted_file_is_reported_before_tiles_are_run(tmp_path):
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(np.random.default_rng(0).random((50, 3))))
    loom.tiling.plan_tiles(tmp_path / "a.ply", STEPS, tmp_path / "job")
    assert not tile_status(tmp_path / "job").troubles
    (tmp_path / "job" / "sources" / "000000.laz").unlink()
    (trouble,) = tile_status(tmp_path / "job").troubles.items()
    assert trouble[0].endswith("a.ply") and "was converted from" in trouble[1]
    with pytest.raises(loom.FileError, match=r"/000000\.laz:.*a\.ply"):
        loom.tiling.plan_tiles(tmp_path / "a.ply", STEPS, tmp_path / "job")
