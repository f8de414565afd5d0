"""info, convert and normals: reports, outputs and errors."""

import json
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.trajectory import Trajectory, write_trajectory
from pointloom.io.pictures.image_files import write_png

from ..io.sfm_models import ring_model
from ..io.test_metashape import camera, document
from .commands import answer, names_in, refusal, run


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
    result = run("info", *paths)
    assert result.exit_code == 0, result.stderr
    assert all(str(path) in result.stdout for path in paths)


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
    np.ones((5, 4), "<f4").tofile(tmp_path / "a.bin")
    assert answer("convert", tmp_path / "a.bin", tmp_path / "c.ply")["points"] == 5
    (report,) = answer("info", tmp_path / "a.bin")["files"]
    assert report["attributes"] == {"intensity": "float32"}
    refused = run("convert", mesh, tmp_path / "a.csv")
    assert "clouds and meshes are not written to .csv" in refused.stderr


def test_up_rotates_formats_with_an_up_axis(mesh, tmp_path):
    answer("convert", mesh, tmp_path / "turned.glb", "--up", "z")
    answer("convert", tmp_path / "turned.glb", tmp_path / "again.ply", "--up", "z")
    answer("convert", tmp_path / "turned.glb", tmp_path / "as_it_is.gltf")
    x, y, z = loom.read_triangle_mesh(mesh).vertices.T
    rotated = loom.read_triangle_mesh(tmp_path / "as_it_is.gltf").vertices
    np.testing.assert_allclose(rotated, np.stack([x, z, -y], axis=1), atol=1e-6)
    np.testing.assert_allclose(loom.read_triangle_mesh(tmp_path / "again.ply").vertices.T, [x, y, z], atol=1e-6)
    report = answer("compare-meshes", mesh, tmp_path / "turned.glb", "--up", "z", "--samples", "100")
    assert report["hausdorff"] < 1e-6


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
    reports = json.loads(result.stdout)["files"]
    assert ["error" in report for report in reports] == [True, False]


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
    assert ".ply .pcd .npz .xyzn" in refusal("normals", cloud, tmp_path / "out.xyz")
    assert "Leave out --ascii" in refusal("convert", cloud, tmp_path / "out.npz", "--ascii")
    assert names_in(tmp_path) == ["cloud.ply"]
    answer("convert", cloud, tmp_path / "out.ply", "--ascii")
    assert b"format ascii" in (tmp_path / "out.ply").read_bytes()


@pytest.mark.parametrize(("options", "side"), [(["--direction", 0, 0, -1], -1), (["--toward", 0.5, 0.5, 9], 1)])
def test_normals_are_oriented_as_requested(tmp_path, rng, device, options, side):
    flat = np.column_stack([rng.random((200, 2)), np.zeros(200)])
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(flat))
    words = ["normals", tmp_path / "a.ply", tmp_path / "b.ply", "--radius", "0.3", "--device", device, *options]
    assert answer(*words)["points"] == 200
    normals = loom.read_point_cloud(tmp_path / "b.ply").normals
    np.testing.assert_allclose(normals, np.tile([0, 0, side], (200, 1)), atol=1e-5)


@pytest.mark.filterwarnings("default::UserWarning")
def test_a_radius_without_neighbors_is_unreliable(cloud, tmp_path):
    result = run("normals", cloud, tmp_path / "out.ply", "--radius", "0.0001")
    assert result.exit_code == 3
    assert "use a larger --radius" in result.stderr and "warning" not in result.stderr  # once is enough
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
    assert ("60.0% of the points have fewer than 3 neighbors within 1 m" in result.stderr) == (exit_code == 3)


MODEL = ring_model()


@pytest.mark.parametrize(("form", "subfolder"), [("bin", "."), ("txt", "sparse/0")])
def test_info_reports_a_colmap_model(tmp_path, form, subfolder):
    loom.write_colmap_model(tmp_path / subfolder, MODEL, format=form)
    (report,) = answer("info", tmp_path)["files"]
    assert report["kind"] == "COLMAP model" and report["form"] == {"bin": "binary", "txt": "text"}[form]
    assert report["folder"] == (None if subfolder == "." else subfolder)
    assert (report["pictures"], report["points"], report["observations"]) == (6, 40, len(MODEL.observations))
    assert sorted(line.split()[0] for line in report["cameras"]) == ["OPENCV", "SIMPLE_RADIAL"]
    assert report["mean_views"] == pytest.approx(len(MODEL.observations) / 40) and 0 < report["mean_error_px"] < 1
    printed = run("info", tmp_path).stdout
    assert "SIMPLE_RADIAL 640 x 480, 500, 320, 240, -0.05; 4 pictures" in printed and "arbitrary" in printed


def test_info_reports_metashape_cameras_and_a_model_without_points(tmp_path):
    loom.write_colmap_model(tmp_path, loom.SfmModel(MODEL.names, MODEL.cameras, MODEL.T_camera_world))
    (report,) = answer("info", tmp_path)["files"]
    assert (report["points"], report["mean_views"], report["bounds"]) == (0, None, None)
    assert run("info", tmp_path).exit_code == 0
    (tmp_path / "cameras.xml").write_text(document(camera() + camera("lost", None)))
    (report,) = answer("info", tmp_path / "cameras.xml")["files"]
    assert report["kind"] == "Metashape cameras" and report["pictures"] == 1
    assert report["left_out"] == ["lost: not aligned"]
    assert report["camera_bounds"] == {"min": [2, 3, 4], "max": [2, 3, 4]}
