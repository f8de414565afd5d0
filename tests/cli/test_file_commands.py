"""info, convert and normals: reports, outputs, errors, LAS and E57 files, and `-` for pipes."""

import json
import os
import subprocess
import sys
from pathlib import Path

import laspy
import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.trajectory import Trajectory, write_trajectory
from pointloom.cli.shell.next_command import next_command
from pointloom.io.images.image_files import write_png
from pointloom.io.points.formats import storing

from ..io.las_files import write_raw
from ..io.sfm_models import ring_model
from ..io.test_camera_files import camera, document
from ..io.test_e57 import colored_and_plain
from .commands import answer, names_in, output_of, refusal, run


def test_info_reports_the_contents_of_a_cloud(tmp_path):
    points = np.array([[5e5, 5e6, 1], [5e5 + 2, 5e6 + 4, 3], [np.nan, 0, 0]])
    path = tmp_path / "far.npz"
    loom.write_point_cloud(path, loom.PointCloud(points, normals=np.ones((3, 3)), label=np.arange(3)))
    (report,) = answer("info", path)["files"]
    assert (report["kind"], report["points"], report["not_finite"]) == ("point cloud", 3, 1)
    assert report["attributes"] == {"normals": "float32 x 3", "label": "int64"}
    assert report["bounds"] == {"min": [5e5, 5e6, 1], "max": [5e5 + 2, 5e6 + 4, 3]}
    assert report["origin"] == [500001, 5000002, 2]
    printed = run("info", path).stdout
    assert "point cloud" in printed and "[500000.0000, 5000000.0000, 1.0000] to" in printed


def test_info_shows_control_characters(tmp_path):
    path, evil = tmp_path / "a.ply", "a\x1b]0;owned\x07\x1b[2Kb"
    names = [f"property float {name}" for name in ("x", "y", "z", evil)]
    path.write_text("\n".join(["ply", "format ascii 1.0", "element vertex 1", *names, "end_header", "0 0 0 1", ""]))
    calls = (["info", path], ["info", path, "--json"], ["convert", path, tmp_path / "b.pcd"], ["info", evil])
    results = [run(*words) for words in calls]
    assert all("owned" in one.output and "\x1b" not in one.output and "\x07" not in one.output for one in results)


def test_info_reports_every_kind_of_file(mesh, frames, tmp_path):
    pose, K = frames / "frame-000000.pose.txt", tmp_path / "K.txt"
    K.write_text("525 0 80\n0 525 60\n0 0 1\n")
    write_trajectory(tmp_path / "t.log", Trajectory(np.tile(np.eye(4), (3, 1, 1))))
    np.save(tmp_path / "d.npy", np.ones((4, 5), np.float32))
    write_png(tmp_path / "none.png", np.zeros((4, 5), np.uint16))
    paths = [mesh, frames, frames / "camera-intrinsics.json", pose, K, tmp_path / "t.log", tmp_path / "d.npy"]
    paths += [frames / "frame-000000.depth.png", frames / "frame-000000.color.png", tmp_path / "none.png"]
    reports = answer("info", *paths)["files"]
    kinds = ["mesh", "RGB-D data set", "camera", "pose", "camera matrix", "trajectory", "depth map", "depth map"]
    assert [report["kind"] for report in reports] == [*kinds, "picture", "depth map"] and reports[0]["triangles"] == 2
    assert reports[1]["frames"] == 6 and reports[1]["layout"] == "7scenes"
    assert 0.3 < reports[1]["first_frame_depth_m"]["median"] < 5 and reports[9]["depth"] == {}
    shown = output_of("info", *paths)
    assert all(str(path) in shown for path in paths)


def test_info_counts_frames_with_poses(frames):
    (frames / "frame-000002.pose.txt").unlink()
    report = answer("info", frames)["files"][0]
    assert (report["frames"], report["poses"]) == (6, 5)
    for path in frames.glob("*.pose.txt"):
        path.unlink()
    report = answer("info", frames)["files"][0]
    assert (report["poses"], "path_length_m" in report) == (0, False) and "poses" in run("info", frames).stdout


