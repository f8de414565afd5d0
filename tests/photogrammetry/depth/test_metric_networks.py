"""Metric depth networks give meters, and files of another kind than the preset are rejected."""

import numpy as np
import pytest
from onnx import helper

import pointloom as loom
from pointloom.photogrammetry.depth.presets import PRESETS

from .published_networks import FILES, FOCAL, depth_of, picture_of, published
from .tiny_networks import FLOAT, linear, save

VALID = [name for name in FILES if name != "dav2 broken"]
METRIC = [name for name in VALID if PRESETS[FILES[name][0]].output == "metric"]
BY_FOCAL = [name for name in METRIC if FILES[name][0].startswith("metric3d")]


def camera_of(picture, focal=FOCAL):
    height, width = picture.shape[:2]
    return loom.PinholeCameraIntrinsic(width, height, focal * width, focal * width, (width - 1) / 2, (height - 1) / 2)


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("published")
    return {name: published(folder / f"{name.replace(' ', '_')}.onnx", name) for name in FILES}


def canonical(name, picture):
    """The divisor that gives meters: focal length of the input over that of the family."""
    if name not in BY_FOCAL:
        return 1.0
    model = PRESETS[FILES[name][0]]
    rows, columns = FILES[name][2]
    scale = min(rows / picture.shape[0], columns / picture.shape[1])
    return FOCAL * picture.shape[1] * scale / model.focal


@pytest.mark.parametrize("name", [name for name in METRIC if not name.startswith("depth pro")])
def test_a_metric_network_gives_meters(name, files):
    picture = picture_of()
    result = loom.estimate_depth(picture, files[name], preset=FILES[name][0], intrinsic=camera_of(picture))
    assert (result.unit, result.is_metric, result.intrinsic_source) == ("m", True, "given")
    seen = result.depth > 0
    assert seen.mean() > 0.95
    ratio = result.depth[seen] / (depth_of(picture)[seen] * canonical(name, picture))
    assert np.median(ratio) == pytest.approx(1, rel=0.005)
    assert np.percentile(abs(ratio - 1), 90) < 0.03


@pytest.mark.parametrize(
    ("name", "size"),
    [("depth pro", (60, 80)), ("depth pro meters", (80, 60)), ("moge-2", (80, 60)), ("unidepth", (80, 60))],
)
def test_the_focal_length_of_the_network_replaces_an_unknown_camera(name, size, files):
    picture = picture_of(*size)
    result = loom.estimate_depth(picture, files[name], preset=FILES[name][0])
    assert (result.unit, result.intrinsic_source) == ("m", "the network")
    wide = 616 / 462 * 80 if name == "unidepth" else size[1]  # of the input with its borders
    assert result.intrinsic.fx == pytest.approx(FOCAL * wide, rel=0.01)
    assert (result.intrinsic.cx, result.intrinsic.cy) == pytest.approx(((size[1] - 1) / 2, (size[0] - 1) / 2), abs=0.6)
    seen = result.depth > 0
    assert np.median(result.depth[seen] / depth_of(picture)[seen]) == pytest.approx(1, rel=0.01)


@pytest.mark.parametrize("name", ["depth pro", "depth pro meters"])
def test_a_known_focal_length_replaces_depth_pro_s(name, files):
    picture = picture_of()
    result = loom.estimate_depth(picture, files[name], preset="depth-pro", intrinsic=camera_of(picture, 2 * FOCAL))
    seen = result.depth > 0
    assert np.median(result.depth[seen] / depth_of(picture)[seen]) == pytest.approx(2, rel=0.005)


@pytest.mark.parametrize("name", VALID)
def test_a_file_of_the_other_kind_is_refused_under_every_preset(name, files):
    own = PRESETS[FILES[name][0]]
    for preset in PRESETS.values():
        if (preset.output == "inverse") == (own.output == "inverse"):
            continue
        with pytest.raises(loom.FileError):
            loom.DepthModel(files[name], preset.name)


@pytest.mark.parametrize(
    ("name", "preset", "wanted"),
    [
        ("dav2 indoor", "depth-anything-v2", "sigmoid times 20.*Use the preset depth-anything-v2-metric"),
        ("dav2 indoor", "depth-anything-3-metric", "Use the preset depth-anything-v2-metric"),
        ("dav2", "depth-anything-v2-metric", "ReLU, typical of relative.*Use the preset depth-anything-v2"),
        ("dav2", "depth-pro", "Use the preset depth-anything-v2"),
        ("zoedepth", "dpt", "sum over depth bins.*Use the preset zoedepth"),
        ("da3", "depth-anything-v2", "Use the preset depth-anything-3"),
        ("moge-2", "depth-anything-v2", "Use the preset moge-2"),
        ("unidepth", "depth-anything-v2", "Use the preset unidepth-v2"),
        ("metric3d", "depth-anything-v2", "clamped.*Use the preset metric3d-v2"),
        ("metric3d convnext", "metric3d-v2", "metric3d-convnext has this size"),
    ],
)
def test_the_error_names_the_matching_preset(name, preset, wanted, files):
    with pytest.raises(loom.FileError, match=wanted):
        loom.DepthModel(files[name], preset)


@pytest.mark.parametrize("preset", ["depth-anything-v2", "depth-anything-v2-metric"])
def test_a_metric_network_with_a_relative_head_is_always_rejected(preset, files):
    with pytest.raises(loom.FileError, match=r"/dav2_broken\.onnx:.*20"):
        loom.DepthModel(files["dav2 broken"], preset)


