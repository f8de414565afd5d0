"""Metric depth networks give meters; output heads are detected; files of another kind are rejected."""

import hypothesis
import hypothesis.strategies as st
import numpy as np
import pytest
from onnx import TensorProto, helper, numpy_helper

import pointloom as loom
from pointloom.photogrammetry import DepthModel
from pointloom.photogrammetry.depth import heads
from pointloom.photogrammetry.depth.graph import load_graph, read_graph
from pointloom.photogrammetry.depth.heads import BINS, BROKEN, CLAMPED, EXP, INVERSE, RECIPROCAL, SIGMOID, Head
from pointloom.photogrammetry.depth.network_outputs import recover_pinhole
from pointloom.photogrammetry.depth.presets import NETWORK_PRESETS

from .published_networks import FILES, FOCAL, depth_of, image_of, published
from .tiny_networks import FLOAT, linear, save

VALID = [name for name in FILES if name != "dav2 broken"]
METRIC = [name for name in VALID if NETWORK_PRESETS[FILES[name][0]].output == "metric"]
BY_FOCAL = [name for name in METRIC if FILES[name][0].startswith("metric3d")]


def camera_of(image, focal=FOCAL):
    height, width = image.shape[:2]
    return loom.PinholeCameraIntrinsic(width, height, focal * width, focal * width, (width - 1) / 2, (height - 1) / 2)


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("published")
    return {name: published(folder / f"{name.replace(' ', '_')}.onnx", name) for name in FILES}


def canonical(name, image):
    """The divisor that gives meters: focal length of the input over that of the family."""
    if name not in BY_FOCAL:
        return 1.0
    model = NETWORK_PRESETS[FILES[name][0]]
    rows, columns = FILES[name][2]
    scale = min(rows / image.shape[0], columns / image.shape[1])
    return FOCAL * image.shape[1] * scale / model.focal


@pytest.mark.parametrize("name", [name for name in METRIC if not name.startswith("depth pro")])
def test_a_metric_network_gives_meters(name, files):
    image = image_of()
    result = loom.photogrammetry.estimate_depth(
        image, DepthModel(files[name], FILES[name][0]), intrinsic=camera_of(image)
    )
    assert (result.unit, result.is_metric, result.intrinsic_source) == ("m", True, "given")
    seen = result.depth > 0
    assert seen.mean() > 0.95
    ratio = result.depth[seen] / (depth_of(image)[seen] * canonical(name, image))
    assert np.median(ratio) == pytest.approx(1, rel=0.005)
    assert np.percentile(abs(ratio - 1), 90) < 0.03


@pytest.mark.parametrize(
    ("name", "size"),
    [("depth pro", (60, 80)), ("depth pro meters", (80, 60)), ("moge-2", (80, 60)), ("unidepth", (80, 60))],
)
def test_the_focal_length_of_the_network_replaces_an_unknown_camera(name, size, files):
    image = image_of(*size)
    result = loom.photogrammetry.estimate_depth(image, DepthModel(files[name], FILES[name][0]))
    assert (result.unit, result.intrinsic_source) == ("m", "the network")
    wide = 616 / 462 * 80 if name == "unidepth" else size[1]  # of the input with its borders
    assert result.intrinsic.fx == pytest.approx(FOCAL * wide, rel=0.01)
    assert (result.intrinsic.cx, result.intrinsic.cy) == pytest.approx(((size[1] - 1) / 2, (size[0] - 1) / 2), abs=0.6)
    seen = result.depth > 0
    assert np.median(result.depth[seen] / depth_of(image)[seen]) == pytest.approx(1, rel=0.01)


@pytest.mark.parametrize("name", ["depth pro", "depth pro meters"])
def test_a_known_focal_length_replaces_depth_pro_s(name, files):
    image = image_of()
    result = loom.photogrammetry.estimate_depth(
        image, DepthModel(files[name], "depth-pro"), intrinsic=camera_of(image, 2 * FOCAL)
    )
    seen = result.depth > 0
    assert np.median(result.depth[seen] / depth_of(image)[seen]) == pytest.approx(2, rel=0.005)