def test_text_files_of_no_other_kind_are_clouds(tmp_path):
    texts = {
        "cloud.txt": "0 0 0\n0 1 0\n0 0 2\n", "names.txt": "x y z t\n1 2 3 4\n", "table.csv": "x,y,z,ring\n1,2,3,4\n",
        "K.txt": "5e2 0 80\n0 5e2 60\n0.0 0 1e0\n", "path.txt": "1 0 0 0 0 0 0 1\n",
    }  # fmt: skip
    for name, text in texts.items():
        (tmp_path / name).write_text(text)
    reports = answer("info", *(tmp_path / name for name in texts))["files"]
    assert [report["kind"] for report in reports] == ["point cloud"] * 3 + ["camera matrix", "trajectory"]
    assert [report["points"] for report in reports[:3]] == [3, 1, 1] and reports[2]["attributes"] == {"ring": "float64"}


def test_commands_read_meshes_and_scans_of_other_formats(mesh, tmp_path):
    for suffix in (".obj", ".stl", ".off", ".glb", ".gltf"):
        answer("convert", mesh, tmp_path / f"a{suffix}")
        (report,) = answer("info", tmp_path / f"a{suffix}")["files"]
        assert (report["kind"], report["vertices"], report["triangles"]) == ("mesh", 4, 2)
        assert answer("convert", tmp_path / f"a{suffix}", tmp_path / "b.ply", "--force")["kind"] == "mesh"
    np.tile(np.array([9, 1, -1, 0.5], "<f4"), 5).tofile(tmp_path / "a.bin")
    assert answer("convert", tmp_path / "a.bin", tmp_path / "c.ply")["points"] == 5
    (report,) = answer("info", tmp_path / "a.bin")["files"]
    assert report["attributes"] == {"intensity": "float32"}
    assert "clouds and meshes are not written to .bin" in run("convert", mesh, tmp_path / "b.bin").stderr


def test_up_rotates_formats_with_an_up_axis(mesh, tmp_path):
    answer("convert", mesh, tmp_path / "turned.glb", "--up", "z")
    answer("convert", tmp_path / "turned.glb", tmp_path / "again.ply", "--up", "z")
    answer("convert", tmp_path / "turned.glb", tmp_path / "as_it_is.gltf")
    x, y, z = loom.read_triangle_mesh(mesh).vertices.T
    rotated = loom.read_triangle_mesh(tmp_path / "as_it_is.gltf").vertices
    np.testing.assert_allclose(rotated, np.stack([x, z, -y], axis=1), atol=1e-6)
    np.testing.assert_allclose(loom.read_triangle_mesh(tmp_path / "again.ply").vertices.T, [x, y, z], atol=1e-6)
    assert answer("compare-meshes", mesh, tmp_path / "turned.glb", "--up", "z", "--samples", "100")["hausdorff"] < 1e-6


@pytest.fixture
def survey(tmp_path):
    """A cone with its tip in +z, as a cloud and a mesh of a map, and as meshes without a known axis."""
    cone = loom.TriangleMesh.create_cone(1.0, 3.0, 40, 10)
    cloud = cone.sample_points_uniformly(4000, use_triangle_normal=True)
    for name in ("a.laz", "a.e57", "b.ply"):
        cloud.crs = "EPSG:25832" if name == "b.ply" else None
        loom.write_point_cloud(tmp_path / name, cloud)
    loom.write_triangle_mesh(tmp_path / "lying.glb", cone)
    cone.crs = "EPSG:25832"
    loom.write_triangle_mesh(tmp_path / "mesh.ply", cone)
    return tmp_path


