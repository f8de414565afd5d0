"""Cameras exported by Metashape: poses and lenses as in its manual, and invalid files."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.models.metashape import read_metashape_cameras

POSE = "0 -1 0 2 1 0 0 3 0 0 1 4 0 0 0 1"  # 90 degrees about z, at (2, 3, 4)
ROTATION = "<rotation locked='true'>0 0 1 1 0 0 0 1 0</rotation>"
TRANSFORM = f"<transform>{ROTATION}<translation>10 20 30</translation><scale locked='true'>2</scale></transform>"


def sensor(lens: str, *, kind: str = "frame", number: int = 0, resolution: str = "width='640' height='480'") -> str:
    return (
        f"<sensor id='{number}' type='{kind}'><resolution {resolution}/>"
        f"<calibration type='{kind}' class='initial'><resolution {resolution}/><f>1</f></calibration>"
        f"<calibration type='{kind}' class='adjusted'><resolution {resolution}/>{lens}</calibration></sensor>"
    )


def camera(label: str = "IMG_1", pose: str | None = POSE, more: str = "", number: int = 0) -> str:
    transform = "" if pose is None else f"<transform>{pose}</transform>"
    tags = f"{transform}<orientation>1</orientation>"
    return f"<camera id='{number}' sensor_id='0' label='{label}' {more}>{tags}</camera>"


def document(cameras: str, sensors: str = sensor("<f>500</f>"), more: str = "") -> str:
    return (
        "<?xml version='1.0' encoding='UTF-8'?>\n<document version='2.0.0'><chunk label='Chunk 1' enabled='true'>"
        f"<sensors>{sensors}</sensors>{more}<cameras>{cameras}</cameras></chunk></document>"
    )


def read(tmp_path, text: str | bytes) -> loom.SfmModel:
    path = tmp_path / "cameras.xml"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_metashape_cameras(path)


def test_camera_center_is_read_from_its_transform(tmp_path):
    model = read(tmp_path, document(camera()))
    assert model.names == ("IMG_1",) and model.centers.tolist() == [[2, 3, 4]]
    assert (model.T_world_camera[0, :3, 0] == [0, 1, 0]).all()  # its x axis


@pytest.mark.parametrize("what", ["chunk", "component"])
def test_chunk_and_component_transforms_apply_to_cameras(tmp_path, what):
    component = f"<components><component id='7'>{TRANSFORM}</component></components>"
    text = document(camera(more="component_id='7'"), more=TRANSFORM if what == "chunk" else component)
    model = read(tmp_path, text)
    assert model.centers[0].tolist() == pytest.approx([10 + 2 * 4, 20 + 2 * 2, 30 + 2 * 3])
    assert model.T_world_camera[0, :3, 0].tolist() == pytest.approx([0, 0, 1])
    assert np.linalg.det(model.T_camera_world[0, :3, :3]) == pytest.approx(1)


def test_a_component_counts_above_the_chunk_and_only_for_its_own_cameras(tmp_path):
    more = f"<components><component id='7'>{TRANSFORM}</component></components><transform><scale>5</scale></transform>"
    cameras = camera("a", more="component_id='7'") + camera("b", more="component_id='8'")
    model = read(tmp_path, document(cameras, more=more))
    assert model.centers[0].tolist() == pytest.approx([18, 24, 36])
    assert model.centers[1].tolist() == pytest.approx([10, 15, 20])


def test_geocentric_positions_keep_their_precision(tmp_path):
    transform = "<translation>-2499366.429888 -4256836.520906 4029217.965003</translation><scale>12.35</scale>"
    model = read(tmp_path, document(camera(), more=f"<transform>{transform}</transform>"))
    expected = np.array([-2499366.429888, -4256836.520906, 4029217.965003]) + 12.35 * np.array([2, 3, 4])
    assert np.abs(model.centers[0] - expected).max() < 1e-8


def test_cameras_without_a_pose_are_reported(tmp_path):
    cameras = "<group id='0'>" + camera("in a group") + "</group>"
    cameras += camera("lost", None) + camera("off", more="enabled='false'") + camera("old", more="enabled='0'")
    cameras += camera("right eye", None, more="master_id='0'")
    model = read(tmp_path, document(cameras))
    assert model.names == ("in a group",)
    expected = ("lost: not aligned", "off: disabled", "old: disabled", "right eye: of a multi-camera system")
    assert model.left_out == expected


@pytest.mark.parametrize(
    ("kind", "terms", "model"),
    [
        ("frame", {}, "SIMPLE_PINHOLE"),
        ("frame", {"b1": 3}, "PINHOLE"),
        ("frame", {"k1": -0.1}, "SIMPLE_RADIAL"),
        ("frame", {"k1": -0.1, "k2": 0.02}, "RADIAL"),
        ("frame", {"k1": -0.1, "b1": 3}, "OPENCV"),
        ("frame", {"k1": -0.1, "p1": 1e-3, "p2": -2e-3}, "OPENCV"),
        ("frame", {"k1": -0.1, "k3": 0.01, "p1": 1e-3, "b1": 2}, "FULL_OPENCV"),
        ("frame", {"k1": -0.1, "k4": 0.01, "p1": 1e-3}, "METASHAPE"),
        ("frame", {"k1": -0.1, "b2": 0.5}, "METASHAPE"),
        ("fisheye", {"k1": 0.02, "k4": 0.001, "b1": 2}, "OPENCV_FISHEYE"),
        ("fisheye", {"k1": 0.02, "p1": 1e-3, "p2": -2e-3, "k4": 1e-3}, "THIN_PRISM_FISHEYE"),
        ("equidistant_fisheye", {"k1": 0.02, "b2": 0.5, "p1": 1e-3}, "METASHAPE_FISHEYE"),
    ],
)
def test_lens_becomes_the_simplest_equivalent_model(tmp_path, kind, terms, model):
    values = {"f": 500.0, "cx": 1.5, "cy": -2.25, **terms}
    lens = "".join(f"<{name}>{value}</{name}>" for name, value in values.items())
    result = read(tmp_path, document(camera(), sensor(lens, kind=kind))).cameras[0]
    assert result.model == model
    x, y = 0.3, -0.2
    if kind != "frame":
        r = np.hypot(x, y)
        x, y = x * np.arctan(r) / r, y * np.arctan(r) / r
    v = {name: values.get(name, 0.0) for name in ("f", "cx", "cy", "k1", "k2", "k3", "k4", "p1", "p2", "b1", "b2")}
    r2 = x * x + y * y
    radial = 1 + v["k1"] * r2 + v["k2"] * r2**2 + v["k3"] * r2**3 + v["k4"] * r2**4
    xd = x * radial + v["p1"] * (r2 + 2 * x * x) + 2 * v["p2"] * x * y
    yd = y * radial + v["p2"] * (r2 + 2 * y * y) + 2 * v["p1"] * x * y
    expected = [320 + v["cx"] + xd * v["f"] + xd * v["b1"] + yd * v["b2"], 240 + v["cy"] + yd * v["f"]]
    assert (result.project([[0.3, -0.2, 1.0]])[0] + 0.5).tolist() == pytest.approx(expected, abs=1e-9)


def test_initial_calibration_is_used_if_none_was_adjusted(tmp_path):
    lens = "<resolution width='640' height='480'/><calibration class='initial'><f>700</f></calibration>"
    model = read(tmp_path, document(camera(), f"<sensor id='0'>{lens}</sensor>"))
    assert model.cameras[0].params[0] == 700


BOMB = "<!DOCTYPE d [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;'>]><document>&b;</document>"
LEAK = "<!DOCTYPE d [<!ENTITY a SYSTEM 'file:///etc/hostname'>]><document>&a;</document>"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (BOMB, "declares a document type"),
        (LEAK, "declares a document type"),
        (BOMB.encode("utf-16"), "declares a document type"),
        ("<a>" * 1000, "more than 64 elements"),
        ("nothing", "line 1, column 0.*no XML|no XML"),
        ("<document><chunk>", "no XML"),
        ("<?xml version='1.0' encoding='none-such'?><document/>", "no XML|not read"),
        ("<document><chunk/><chunk/></document>", "got 2 chunks"),
        (document(camera(pose=None)), r"no aligned camera \(1 are disabled or not aligned\)"),
        (document(camera() + camera()), "'IMG_1' is duplicated.*label of its own"),
        (document(camera(pose=POSE.replace("2", "nan"))), "expected 16 finite numbers"),
        (document(camera(pose=POSE.replace("2", "1_0"))), "expected 16 finite numbers"),
        (document(camera(), more="<transform><scale>0</scale></transform>"), "the scale of the chunk is 0"),
        (document(camera(), more=f"<transform><rotation>{'1 ' * 9}</rotation></transform>"), "rotation of the chunk"),
        (document(camera(), sensors=""), "sensor '0', which is missing"),
        (document(camera(), "<sensor id='0'/>"), "sensor 0.*no calibration"),
        (document(camera(), sensor("<f>5</f>", kind="equisolid_fisheye")), "lens is 'equisolid_fisheye'"),
        (document(camera(), sensor("<f>5</f><p3>0.1</p3>")), "p3 is not supported"),
        (document(camera(), sensor("<f>x</f>")), "f of sensor 0: expected 1 finite"),
        (document(camera(), sensor("<cx>1</cx>")), "focal lengths above"),
        (document(camera(), sensor("<f>5</f>", resolution="width='6e2' height='4'")), "resolution .*, got '6e2'"),
        (document("<camera id='0' label='a'><transform>1</transform></camera>"), "has no sensor_id"),
    ],
)
def test_files_that_are_not_camera_exports_are_rejected(tmp_path, text, message):
    with pytest.raises(loom.FileError, match=message):
        read(tmp_path, text)