@pytest.mark.parametrize("name", VALID)
def test_a_file_of_the_other_kind_is_refused_under_every_preset(name, files):
    own = NETWORK_PRESETS[FILES[name][0]]
    for preset in NETWORK_PRESETS.values():
        if (preset.output == "inverse") == (own.output == "inverse"):
            continue
        with pytest.raises(loom.FileError):
            loom.photogrammetry.DepthModel(files[name], preset.name)


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
        loom.photogrammetry.DepthModel(files[name], preset)


@pytest.mark.parametrize("preset", ["depth-anything-v2", "depth-anything-v2-metric"])
def test_a_metric_network_with_a_relative_head_is_always_rejected(preset, files):
    with pytest.raises(loom.FileError, match=r"/dav2_broken\.onnx:.*20"):
        loom.photogrammetry.DepthModel(files["dav2 broken"], preset)


@pytest.mark.parametrize("name", VALID)
def test_published_files_need_no_notes(name, files):
    assert loom.photogrammetry.DepthModel(files[name], FILES[name][0]).notes == ()


@pytest.mark.parametrize("name", ["dav2 indoor", "metric3d"])
def test_metric_maps_are_aligned_by_scale_and_contradicting_references_rejected(name, files):
    image = image_of()
    truth = 3 * depth_of(image)
    truth[::2] = 0
    model, camera = DepthModel(files[name], FILES[name][0]), camera_of(image)
    result = loom.photogrammetry.estimate_depth(image, model, align=truth, intrinsic=camera)
    assert result.shift == 0
    assert result.scale * 3 / canonical(name, image) == pytest.approx(1, rel=0.01)
    assert result.inlier_fraction > 0.9
    with pytest.raises(ValueError, match=r"^align:.*3 distances.*got 1"):
        loom.photogrammetry.estimate_depth(
            image, model, align=[(5, 5, 1.0), (40, 30, 9.0), (50, 55, 30.0)], intrinsic=camera
        )


def test_an_unlabeled_file_and_depth_anything_3_are_accepted_with_a_note(files, tmp_path):
    (note,) = loom.photogrammetry.DepthModel(files["da3"], "depth-anything-3-metric").notes
    assert "does not specify that its depth is in meters" in note
    path = linear(tmp_path / "m.onnx", size=(28, 42))
    for preset, meaning in (("depth-anything-v2", "larger for nearer points"), ("depth-anything-v2-metric", "meters")):
        assert meaning in "".join(loom.photogrammetry.DepthModel(path, preset).notes)


def test_moge_s_sky_is_no_depth(files):
    image = image_of()
    image[:6] = 255
    result = loom.photogrammetry.estimate_depth(image, DepthModel(files["moge-2"], "moge-2"))
    assert not result.depth[:5].any()
    assert (result.depth[8:] > 0).all()


def test_points_inconsistent_with_any_camera_are_rejected(tmp_path):
    nodes = "ReduceMean image -> z axes=[1] keepdims=1; Concat z z z -> all axis=1;"
    nodes += "Transpose all -> points perm=[0,2,3,1]; ReduceMax z -> most keepdims=0; Reshape most one -> metric_scale"
    ends = [("image", FLOAT, [1, 3, "h", "w"])], [("points", FLOAT, None), ("metric_scale", FLOAT, None)]
    path, image = save(tmp_path / "m.onnx", nodes, *ends, one=np.array([1], np.int64)), image_of()
    for camera in (None, camera_of(image)):
        with pytest.raises(loom.FileError, match=r"/m\.onnx \(output 'points'\):"):
            loom.photogrammetry.estimate_depth(image, DepthModel(path, "moge-2"), intrinsic=camera)