@pytest.mark.filterwarnings("ignore:.*cannot store the coordinate system")
@pytest.mark.parametrize("target", ["out.glb", "out.gltf"])
@pytest.mark.parametrize(
    "line",
    [
        *(f"mesh {name}" for name in ("a.laz", "a.e57", "b.ply")),
        *(f"{command} mesh.ply" for command in ("convert", "clean-mesh", "smooth-mesh", "simplify --ratio 0.9")),
        "transform mesh.ply --translate 1 2 3",
        "convert lying.glb --up z",
    ],
)
def test_gltf_files_of_commands_are_upright(survey, line, target):
    command, *words = line.split()
    source = next(word for word in words if "." in word and not word[0].isdigit())
    options = [word for word in words if word != source]
    report = answer(command, survey / source, survey / target, *options)
    assert report["files"]
    stored = loom.read_triangle_mesh(survey / target, up="y").vertices
    assert np.ptp(stored, axis=0).round(1).tolist() == pytest.approx([2.0, 3.0, 2.0], abs=0.25)
    assert stored[stored[:, 1].argmax(), 1] - np.median(stored[:, 1]) > 0
    wide, narrow = (np.ptp(stored[np.argsort(stored[:, 1])[part]], axis=0) for part in (slice(40), slice(-40, None)))
    assert wide[0] > narrow[0]  # the tip is at the top
    run("convert", survey / target, survey / "again.ply")
    extent = np.ptp(loom.read_triangle_mesh(survey / "again.ply").vertices, axis=0)
    upright = 1 if source == "lying.glb" else 2  # a file that was repaired has y up
    assert int(extent.argmax()) == upright


def test_textures_are_converted_or_reported_as_left_out(tmp_path):
    plane = loom.TriangleMesh.create_plane(create_uv_map=True)
    plane.textures = [np.full((4, 6, 3), 9, np.uint8)]
    loom.write_triangle_mesh(tmp_path / "a.obj", plane)
    for name, left_out in (("b.glb", []), ("c.ply", []), ("d.stl", ["textures"]), ("e.off", ["textures"])):
        assert answer("convert", tmp_path / "a.obj", tmp_path / name)["left_out"] == left_out
    assert answer("convert", tmp_path / "a.obj", tmp_path / "f.xyz")["left_out"] == ["triangles", "textures"]
    for name in ("a.obj", "b.glb", "c.ply"):
        (report,) = answer("info", tmp_path / name)["files"]
        assert report["textures"] == "6 x 4" and report["attributes"] == {"texture_coordinates": "float32 x 2"}


def test_info_lists_the_clouds_of_a_folder_and_those_that_are_broken(cloud, mesh, tmp_path):
    for name in ("scan10.ply", "scan2.ply"):
        (tmp_path / name).write_bytes(cloud.read_bytes())
    (tmp_path / "notes.txt").write_text("nothing to read\n")
    (report,) = answer("info", tmp_path)["files"]
    assert (report["kind"], report["points"]) == ("folder of clouds", 1504)
    assert [Path(file["path"]).name for file in report["files"]] == ["cloud.ply", "mesh.ply", "scan2.ply", "scan10.ply"]
    printed = run("info", tmp_path).stdout
    assert "scan2.ply: 500 points, [" in printed and "mesh.ply: 4 vertices, 2 triangles, [" in printed
    for name in ("a.ply", "b.ply"):
        (tmp_path / name).write_bytes(cloud.read_bytes()[:-1])
    result = run("info", tmp_path)
    assert result.exit_code == 1 and "a.ply: broken" in result.stdout and "cloud.ply: 500 points" in result.stdout
    assert f"error: {tmp_path / 'a.ply'} (byte " in result.stderr
    assert f"(and 1 more files of {tmp_path})" in result.stderr


def test_info_continues_after_a_broken_file(cloud, tmp_path):
    broken = tmp_path / "broken.ply"
    broken.write_bytes(cloud.read_bytes()[:-1])
    result = run("info", broken, tmp_path / "missing.pcd", cloud, tmp_path / "x.docx")
    assert result.exit_code == 1 and "500" in result.stdout
    for name in ("broken.ply", "missing.pcd: does not exist", "x.docx"):
        assert name in result.stderr
    result = run("info", broken, cloud, "--json")
    assert result.exit_code == 1
    assert ["error" in report for report in json.loads(result.stdout)["files"]] == [True, False]


@pytest.mark.parametrize("name", ["odd.docx", "odd.obj", "odd.json", "odd.txt", "odd.png", "odd.npy"])
def test_info_rejects_unknown_files(tmp_path, name):
    (tmp_path / name).write_text("{}")
    assert refusal("info", tmp_path / name).startswith(f"error: {tmp_path / name}")


