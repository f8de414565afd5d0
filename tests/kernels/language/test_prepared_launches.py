"""Prepared launches: later launches of a kernel get their own arguments."""

import ctypes
import gc
import weakref
from typing import Any

import numpy as np
import pytest
import warp as wp

from pointloom.kernels import lang, launches, memory
from pointloom.kernels.language import prepared_launches
from pointloom.kernels.language.prepared_launches import WarpLaunch
from pointloom.kernels.language.taichi_launches import TaichiLaunch

pytestmark = pytest.mark.both_compilers
SOURCE = """
@kernel
def note_arguments_kernel(
    rows: array(dtype=float32, ndim=2), points: array(dtype=vec3d), small: array(dtype=uint8), limit: float,
    wide: float64, count: int, far: int64, key: uint64, shift: vec3, cell: vec3i, R: mat33d, out: array(dtype=float64),
    whole: array(dtype=int64),
):
    i = tid()
    out[0] = float64(rows.shape[0]) * float64(1000.0) + float64(rows.shape[1])
    out[1] = points[i][2]
    out[2] = float64(limit)
    out[3] = wide
    for k in range(3):
        out[4 + k] = float64(shift[k])
        for j in range(3):
            out[7 + 3 * k + j] = R[k, j]
    whole[0] = int64(small[i])
    whole[1] = int64(count)
    whole[2] = far
    whole[3] = int64(key >> uint64(1))
    whole[4] = int64(cell[2])

@kernel
def scale_kernel(a: array(dtype=float32), factor: float, out: array(dtype=float32)):
    i = tid()
    out[i] = a[i] * factor

@reduction
def add_up(a: array(dtype=float32), factor: float) -> vec2:
    i = tid()
    return vec2(a[i] * factor, 1.0)
"""


@pytest.fixture(scope="module")
def kernels(write_kernels):
    return write_kernels("prepared_launches", SOURCE)


FIRST = dict(shape=(2, 3), z=5.0, small=7, limit=0.5, wide=0.1, count=3, far=-5, key=12, R=1.0)
FIRST |= dict(shift=(1, 2, 3), cell=(4, 5, 6))


def noted(kernels, device, given_rows=None, **changed):
    given = {**FIRST, **changed}
    R = given["R"] * np.arange(9.0).reshape(3, 3)
    out, integers = memory.zeros(16, lang.float64, device), memory.zeros(5, lang.int64, device)
    arguments = [
        memory.zeros(given["shape"], lang.float32, device) if given_rows is None else given_rows,
        memory.upload(np.array([[0, 0, given["z"]]]), lang.vec3d, device),
        memory.upload(np.array([given["small"]], np.uint8), lang.uint8, device),
        *(given[name] for name in ("limit", "wide", "count", "far", "key", "shift", "cell")),
        R, out, integers,
    ]  # fmt: skip
    lang.launch(kernels.note_arguments_kernel, 1, arguments)
    rows, columns = given["shape"]
    with np.errstate(over="ignore"):
        limit = np.float32(given["limit"])
    floats = [rows * 1000 + columns, given["z"], limit, given["wide"], *given["shift"], *R.ravel()]
    numbers = [given["small"], given["count"], given["far"], given["key"] >> 1, given["cell"][2]]
    return memory.download(out), memory.download(integers), np.array(floats), np.array(numbers)


CHANGES = (  # 1e39 is infinity in float32
    *({"shape": (5, 4)}, {"shape": (0, 4)}, {"z": -1.0}, {"small": 255}, {"limit": np.float32(2.5)}, {"limit": np.inf}),
    *({"limit": 1e39}, {"wide": 1e300}, {"count": -(2**31)}, {"count": np.int64(9)}, {"far": 2**63 - 1}),
    *({"key": 2**64 - 1}, {"shift": np.array([-1.0, 0.0, 8.0])}, {"shift": wp.vec3(3.0, 2.0, 1.0)}),
    *({"cell": (-1, 0, -(2**31))}, {"R": -0.25}),
)


@pytest.mark.parametrize("changed", CHANGES, ids=lambda changed: next(iter(changed)))
def test_a_launch_brings_each_argument_that_changed(kernels, device, changed):
    for case in ({}, changed, {}):
        out, integers, floats, numbers = noted(kernels, device, **case)
        np.testing.assert_array_equal(out, floats)
        np.testing.assert_array_equal(integers, numbers)


def test_an_array_of_another_shape_at_the_same_address_is_set_again(kernels, device):
    shared = memory.zeros(6, lang.float32, device)
    results = [noted(kernels, device, shared.reshape(shape), shape=shape)[0][0] for shape in ((2, 3), (3, 2))]
    assert results == [2003.0, 3002.0]


def test_a_negative_zero_is_no_positive_one(kernels, device):
    signs = []
    for factor in (0.0, -0.0, 0.0):
        a, out = memory.full(4, 1.0, lang.float32, device), memory.zeros(4, lang.float32, device)
        lang.launch(kernels.scale_kernel, 4, [a, factor, out])
        signs.append(bool(np.signbit(memory.download(out)).all()))
    assert signs == [False, True, False]