def test_moge_gives_no_meters_for_a_frontal_wall_and_an_unknown_camera(files):
    wall = np.full((60, 80, 3), 100, np.uint8)
    wall[::7, ::5] = 101  # 4 cm of 4.5 m
    result = loom.photogrammetry.estimate_depth(wall, DepthModel(files["moge-2"], "moge-2"))
    assert (result.unit, result.intrinsic_source) == ("arbitrary", "assumed 60 degrees")
    known = loom.photogrammetry.estimate_depth(wall, DepthModel(files["moge-2"], "moge-2"), intrinsic=camera_of(wall))
    assert known.unit == "m"
    assert np.median(known.depth / depth_of(wall)) == pytest.approx(1, rel=0.02)


def test_metric3d_s_canvas_has_two_sizes_and_no_mixture_and_belongs_to_no_other_preset(tmp_path):
    for size in ((616, 616), (1064, 1064), (616, 1216)):
        with pytest.raises(loom.FileError, match=r"/m\.onnx \(input 'x'\):.*616.*1064.*1064.*616.*metric3d-v2"):
            loom.photogrammetry.DepthModel(linear(tmp_path / "m.onnx", size=size), "metric3d-v2")
    path = linear(tmp_path / "m.onnx", size=(616, 1064))
    with pytest.raises(loom.FileError, match=r"/m\.onnx:.*metric3d-v2"):
        loom.photogrammetry.DepthModel(path, "depth-anything-v2")
    assert "meters" in "".join(loom.photogrammetry.DepthModel(path, "metric3d-v2").notes)


@pytest.mark.parametrize("value", [190.0, 0.0])
def test_an_impossible_field_of_view_is_an_error(tmp_path, value):
    nodes = "ReduceMean x -> gray axes=[1] keepdims=1; Relu gray -> predicted_depth; ReduceMax gray -> most keepdims=0;"
    nodes += "Mul most zero -> nothing; Add nothing view -> field_of_view"
    ends = [("x", FLOAT, [1, 3, 1536, 1536])], [("predicted_depth", FLOAT, None), ("field_of_view", FLOAT, None)]
    path = save(tmp_path / "m.onnx", nodes, *ends, zero=np.float32(0), view=np.float32(value))
    with pytest.raises(loom.FileError, match=f"field of view of {value:g} degrees, which no lens has"):
        loom.photogrammetry.estimate_depth(image_of(), DepthModel(path, "depth-pro"))


make = helper.make_node


def model_of(*nodes, functions=(), **constants):
    """A model of these nodes from x to y; constants of any type."""
    tensors = []
    for name, value in constants.items():
        tensors.append(value if isinstance(value, TensorProto) else numpy_helper.from_array(np.asarray(value)))
        tensors[-1].name = name
    ends = [[helper.make_tensor_value_info(name, TensorProto.FLOAT, None)] for name in "xy"]
    graph = helper.make_graph(list(nodes), "g", *ends, tensors)
    opsets = [helper.make_opsetid("", 17), helper.make_opsetid("own", 1)]
    return helper.make_model(graph, opset_imports=opsets, functions=list(functions))


def head_of(*nodes, **more):
    return heads.find_head(read_graph(model_of(*nodes, **more)), "y")


def scaled(last, number):
    return make(last, ["x"], ["a"]), make("Mul", ["a", "m"], ["y"]), number


@pytest.mark.parametrize(
    ("number", "factor"),
    [
        (np.float32(20), 20), (np.array([[80.0]], np.float32), 80), (np.float64(20), 20), (np.float16(80), 80),
        (helper.make_tensor("m", TensorProto.FLOAT, [1], [20.0]), 20),
        (helper.make_tensor("m", TensorProto.FLOAT16, [], [20.0]), 20),
        (helper.make_tensor("m", TensorProto.DOUBLE, [], [20.0]), 20),
        (helper.make_tensor("m", TensorProto.INT64, [], [20]), 20),
    ],
)  # fmt: skip
def test_constants_are_read_from_every_storage_form(number, factor):
    *nodes, constant = scaled("Sigmoid", number)
    assert head_of(*nodes, m=constant) == Head(SIGMOID, factor)