def test_convert_reports_omitted_attributes(tmp_path, request):
    for source, suffix, left_out in (
        ("cloud", ".xyz", ["colors", "intensity"]),
        ("cloud", ".xyzrgb", ["intensity"]),
        ("cloud", ".pts", []),
        ("mesh", ".stl", ["colors"]),
        ("mesh", ".obj", []),
        ("mesh", ".off", []),
        ("mesh", ".glb", []),
        ("mesh", ".pcd", ["triangles"]),
    ):
        output = tmp_path / f"out{suffix}"
        assert answer("convert", request.getfixturevalue(source), output)["left_out"] == left_out
        printed = run("convert", request.getfixturevalue(source), output, "--force").stdout
        assert ("left out" in printed) == bool(left_out) and output.stat().st_size > 0


def test_convert_rejects_unsupported_outputs(cloud, tmp_path):
    for output, reason in (
        ("out.stl", "contains no triangles"),
        ("out.xyzn", "needs normals"),
        ("out.docx", "not written to .docx"),
        ("out", "a name without extension"),
    ):
        assert reason in refusal("convert", cloud, tmp_path / output)
    assert " ".join(storing("normals")) in refusal("normals", cloud, tmp_path / "out.xyz")
    assert "Leave out --ascii" in refusal("convert", cloud, tmp_path / "out.npz", "--ascii")
    assert names_in(tmp_path) == ["cloud.ply"]
    answer("convert", cloud, tmp_path / "out.ply", "--ascii")
    assert b"format ascii" in (tmp_path / "out.ply").read_bytes()


@pytest.mark.parametrize(("options", "side"), [(["--direction", 0, 0, -1], -1), (["--toward", 0.5, 0.5, 9], 1)])
def test_normals_are_oriented_as_requested(tmp_path, rng, device, options, side):
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(np.column_stack([rng.random((200, 2)), np.zeros(200)])))
    words = ["normals", tmp_path / "a.ply", tmp_path / "b.ply", "--radius", "0.3", "--device", device, *options]
    assert answer(*words)["points"] == 200
    normals = loom.read_point_cloud(tmp_path / "b.ply").normals
    np.testing.assert_allclose(normals, np.tile([0, 0, side], (200, 1)), atol=1e-5)


@pytest.mark.filterwarnings("default::UserWarning")
def test_a_radius_without_neighbors_is_unreliable(cloud, tmp_path):
    result = run("normals", cloud, tmp_path / "out.ply", "--radius", "0.0001")
    assert result.exit_code == 3
    assert "give a larger --radius" in result.stderr and "warning" not in result.stderr  # once is enough
    assert "out.ply" in result.stdout
    loom.write_point_cloud(cloud, loom.PointCloud(np.full((4, 3), np.nan)))
    assert run("normals", cloud, tmp_path / "b.ply", "--radius", "1").exit_code == 3


@pytest.mark.parametrize(("isolated", "exit_code"), [(40, 0), (60, 3)])
def test_normals_are_unreliable_if_over_half_of_the_points_are_isolated(tmp_path, isolated, exit_code):
    together = np.random.default_rng(0).random((100 - isolated, 3)) * 0.1
    alone = np.column_stack([np.arange(1, isolated + 1) * 10.0, np.zeros((isolated, 2))])
    loom.write_point_cloud(tmp_path / "in.ply", loom.PointCloud(np.concatenate([together, alone])))
    result = run("normals", tmp_path / "in.ply", tmp_path / "out.ply", "--radius", 1)
    assert result.exit_code == exit_code, result.stderr
    assert ("most points have fewer than 3 points within 1 m" in result.stderr) == (exit_code == 3)


MODEL = ring_model()


@pytest.mark.parametrize(("form", "subfolder"), [("bin", "."), ("txt", "sparse/0")])
def test_info_reports_a_colmap_model(tmp_path, form, subfolder):
    loom.write_colmap_model(tmp_path / subfolder, MODEL, format=form)
    (report,) = answer("info", tmp_path)["files"]
    assert report["kind"] == "COLMAP model" and report["form"] == {"bin": "binary", "txt": "text"}[form]
    assert report["folder"] == (None if subfolder == "." else subfolder)
    assert (report["images"], report["points"], report["observations"]) == (6, 40, len(MODEL.observations))
    assert sorted(line.split()[0] for line in report["cameras"]) == ["OPENCV", "SIMPLE_RADIAL"]
    assert report["mean_views"] == pytest.approx(len(MODEL.observations) / 40) and 0 < report["mean_error_px"] < 1
    printed = run("info", tmp_path).stdout
    assert "SIMPLE_RADIAL 640 x 480, 500, 320, 240, -0.05; 4 images" in printed and "arbitrary" in printed


