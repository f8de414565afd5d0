"""Coordinate systems of trajectories: read, written, kept and compared."""

import numpy as np
import pytest

import pointloom as loom

POSES = np.tile(np.eye(4), (3, 1, 1))
POSES[:, :3, 3] = np.array([412_300.0, 5_651_200.0, 120.0]) + np.arange(3)[:, None]
CAMERA = loom.PinholeCameraIntrinsic(4, 3, 1.0, 1.0, 1.0, 0.0)
WKT = 'PROJCS["a system,\n of two lines",UNIT["metre",1]]'


def trajectory(crs=25832, **options):
    return loom.Trajectory(POSES, crs=crs, **options)


@pytest.mark.parametrize("name", ["a.tum", "a.txt", "a.json"])
@pytest.mark.parametrize("crs", ["EPSG:25832", "EPSG:25832+7837", WKT, None])
def test_a_file_keeps_the_system_and_the_poses(tmp_path, name, crs):
    form = {"format": "tum"} if name == "a.txt" else {"intrinsic": CAMERA} if name == "a.json" else {}
    loom.write_trajectory(tmp_path / name, trajectory(crs), **form)
    back = loom.read_trajectory(tmp_path / name)
    assert (None if back.crs is None else back.crs.text) == (
        None if crs is None else " ".join(crs.split()) if name != "a.json" else crs
    )
    np.testing.assert_array_equal(back.poses, POSES)


@pytest.mark.parametrize("name", ["a.log", "a.kitti"])
def test_formats_without_a_system_name_the_loss(tmp_path, name):
    with pytest.warns(UserWarning, match=r"cannot store the coordinate system EPSG:25832; \.tum and \.json do"):
        loom.write_trajectory(tmp_path / name, trajectory())
    assert loom.read_trajectory(tmp_path / name).crs is None


def test_a_comment_gives_every_text_format_a_system(tmp_path):
    loom.write_trajectory(tmp_path / "a.kitti", trajectory(None))
    (tmp_path / "a.kitti").write_text("# crs EPSG:25833\n# crs nonsense\n" + (tmp_path / "a.kitti").read_text())
    assert loom.read_trajectory(tmp_path / "a.kitti").crs.epsg == 25833


def test_open3d_reads_our_json_with_a_system(o3d, tmp_path):
    loom.write_trajectory(tmp_path / "a.json", trajectory(), intrinsic=CAMERA)
    path = o3d.io.read_pinhole_camera_trajectory(str(tmp_path / "a.json"))
    np.testing.assert_allclose(np.linalg.inv(path.parameters[2].extrinsic), POSES[2])


def test_lost_poses_and_repr_keep_the_system(tmp_path):
    loom.write_trajectory(tmp_path / "a.tum", trajectory())
    text = (tmp_path / "a.tum").read_text().replace("\n1.0 ", "\n1.0 nan nan nan 0 0 0 1\n1.5 ")
    (tmp_path / "a.tum").write_text(text)
    back = loom.read_trajectory(tmp_path / "a.tum", skip_missing=True)
    assert repr(back) == "Trajectory(3 poses, timestamps, EPSG:25832)"


def test_two_systems_are_not_compared():
    with pytest.raises(ValueError, match="EPSG:25832 and EPSG:25833"):
        loom.registration.evaluate_trajectory(trajectory(), trajectory(25833))
    assert loom.registration.evaluate_trajectory(trajectory(), trajectory(None)).absolute_translation.rmse < 1e-9


@pytest.mark.parametrize("wrong", [3.5, "somewhere", -1, [25832]])
def test_other_values_are_no_system(wrong):
    with pytest.raises((TypeError, ValueError), match="crs"):
        trajectory(wrong)


EUROC = "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z []"
HALF = 0.7071067811865476


@pytest.mark.parametrize("more", ["", ", v_x, v_y"])
@pytest.mark.parametrize("separator", [",", ", "])
@pytest.mark.parametrize("head", [EUROC, EUROC[1:], EUROC.replace("timestamp", "timestamp [ns]"), None])
def test_the_ground_truth_of_euroc_is_read(tmp_path, head, separator, more):
    rows = [[1403715529912140032 + k * 5_000_000, 0.5 * k, 1.0, -2.0, HALF, 0.0, 0.0, HALF] for k in range(3)]
    lines = [separator.join(map(str, row + [9.0, 9.0] * bool(more))) for row in rows]
    (tmp_path / "data.csv").write_text("\r\n".join([*([] if head is None else [head + more]), *lines, ""]))
    found = loom.read_trajectory(tmp_path / "data.csv")
    np.testing.assert_allclose(found.timestamps - 1403715529.912140032, [0, 0.005, 0.01], atol=3e-7)
    assert found.poses[:, :3, 3].tolist() == [[0, 1, -2], [0.5, 1, -2], [1, 1, -2]]
    np.testing.assert_allclose(found.poses[2, :3, :3], [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-15)


@pytest.mark.parametrize("text", [
    EUROC.replace("w []", "u []").replace("q_RS_z", "q_RS_w") + "\n1403715529912140032,0,0,0,1,0,0,0\n",
    EUROC + "\n1403715529.91,0,0,0,1,0,0,0\n", "17,0,0,0,1,0,0,0\n", EUROC + "\n1403715529912140032,0,0,0,1,0,0\n",
    EUROC + "\n1403715529912140032,0,0,0,2,0,0,0\n", EUROC + "\n", "x,y,z\n1,2,3\n",
])  # fmt: skip
def test_other_tables_are_no_ground_truth_of_euroc(tmp_path, text):
    (tmp_path / "data.csv").write_text(text)
    with pytest.raises(loom.FileError, match=r"data\.csv"):
        loom.read_trajectory(tmp_path / "data.csv")