def test_a_number_that_is_a_node_or_comes_first_is_read_too():
    nodes = [make("Sigmoid", ["x"], ["a"]), make("Constant", [], ["m"], value=numpy_helper.from_array(np.float32(20)))]
    assert head_of(*nodes, make("Mul", ["m", "a"], ["y"])) == Head(SIGMOID, 20)
    nodes[1] = make("Constant", [], ["m"], value_float=20.0)
    assert head_of(*nodes, make("CastLike", ["m", "a"], ["n"]), make("Mul", ["a", "n"], ["y"])) == Head(SIGMOID, 20)
    assert head_of(make("Sigmoid", ["x"], ["a"]), make("Div", ["a", "m"], ["y"]), m=np.float32(0.05)).kind == SIGMOID


def test_operations_on_shape_or_type_are_skipped():
    chain = ["Resize", "Squeeze", "Unsqueeze", "Cast", "Reshape", "Transpose", "Gather", "Slice", "Identity", "Clip"]
    nodes, value = [make("Relu", ["x"], ["v0"])], "v0"
    for k, operation in enumerate(chain):
        rest = [] if operation in ("Cast", "Identity") else ["", "", ""]
        nodes.append(make(operation, [value, *rest], [f"v{k + 1}"]))
        value = f"v{k + 1}"
    assert head_of(*nodes, make("Identity", [value], ["y"])) == Head(INVERSE)


@pytest.mark.parametrize(
    ("nodes", "constants", "head"),
    [
        (["Relu x a", "Mul a m y"], {"m": 1.0}, Head(INVERSE)),
        (["Relu x a", "Mul a m y"], {"m": 20.0}, Head(BROKEN, 20)),
        (["Relu x a", "Mul a m y"], {"m": 255.0}, Head(INVERSE, 255)),
        (["Relu x a", "Mul a m y"], {"m": -1.0}, Head()),
        (["Sigmoid x y"], {}, Head()),
        (["Clip x zero y"], {"zero": 0.0}, Head(INVERSE)),
        (["Max x zero y"], {"zero": 0.0}, Head(INVERSE)),
        (["Exp x y"], {}, Head(EXP)),
        (["Relu x a", "Reciprocal a y"], {}, Head(RECIPROCAL)),
        (["Relu x a", "Mul a w b", "Clip b low high c", "Div i c y"], {"low": 1e-4, "high": 1e4, "i": 1.0, "w": 2.0},
         Head(RECIPROCAL, 2.0)),
        (["Conv x k a", "Reciprocal a y"], {"k": 1.0}, Head()),
        (["Softmax x a", "Mul a b c", "ReduceSum c y"], {}, Head(BINS)),
        (["Relu x a", "ReduceSum a y"], {}, Head()),
        (["Sub m x a", "Relu a b", "Sub m b y"], {"m": 200.0}, Head(CLAMPED)),
        (["Sub m x a", "Relu a b", "Sub n b y"], {"m": 200.0, "n": 100.0}, Head()),
        (["Relu x a", "Sub m a y"], {"m": 200.0}, Head()),
        (["Relu x a", "ReduceMax a b", "Div a b y"], {}, Head()),
    ],
)  # fmt: skip
def test_the_deciding_operation_is_detected(nodes, constants, head):
    made = [make(first, inputs, [last]) for first, *inputs, last in (line.split() for line in nodes)]
    result = head_of(*made, **{name: np.float32(value) for name, value in constants.items()})
    assert result.kind == head.kind
    assert result.factor == pytest.approx(head.factor)