def test_info_reports_metashape_cameras_and_a_model_without_points(tmp_path):
    loom.write_colmap_model(tmp_path, loom.SfmModel(MODEL.names, MODEL.cameras, MODEL.T_camera_world))
    (report,) = answer("info", tmp_path)["files"]
    assert (report["points"], report["mean_views"], report["bounds"]) == (0, None, None)
    assert run("info", tmp_path).exit_code == 0
    (tmp_path / "cameras.xml").write_text(document(camera() + camera("lost", None)))
    (report,) = answer("info", tmp_path / "cameras.xml")["files"]
    assert report["kind"] == "Metashape cameras" and report["images"] == 1
    assert report["left_out"] == ["lost: not aligned"]
    assert report["camera_bounds"] == {"min": [2, 3, 4], "max": [2, 3, 4]}


@pytest.fixture
def autzen(scan_file):
    """110,000 compressed points in feet; every 22nd point in tests/data."""
    return scan_file("lidar-pdal/laz/autzen_trim.laz")


def test_info_reports_the_header(autzen, shipped_file):
    header = laspy.read(autzen).header
    count, low, high = header.point_count, header.mins, header.maxs
    first, second = answer("info", autzen, shipped_file("lidar-pdal/autzen/autzen-utm.las"))["files"]
    assert (first["kind"], first["points"], first["point_format"]) == ("point cloud", count, 3)
    assert first["version"] == "LAS 1.2, compressed" and first["scale"] == [0.01, 0.01, 0.01]
    assert first["offset"] == [0, 0, 0] and first["coordinate_system"] == "NAD_1983_HARN_Lambert_Conformal_Conic"
    assert first["bounds"]["min"] == pytest.approx(low) and first["bounds"]["max"] == pytest.approx(high)
    assert (first["unit"], second["unit"]) == ("foot", "metre") and first["attributes"]["gps_time"] == "float64"
    assert first["attributes"]["colors"] == "float32 x 3" and second["version"] == "LAS 1.2"
    printed = run("info", autzen).stdout
    assert f"[{low[0]:.4f}, {low[1]:.4f}, {low[2]:.4f}] to" in printed and "[0.01, 0.01, 0.01]" in printed
    assert "  foot (0.3048 m)\n" in printed and f"{count:,}" in printed and count >= 5000


def test_info_lists_the_scans_of_an_e57_file(tmp_path, rng):
    loom.write_point_cloud(tmp_path / "a.e57", loom.PointCloud(rng.random((9, 3)), scan_index=np.arange(9) % 2))
    (report,) = answer("info", tmp_path / "a.e57")["files"]
    assert report["points"] == 9
    assert report["scans"] == [f"Scan 0: 5 points, at {[0.0] * 3}".replace("0.0", "0.0000"), report["scans"][1]]
    assert "Scan 1: 4 points" in run("info", tmp_path / "a.e57").stdout


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_convert_between_las_files_keeps_integers_scale_and_coordinate_system(autzen, tmp_path, suffix):
    output = tmp_path / f"out{suffix}"
    assert answer("convert", autzen, output)["left_out"] == []
    before, after = laspy.read(autzen), laspy.read(output)
    for name in before.point_format.dimension_names:
        if name not in ("red", "green", "blue"):
            np.testing.assert_array_equal(np.asarray(before[name]), np.asarray(after[name]))
    reports = answer("info", autzen, output)["files"]
    for name in ("points", "point_format", "scale", "offset", "coordinate_system", "attributes"):
        assert reports[0][name] == reports[1][name]
    for corner in ("min", "max"):
        assert reports[0]["bounds"][corner] == pytest.approx(reports[1]["bounds"][corner], rel=1e-14)


