"""What a graph's last operations say, and files in which nothing can be read."""

import hypothesis
import hypothesis.strategies as st
import numpy as np
import pytest
from onnx import TensorProto, helper, numpy_helper

from pointloom.photos.depth.affine_points import recover_pinhole
from pointloom.photos.depth.graph import GraphError, read_graph
from pointloom.photos.depth.heads import BINS, BROKEN, CLAMPED, EXP, INVERSE, RECIPROCAL, SIGMOID, Head, find_head

make = helper.make_node


def model_of(*nodes, functions=(), **constants):
    """A model of these nodes from x to y, as bytes; constants of any type."""
    tensors = [
        value if isinstance(value, TensorProto) else numpy_helper.from_array(np.asarray(value))
        for value in constants.values()
    ]
    for tensor, name in zip(tensors, constants, strict=True):
        tensor.name = name
    ends = [[helper.make_tensor_value_info(name, TensorProto.FLOAT, None)] for name in "xy"]
    graph = helper.make_graph(list(nodes), "g", *ends, tensors)
    opsets = [helper.make_opsetid("", 17), helper.make_opsetid("own", 1)]
    return helper.make_model(graph, opset_imports=opsets, functions=list(functions)).SerializeToString()


def head_of(*nodes, **more):
    return find_head(read_graph(model_of(*nodes, **more)), "y")


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
def test_a_number_is_read_however_it_is_stored(number, factor):
    *nodes, constant = scaled("Sigmoid", number)
    assert head_of(*nodes, m=constant) == Head(SIGMOID, factor)


def test_a_number_that_is_a_node_or_comes_first_is_read_too():
    nodes = [make("Sigmoid", ["x"], ["a"]), make("Constant", [], ["m"], value=numpy_helper.from_array(np.float32(20)))]
    assert head_of(*nodes, make("Mul", ["m", "a"], ["y"])) == Head(SIGMOID, 20)
    nodes[1] = make("Constant", [], ["m"], value_float=20.0)
    assert head_of(*nodes, make("CastLike", ["m", "a"], ["n"]), make("Mul", ["a", "n"], ["y"])) == Head(SIGMOID, 20)
    assert head_of(make("Sigmoid", ["x"], ["a"]), make("Div", ["a", "m"], ["y"]), m=np.float32(0.05)).kind == SIGMOID


def test_what_changes_shape_or_type_alone_is_passed_over():
    chain = ["Resize", "Squeeze", "Unsqueeze", "Cast", "Reshape", "Transpose", "Gather", "Slice", "Identity", "Clip"]
    nodes, value = [make("Relu", ["x"], ["v0"])], "v0"
    for k, operation in enumerate(chain):
        nodes.append(
            make(operation, [value, "", "", ""][: 1 if operation in ("Cast", "Identity") else 4], [f"v{k + 1}"])
        )
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
def test_the_operation_that_decides_is_found(nodes, constants, head):
    made = [make(first, inputs, [last]) for first, *inputs, last in (line.split() for line in nodes)]
    found = head_of(*made, **{name: np.float32(value) for name, value in constants.items()})
    assert found.kind == head.kind
    assert found.factor == pytest.approx(head.factor)


def test_heads_inside_functions_are_found():
    opsets = [helper.make_opsetid("", 17), helper.make_opsetid("own", 1)]
    sigmoid = helper.make_function(
        "own", "last", ["p", "q"], ["r"], [make("Sigmoid", ["p"], ["s"]), make("Mul", ["s", "q"], ["r"])], opsets
    )
    whole = helper.make_function(
        "own",
        "model",
        ["u", "w"],
        ["z"],
        [make("last", ["u", "w"], ["t"], domain="own"), make("Squeeze", ["t"], ["z"])],
        opsets,
    )
    for functions, name in (([sigmoid], "last"), ([sigmoid, whole], "model")):
        nodes = [make("Conv", ["x", "m"], ["a"]), make(name, ["a", "m"], ["y"], domain="own")]
        assert head_of(*nodes, functions=functions, m=np.float32(80)) == Head(SIGMOID, 80)


def test_functions_and_values_that_never_end_say_nothing():
    opsets = [helper.make_opsetid("own", 1)]
    endless = helper.make_function("own", "f", ["p"], ["r"], [make("f", ["p"], ["r"], domain="own")], opsets)
    assert head_of(make("f", ["x"], ["y"], domain="own"), functions=[endless]) == Head()
    assert head_of(make("Identity", ["y"], ["y"])) == Head()


GOOD = model_of(*scaled("Sigmoid", None)[:2], m=np.float32(20))


@hypothesis.given(st.integers(0, len(GOOD) - 1), st.integers(0, 255))
def test_a_damaged_file_is_an_error_or_a_head_and_never_anything_else(at, byte):
    damaged = GOOD[:at] + bytes([byte]) + GOOD[at + 1 :]
    for content in (damaged, GOOD[:at]):
        try:
            find_head(read_graph(content), "y")
        except GraphError:
            continue


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
def test_focal_length_and_shift_of_a_point_map_come_back(focal, shift, size):
    points, valid = size * point_map(slope(), focal, shift), np.ones((60, 90), bool)
    free = recover_pinhole(points, valid, None)
    assert free is not None
    assert free.focal == pytest.approx((focal, focal), rel=1e-4)
    assert free.shift == pytest.approx(size * shift, abs=1e-3 * size)
    known = recover_pinhole(points, valid, (focal, focal))
    assert known is not None
    assert (known.focal, known.shift) == ((focal, focal), pytest.approx(size * shift, abs=1e-3 * size))


def test_noise_of_one_percent_moves_the_focal_length_little():
    found = recover_pinhole(point_map(slope(), 80.0, 0.6, noise=0.01), np.ones((60, 90), bool), None)
    assert found is not None
    assert found.focal == pytest.approx((80, 80), rel=0.05)


def test_a_wall_from_the_front_fixes_no_focal_length():
    points, valid = point_map(np.full((60, 90), 3.0), 80.0, 0.6, noise=0.002), np.ones((60, 90), bool)
    found = recover_pinhole(points, valid, None)
    assert found is not None
    assert found.focal is None
    assert recover_pinhole(points, np.zeros((60, 90), bool), None) is None