def test_heads_inside_functions_are_detected():
    opsets = [helper.make_opsetid("", 17), helper.make_opsetid("own", 1)]
    nodes = [make("Sigmoid", ["p"], ["s"]), make("Mul", ["s", "q"], ["r"])]
    sigmoid = helper.make_function("own", "last", ["p", "q"], ["r"], nodes, opsets)
    nodes = [make("last", ["u", "w"], ["t"], domain="own"), make("Squeeze", ["t"], ["z"])]
    outer = helper.make_function("own", "model", ["u", "w"], ["z"], nodes, opsets)
    for functions, name in (([sigmoid], "last"), ([sigmoid, outer], "model")):
        nodes = [make("Conv", ["x", "m"], ["a"]), make(name, ["a", "m"], ["y"], domain="own")]
        assert head_of(*nodes, functions=functions, m=np.float32(80)) == Head(SIGMOID, 80)


def test_recursive_functions_and_cyclic_values_give_no_head():
    opsets = [helper.make_opsetid("own", 1)]
    endless = helper.make_function("own", "f", ["p"], ["r"], [make("f", ["p"], ["r"], domain="own")], opsets)
    assert head_of(make("f", ["x"], ["y"], domain="own"), functions=[endless]) == Head()
    assert head_of(make("Identity", ["y"], ["y"])) == Head()


GOOD = model_of(*scaled("Sigmoid", None)[:2], m=np.float32(20))


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("models")


@hypothesis.given(st.integers(0, len(GOOD.SerializeToString()) - 1), st.integers(0, 255))
def test_a_damaged_file_gives_a_file_error_or_a_head(folder, at, byte):
    good, path = GOOD.SerializeToString(), folder / "damaged.onnx"
    for content in (good[:at] + bytes([byte]) + good[at + 1 :], good[:at]):
        path.write_bytes(content)
        try:
            heads.find_head(load_graph(str(path)), "y")
        except loom.FileError as error:
            assert "damaged.onnx" in str(error)


def field(number, content):
    """A field of bytes in the format of Protocol Buffers."""
    length, size = bytearray(), len(content)
    while size >= 0x80:
        length.append(size & 0x7F | 0x80)
        size >>= 7
    return bytes([number << 3 | 2, *length, size]) + content


def test_thousands_of_nested_graphs_are_an_error(folder):
    path, graph = folder / "nested.onnx", b""
    for _ in range(3000):
        graph = field(1, field(5, field(6, graph)))  # a node with an attribute that is a graph
    path.write_bytes(field(7, graph))
    with pytest.raises(loom.FileError, match=r"nested\.onnx"):
        loom.photogrammetry.DepthModel(path)


def test_thousands_of_nodes_and_functions_in_a_row_end(folder):
    nodes = [make("Identity", [f"v{k}"], [f"v{k + 1}"]) for k in range(5000)]
    opsets = [helper.make_opsetid("own", 1)]
    calls = [
        helper.make_function("own", f"f{k}", ["p"], ["r"], [make(f"f{k + 1}", ["p"], ["r"], domain="own")], opsets)
        for k in range(3000)
    ]
    path = folder / "long.onnx"
    path.write_bytes(model_of(*nodes, make("f0", ["x"], ["y"], domain="own"), functions=calls).SerializeToString())
    graph = load_graph(str(path))
    assert (heads.find_head(graph, "v5000"), heads.find_head(graph, "y")) == (Head(), Head())


def external(location):
    tensor = TensorProto(name="m", data_type=TensorProto.FLOAT, dims=[1], data_location=TensorProto.EXTERNAL)
    tensor.external_data.add(key="location", value=location)
    return tensor


def sparse(tensor):
    return helper.make_sparse_tensor(tensor, helper.make_tensor("i", TensorProto.INT64, [1], [0]), [1])


def branch(tensor):
    return helper.make_graph([], "b", [], [helper.make_tensor_value_info("m", TensorProto.FLOAT, [1])], [tensor])


TENSOR_LOCATIONS = {  # where a tensor can be in a model
    "initializer": lambda tensor: scaled("Relu", tensor),
    "attribute": lambda tensor: (make("Constant", [], ["y"], value=tensor), None),
    "sparse attribute": lambda tensor: (make("Constant", [], ["y"], sparse_value=sparse(tensor)), None),
    "branch": lambda tensor: (make("If", ["x"], ["y"], then_branch=branch(tensor)), None),
}