def test_convert_preserves_las_attributes_in_other_formats(autzen, tmp_path):
    source = tmp_path / "in.las"
    las = laspy.read(autzen)
    las.points = las.points[:500]
    las.write(source)
    for name in ("a.ply", "a.npz", "a.pcd"):
        assert answer("convert", source, tmp_path / name)["left_out"] == []
        assert answer("convert", tmp_path / name, tmp_path / f"{name}.laz")["left_out"] == []
        result = laspy.read(tmp_path / f"{name}.laz")
        np.testing.assert_allclose(result.xyz, las.xyz, rtol=0, atol=1e-6)
        for field in ("intensity", "classification", "return_number", "gps_time", "scan_angle_rank"):
            np.testing.assert_array_equal(np.asarray(result[field]), np.asarray(las[field]))


@pytest.mark.filterwarnings("always::UserWarning")
def test_convert_reports_attributes_that_las_and_e57_do_not_support(tmp_path, rng):
    cloud = loom.PointCloud(rng.random((5, 3)), intensity=rng.random(5), label=np.arange(5), flag=np.ones(5, bool))
    loom.write_point_cloud(tmp_path / "a.npz", cloud)
    assert answer("convert", tmp_path / "a.npz", tmp_path / "a.las")["left_out"] == ["flag"]
    assert "'intensity' as 'intensity_value'" in run("convert", tmp_path / "a.npz", tmp_path / "b.laz").stderr
    result = laspy.read(tmp_path / "a.las")
    np.testing.assert_array_equal(result["label"], np.arange(5))
    np.testing.assert_array_equal(result["intensity_value"], cloud["intensity"])
    assert answer("convert", tmp_path / "a.npz", tmp_path / "a.e57")["left_out"] == ["label", "flag"]
    np.testing.assert_array_equal(loom.read_point_cloud(tmp_path / "a.e57")["intensity"], cloud["intensity"])