@pytest.mark.parametrize("name", VALID)
def test_published_files_need_no_notes(name, files):
    assert loom.DepthModel(files[name], FILES[name][0]).notes == ()


@pytest.mark.parametrize("name", ["dav2 indoor", "metric3d"])
def test_metric_maps_are_aligned_by_scale_and_contradicting_references_rejected(name, files):
    picture = picture_of()
    truth = 3 * depth_of(picture)
    truth[::2] = 0
    options = {"preset": FILES[name][0], "intrinsic": camera_of(picture)}
    result = loom.estimate_depth(picture, files[name], align=truth, **options)
    assert result.shift == 0
    assert result.scale * 3 / canonical(name, picture) == pytest.approx(1, rel=0.01)
    assert result.inlier_share > 0.9
    with pytest.raises(ValueError, match=r"^align:.*3 distances.*got 1"):
        loom.estimate_depth(picture, files[name], align=[(5, 5, 1.0), (40, 30, 9.0), (50, 55, 30.0)], **options)


def test_depth_anything_3_is_noted_as_not_labeled_metric(files):
    (note,) = loom.DepthModel(files["da3"], "depth-anything-3-metric").notes
    assert "does not specify that its depth is in meters" in note


def test_an_unlabeled_file_is_accepted_with_a_note(tmp_path):
    path = linear(tmp_path / "m.onnx", size=(28, 42))
    for preset, meaning in (("depth-anything-v2", "larger for nearer points"), ("depth-anything-v2-metric", "meters")):
        assert meaning in "".join(loom.DepthModel(path, preset).notes)


def test_moge_s_sky_is_no_depth(files):
    picture = picture_of()
    picture[:6] = 255
    result = loom.estimate_depth(picture, files["moge-2"], preset="moge-2")
    assert not result.depth[:5].any()
    assert (result.depth[8:] > 0).all()


def test_points_inconsistent_with_any_camera_are_rejected(tmp_path):
    nodes = [
        helper.make_node("ReduceMean", ["image"], ["z"], axes=[1], keepdims=1),
        helper.make_node("Concat", ["z", "z", "z"], ["all"], axis=1),
        helper.make_node("Transpose", ["all"], ["points"], perm=[0, 2, 3, 1]),
        helper.make_node("ReduceMax", ["z"], ["most"], keepdims=0),
        helper.make_node("Reshape", ["most", "one"], ["metric_scale"]),
    ]
    ends = [("image", FLOAT, [1, 3, "h", "w"])], [("points", FLOAT, None), ("metric_scale", FLOAT, None)]
    path, picture = save(tmp_path / "m.onnx", nodes, *ends, one=np.array([1], np.int64)), picture_of()
    for camera in (None, camera_of(picture)):
        with pytest.raises(loom.FileError, match=r"/m\.onnx \(output 'points'\):"):
            loom.estimate_depth(picture, path, preset="moge-2", intrinsic=camera)


def test_moge_gives_no_meters_for_a_frontal_wall_and_an_unknown_camera(files):
    wall = np.full((60, 80, 3), 100, np.uint8)
    wall[::7, ::5] = 101  # 4 cm of 4.5 m
    result = loom.estimate_depth(wall, files["moge-2"], preset="moge-2")
    assert (result.unit, result.intrinsic_source) == ("arbitrary", "assumed 60 degrees")
    known = loom.estimate_depth(wall, files["moge-2"], preset="moge-2", intrinsic=camera_of(wall))
    assert known.unit == "m"
    assert np.median(known.depth / depth_of(wall)) == pytest.approx(1, rel=0.02)


def test_metric3d_s_canvas_has_two_sizes_and_no_mixture(tmp_path):
    for size in ((616, 616), (1064, 1064), (616, 1216)):
        with pytest.raises(loom.FileError, match=r"/m\.onnx \(input 'x'\):.*616.*1064.*1064.*616.*metric3d-v2"):
            loom.DepthModel(linear(tmp_path / "m.onnx", size=size), "metric3d-v2")


def test_an_unlabeled_file_of_metric3d_s_size_is_rejected_by_other_presets(tmp_path):
    path = linear(tmp_path / "m.onnx", size=(616, 1064))
    with pytest.raises(loom.FileError, match=r"/m\.onnx:.*metric3d-v2"):
        loom.DepthModel(path, "depth-anything-v2")
    assert "meters" in "".join(loom.DepthModel(path, "metric3d-v2").notes)


@pytest.mark.parametrize("value", [190.0, 0.0])
def test_an_impossible_field_of_view_is_an_error(tmp_path, value):
    nodes = [
        helper.make_node("ReduceMean", ["x"], ["gray"], axes=[1], keepdims=1),
        helper.make_node("Relu", ["gray"], ["predicted_depth"]),
        helper.make_node("ReduceMax", ["gray"], ["most"], keepdims=0),
        helper.make_node("Mul", ["most", "zero"], ["nothing"]),
        helper.make_node("Add", ["nothing", "view"], ["field_of_view"]),
    ]
    ends = [("x", FLOAT, [1, 3, 1536, 1536])], [("predicted_depth", FLOAT, None), ("field_of_view", FLOAT, None)]
    path = save(tmp_path / "m.onnx", nodes, *ends, zero=np.float32(0), view=np.float32(value))
    with pytest.raises(loom.FileError, match=f"field of view of {value:g} degrees, which no lens has"):
        loom.estimate_depth(picture_of(), path, preset="depth-pro")