@pytest.mark.parametrize("stored_in", TENSOR_LOCATIONS)
@pytest.mark.parametrize("location", ["../../etc/passwd", "/etc/passwd", "", "..", "folder/weights", "link"])
def test_weights_outside_the_folder_are_refused_before_onnxruntime_starts(stored_in, location, tmp_path, monkeypatch):
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder" / "weights").write_bytes(bytes(4))
    (tmp_path / "link").symlink_to("/etc/passwd")
    path = tmp_path / "m.onnx"
    *nodes, tensor = TENSOR_LOCATIONS[stored_in](external(location))
    path.write_bytes(model_of(*nodes, **({} if tensor is None else {"m": tensor})).SerializeToString())
    monkeypatch.setattr("onnxruntime.InferenceSession", lambda *_, **__: pytest.fail("onnxruntime was started"))
    with pytest.raises(loom.FileError, match=r"m\.onnx"):
        loom.photogrammetry.DepthModel(path)


def test_external_constants_are_not_read(tmp_path):
    (tmp_path / "weights").write_bytes(np.float32(20).tobytes())
    *nodes, tensor = scaled("Relu", external("weights"))
    (tmp_path / "m.onnx").write_bytes(model_of(*nodes, m=tensor).SerializeToString())
    assert load_graph(str(tmp_path / "m.onnx")).constants == {}


def test_a_model_behind_a_link_takes_its_weights_from_either_folder(tmp_path):
    blobs, snapshot = tmp_path / "blobs", tmp_path / "snapshot"
    blobs.mkdir()
    snapshot.mkdir()
    (blobs / "a").write_bytes(model_of(*scaled("Relu", None)[:2], m=external("weights")).SerializeToString())
    (blobs / "b").write_bytes(bytes(4))
    (snapshot / "m.onnx").symlink_to("../blobs/a")
    (snapshot / "weights").symlink_to("../blobs/b")
    assert load_graph(str(snapshot / "m.onnx")).producers["y"].operation == "Mul"


def point_map(depth, focal, shift, noise=0.0):
    height, width = depth.shape
    v, u = np.mgrid[:height, :width] - np.array([(height - 1) / 2, (width - 1) / 2])[:, None, None]
    rng = np.random.default_rng(0)
    points = np.stack([u * depth / focal, v * depth / focal, depth - shift], -1)
    return points + noise * depth[..., None] * rng.normal(size=points.shape)


def slope(height=60, width=90):
    v, u = np.mgrid[:height, :width]
    return 2.0 + 3.0 * (1 - v / height) + 0.5 * (u > width / 2)


@hypothesis.given(st.floats(40, 400), st.floats(-5, 1.5), st.floats(0.01, 100))
@hypothesis.settings(max_examples=6, deadline=None)
def test_focal_length_and_shift_of_a_point_map_are_recovered(focal, shift, size):
    points, valid = size * point_map(slope(), focal, shift), np.ones((60, 90), bool)
    free = recover_pinhole(points, valid, None)
    assert free is not None
    assert free.focal == pytest.approx((focal, focal), rel=1e-4)
    assert free.shift == pytest.approx(size * shift, abs=1e-3 * size)
    known = recover_pinhole(points, valid, (focal, focal))
    assert known is not None
    assert (known.focal, known.shift) == ((focal, focal), pytest.approx(size * shift, abs=1e-3 * size))


def test_a_frontal_wall_does_not_determine_the_focal_length():
    points, valid = point_map(np.full((60, 90), 3.0), 80.0, 0.6, noise=0.002), np.ones((60, 90), bool)
    pinhole = recover_pinhole(points, valid, None)
    assert pinhole is not None
    assert pinhole.focal is None
    assert recover_pinhole(points, np.zeros((60, 90), bool), None) is None