def test_damaged_files_and_missing_packages_are_one_line_errors(autzen, tmp_path, monkeypatch):
    broken = tmp_path / "broken.laz"
    broken.write_bytes(autzen.read_bytes()[: autzen.stat().st_size * 5 // 6])
    for command in (["info", broken], ["convert", broken, tmp_path / "out.ply"]):
        result = run(*command)
        assert result.exit_code == 1 and result.stderr.startswith(f"error: {broken}")
        assert "truncated or damaged: the table of chunks" in result.stderr and "Traceback" not in result.stderr
    monkeypatch.setitem(sys.modules, "laspy", None)
    result = run("info", autzen)
    assert result.exit_code == 1 and 'pip install "pointloom[las]"' in result.stderr


@pytest.mark.filterwarnings("always::pointloom.io.points.las_crs.GeographicWarning")
def test_a_file_in_degrees_causes_a_warning_and_keeps_its_rows(tmp_path, rng):
    degrees, raw = tmp_path / "degrees.las", rng.integers(0, 10_000, (200, 3))
    records = {2112: 'GEOGCS["WGS 84",UNIT["degree",0.01745]]'}
    write_raw(degrees, raw, records, scales=[1e-7, 1e-7, 0.001], offsets=[-123, 44, 0])
    result = run("downsample", degrees, tmp_path / "some.laz", "--farthest", 50)
    assert result.exit_code == 0 and "degrees.las: x and y are degrees" in result.stderr
    stored, selected = ({*map(tuple, laspy.read(path).xyz.tolist())} for path in (degrees, tmp_path / "some.laz"))
    assert len(selected) == 50 and selected <= stored


@pytest.mark.filterwarnings("always::UserWarning")
@pytest.mark.parametrize(("suffix", "is_rounded"), [(".ply", True), (".pcd", True), (".e57", True), (".laz", False)])
def test_convert_warns_about_rounded_colors(tmp_path, suffix, is_rounded):
    for red, is_finer in ((1000, True), (257, False)):
        colors = np.array([[red, 0, 65535], [0, 0, 0]]) / 65535
        loom.write_point_cloud(tmp_path / "a.las", loom.PointCloud(np.eye(3)[:2], colors=colors))
        messages = run("convert", tmp_path / "a.las", tmp_path / f"out{suffix}", "--force").stderr
        assert ("rounded to the 8 bits" in messages) == (is_rounded and is_finer)


ROOT = Path(__file__).resolve().parents[2]


def start(*words: object, **streams) -> subprocess.Popen:
    environment = os.environ | {"PYTHONPATH": str(ROOT / "src")}
    words = [sys.executable, "-m", "pointloom", *map(str, words)]
    return subprocess.Popen(words, stderr=subprocess.PIPE, env=environment, **streams)


@pytest.mark.parametrize("extension", ["ply", "npz"])
def test_pipes_carry_the_same_bytes_as_files(cloud, tmp_path, extension):
    out = tmp_path / f"out.{extension}"
    assert run("downsample", cloud, out, "--every", "3").exit_code == 0
    words = ["downsample", "-", "-", "--every", "3", "--from", "ply", "--to", extension]
    piped = run(*words, content=cloud.read_bytes())
    assert piped.exit_code == 0, piped.stderr
    assert piped.stdout_bytes == out.read_bytes() and "standard input" in piped.stderr
    assert "files    standard output" in piped.stderr
    assert "pointloom-" not in piped.stderr  # no name of a temporary file


def test_info_reads_standard_input_among_files(cloud):
    result = run("info", cloud, "-", "--from", "ply", "--json", content=cloud.read_bytes())
    first, second = json.loads(result.stdout)["files"]
    assert second == first | {"path": "standard input"}


def test_register_reads_one_of_its_clouds_from_a_pipe(cloud):
    words = ["--from", "ply", "--init", "identity", "--method", "point-to-point", "--voxel", "0.1", "--json"]
    piped = run("register", "-", cloud, *words, content=cloud.read_bytes())
    assert piped.exit_code == 0, piped.stderr
    report = json.loads(piped.stdout)
    assert (report["source"], report["target"]) == ("standard input", str(cloud))
    np.testing.assert_allclose(report["transformation"], np.eye(4), atol=1e-6)


def test_a_damaged_cloud_in_a_pipe_is_named(cloud):
    for words in (["convert", "-", "-", "--from", "ply", "--to", "pcd"], ["info", "-", "--from", "ply"]):
        result = run(*words, content=cloud.read_bytes()[:-1])
        assert result.exit_code == 1 and result.stdout == ""
        assert result.stderr.startswith("error: standard input (byte ")
    assert "standard input (byte 0): is empty" in run("info", "-", "--from", "ply", content=b"").stderr


def test_an_unreliable_result_writes_nothing_to_the_pipe_and_json_excludes_the_cloud(cloud, tmp_path):
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(np.full((4, 3), np.nan)))
    result = run("clean", tmp_path / "a.ply", "-", "--to", "ply")
    assert (result.exit_code, result.stdout_bytes) == (3, b"")
    result = run("convert", cloud, "-", "--to", "ply", "--json")
    assert result.exit_code == 2 and "--json and - both use standard output" in result.stderr


@pytest.mark.skipif(not hasattr(os, "openpty"), reason="this system has no pseudo-terminals")
@pytest.mark.parametrize(
    ("words", "end"),
    [
        pytest.param(["info", "-", "--from", "ply"], "input", marks=pytest.mark.slow),
        (["convert", "CLOUD", "-", "--to", "ply"], "output"),
    ],
)
def test_a_terminal_is_rejected_as_a_pipe(cloud, words, end):
    controller, terminal = os.openpty()
    words = [str(cloud) if word == "CLOUD" else word for word in words]
    stdin, stdout = (terminal, subprocess.PIPE) if end == "input" else (subprocess.DEVNULL, terminal)
    process = start(*words, stdin=stdin, stdout=stdout)
    _, stderr = process.communicate(timeout=300)
    os.close(terminal)
    os.close(controller)
    assert process.returncode == 2 and f"standard {end} is a terminal" in stderr.decode()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no /dev/full")
@pytest.mark.slow
@pytest.mark.parametrize("words", ["info CLOUD --json", "info CLOUD", "convert CLOUD - --to ply"])
def test_a_full_disk_behind_standard_output_is_one_line(cloud, words):
    with Path("/dev/full").open("wb") as full:
        process = start(*(cloud if word == "CLOUD" else word for word in words.split()), stdout=full)
        _, stderr = process.communicate(timeout=300)
    assert process.returncode == 1
    assert stderr.decode().splitlines()[-1] == "error: standard output: No space left on device"
    assert b"Traceback" not in stderr and b"Exception ignored" not in stderr


@pytest.mark.slow
def test_a_closed_pipe_prints_no_error(cloud):
    read, write = os.pipe()
    os.close(read)
    process = start("info", cloud, "--json", stdout=write)
    os.close(write)
    _, stderr = process.communicate(timeout=300)
    assert (process.returncode, stderr) == (1, b"")


def test_separate_texture_files_are_rejected_for_a_pipe(tmp_path):
    mesh = loom.TriangleMesh.create_plane(create_uv_map=True)
    mesh.textures = [np.full((4, 4, 3), 200, np.uint8)]
    loom.write_triangle_mesh(tmp_path / "plane.glb", mesh)
    words = ("clean-mesh", tmp_path / "plane.glb", "-", "--to")
    refused = run(*words, "obj", content=b"")
    assert refused.exit_code == 2 and "pass --to glb" in refused.stderr
    piped = run(*words, "glb", content=b"")
    (tmp_path / "piped.glb").write_bytes(piped.stdout_bytes)
    assert loom.read_triangle_mesh(tmp_path / "piped.glb").textures[0].shape == (4, 4, 3)


@pytest.mark.filterwarnings("always::UserWarning")
@pytest.mark.parametrize("words", [("convert",), ("downsample", "--every", "2"), ("normals",), ("merge",)])
@pytest.mark.parametrize("name", ["a.e57", "a.ptx"])
def test_commands_print_the_fields_that_some_scans_lack(tmp_path, rng, name, words):
    colored_and_plain(tmp_path, rng)
    command, *options = words
    result = run(command, tmp_path / name, *options, "-o", tmp_path / "b.ply")
    assert result.exit_code in (0, 3), result.stderr
    assert f"{name}: the colors are dropped, because not all scans have them" in result.stderr
    assert not loom.read_point_cloud(tmp_path / "b.ply").has_colors


@pytest.mark.filterwarnings("always::UserWarning")
def test_convert_prints_the_elements_of_a_ply_that_a_cloud_cannot_store(tmp_path):
    head = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
    (tmp_path / "a.ply").write_text(f"{head}element edge 1\nproperty int a\nend_header\n1 2 3\n0\n")
    result = run("convert", tmp_path / "a.ply", tmp_path / "b.pcd")
    assert "a cloud cannot store them: element 'edge'" in result.stderr and result.exit_code == 0


@pytest.mark.parametrize(
    ("files", "text"),
    [
        (["map.laz"], "pointloom view map.laz"),
        (["my map.copc.laz", "path.log", "map.png"], "pointloom view 'my map.copc.laz' path.log"),
        (["a.ply", "b.ply", "c.ply", "d.ply"], "pointloom view a.ply b.ply c.ply"),
        (["dtm.tif", "report.html"], "pointloom view dtm.tif"),
        (["report.html", "report.png"], "open report.html in a browser"),
        (["pose.txt", "table.csv", "pose.json", "volume.npz"], ""),
        ([], ""),
    ],
)
def test_the_next_command_shows_the_written_files(files, text):
    assert next_command(files) == text


def test_reports_end_with_the_next_command(cloud, drive, frames, tmp_path):
    mesh, page, poses = tmp_path / "m.glb", tmp_path / "page.html", tmp_path / "path.log"
    ends = {
        ("downsample", cloud, tmp_path / "a.ply", "--every", 3): f"pointloom view {tmp_path / 'a.ply'}",
        ("mesh", cloud, mesh, "--method", "alpha", "--alpha", 1): f"pointloom view {mesh}",
        ("view", cloud, "--save-html", page): f"open {page} in a browser",
        ("odometry", drive, "-o", poses, "--voxel", 0.5): f"pointloom view {poses}",
        ("track", frames, "-o", tmp_path / "track.log", "--voxel", 0.05): f"pointloom view {tmp_path / 'track.log'}",
    }
    for words, text in ends.items():
        assert run(*words).stdout.splitlines()[-1].split(None, 1) == ["next", text], words
    assert "next" not in answer("downsample", cloud, tmp_path / "b.ply", "--every", 3)
    assert "next  " not in run("view", cloud, "--screenshot", tmp_path / "a.png").stdout
    assert (
        "next"
        not in run(
            "downsample", "-", "-", "--every", 3, "--from", "ply", "--to", "ply", content=cloud.read_bytes()
        ).stderr
    )