def test_a_sum_updates_its_arguments(kernels, device):
    results = []
    for count, factor in ((3000, 1.0), (10, 2.0), (3000, 0.5), (0, 1.0)):
        a = memory.full(max(count, 1), 1.0, lang.float32, device)
        results.append(memory.download(lang.reduce(kernels.add_up, count, [a, factor]))[0].tolist())
    assert results == [[3000.0, 3000.0], [20.0, 10.0], [1500.0, 3000.0], [0.0, 0.0]]


def prepared(kernel, compiler):
    return launches._by_warp[kernel] if compiler == "warp" else launches._by_taichi[kernel.taichi]


def host_arrays():
    return wp.full(8, 1.0, dtype=wp.float32, device="cpu"), wp.zeros(8, dtype=wp.float32, device="cpu")


def test_arguments_have_the_layout_of_warp(kernels):
    with lang.cpu_compiler("warp"):
        noted(kernels, "cpu")
    launch = prepared(kernels.note_arguments_kernel, "warp")
    assert launch._layout is not None and launch._layout.size % 8 == 0


def test_a_warp_that_lays_arguments_out_otherwise_launches_itself(kernels):
    a, out = host_arrays()
    kernel = kernels.scale_kernel.cpu
    command: Any = wp.launch(kernel, 1, [a, 2.0, out], device="cpu", record_cmd=True)
    params = command.params
    launch = WarpLaunch(kernel, [a, 2.0, out])

    class Ranked(ctypes.Structure):
        _fields_ = [("rank", ctypes.c_int32), *type(params[1])._fields_]

    parameters = [prepared_launches.Parameter.of(argument.type) for argument in kernel.adj.args]
    assert prepared_launches._read_layout(parameters, params[1:])[0] is not None
    assert prepared_launches._read_layout(parameters, [Ranked(), *params[2:]])[0] is None
    launch._layout = None
    launch.bound([a, 3.0, out], 8)()
    assert out.numpy().tolist() == [3.0] * 8


def taichi_launch(kernels):
    a, out = host_arrays()
    lang.launch(kernels.scale_kernel, 8, [a, 2.0, out])
    return prepared(kernels.scale_kernel, "taichi")


@pytest.mark.taichi
def test_a_launch_that_is_interrupted_leaves_nothing_half_set(kernels, monkeypatch):
    with lang.cpu_compiler("taichi"):
        launch = taichi_launch(kernels)
        fill = TaichiLaunch._fill

        def interrupted(self, context, values):
            fill(self, context, values)
            raise KeyboardInterrupt

        monkeypatch.setattr(TaichiLaunch, "_fill", interrupted)
        with pytest.raises(KeyboardInterrupt):
            lang.launch(kernels.scale_kernel, 8, [*host_arrays()[:1], 5.0, host_arrays()[1]])
        monkeypatch.undo()
        assert launch._idle is None
        a, out = host_arrays()
        lang.launch(kernels.scale_kernel, 8, [a, 3.0, out])
    assert out.numpy().tolist() == [3.0] * 8


@pytest.mark.taichi
def test_a_launch_within_a_launch_of_the_same_kernel_changes_nothing_of_it(kernels, monkeypatch):
    """As a signal handler may, between the setting of arguments and the launch."""
    with lang.cpu_compiler("taichi"):
        taichi_launch(kernels)
        fill, inner, outer = TaichiLaunch._fill, host_arrays(), host_arrays()

        def interfering(self, context, values):
            fill(self, context, values)
            monkeypatch.setattr(TaichiLaunch, "_fill", fill)
            lang.launch(kernels.scale_kernel, 8, [inner[0], 7.0, inner[1]])

        monkeypatch.setattr(TaichiLaunch, "_fill", interfering)
        lang.launch(kernels.scale_kernel, 8, [outer[0], 5.0, outer[1]])
    assert (inner[1].numpy().tolist(), outer[1].numpy().tolist()) == ([7.0] * 8, [5.0] * 8)


@pytest.mark.parametrize("compiler", ["warp", "taichi"])
def test_a_kernel_is_prepared_once_and_stores_no_array(kernels, compiler):
    a, out = host_arrays()
    with lang.cpu_compiler(compiler):
        made = []
        for factor in (1.0, 2.0):
            lang.launch(kernels.scale_kernel, 8, [a, factor, out])
            made.append(prepared(kernels.scale_kernel, compiler))
    assert made[0] is made[1]
    gone = weakref.ref(out)
    del out
    gc.collect(1)  # what was made since the test began
    assert gone() is None


def test_the_first_launch_of_a_kernel_stores_no_array(kernels):
    a, out = host_arrays()
    made, gone = WarpLaunch(kernels.scale_kernel.on_host, [a, 2.0, out]), weakref.ref(out)
    made.bound([a, 2.0, out], 8)()
    del out
    gc.collect(1)
    assert gone() is None
