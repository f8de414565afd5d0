"""Prepared launches on CUDA call the driver exactly as Warp does, argument by argument."""

import ctypes
from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp

from pointloom.kernels import lang, launches, memory
from pointloom.kernels.arrays.prefix_sum import inclusive_scan
from pointloom.kernels.arrays.segment_blocks import SegmentBlocks
from pointloom.kernels.arrays.sort import MAX_RANKED_KEYS, argsort_keys
from pointloom.kernels.language import cuda_launches, warp_parts

SOURCE = """
@struct
class Inner:
    limit: float64
    rows: array(dtype=int32, ndim=2)

@struct
class Outer:
    inner: Inner
    shift: vec3
    keys: array(dtype=int64)
    not_used: array(dtype=float32)

@kernel
def numbers_kernel(
    a: int32, b: int64, c: uint32, d: uint64, e: float, f: float64, g: int8, h: uint16, out: array(dtype=float64)
):
    i = tid()
    out[i] = f + float64(e) + float64(a) + float64(b) + float64(c) + float64(d) + float64(int(g)) + float64(int(h))

@kernel
def vectors_kernel(
    a: vec2, b: vec3, c: vec4, d: vec2i, e: vec3i, f: vec3d, g: mat33, h: mat44d, out: array(dtype=float64)
):
    i = tid()
    out[i] = float64(a[1] + b[2] + c[3] + g[2, 1]) + float64(d[1] + e[2]) + f[2] + h[3, 2]

@kernel
def arrays_kernel(
    one: array(dtype=float32), two: array(dtype=vec3, ndim=2), three: array(dtype=uint8, ndim=3),
    four: array(dtype=mat33d, ndim=4), out: array(dtype=int32),
):
    i = tid()
    out[i] = one.shape[0] + two.shape[1] * 10 + three.shape[2] * 100 + four.shape[3] * 1000

@kernel
def structures_kernel(outer: Outer, other: Inner, out: array(dtype=float64)):
    i = tid()
    found = outer.inner.limit + float64(outer.shift[1]) + other.limit
    out[i] = found + float64(outer.inner.rows[0, 1]) + float64(outer.keys[0])

@reduction
def add_up(a: array(dtype=float32), factor: float) -> vec2:
    i = tid()
    return vec2(a[i] * factor, 1.0)

@segment_reduction
def add_up_parts(a: array(dtype=float32), factor: float) -> vec2:
    i = tid()
    return vec2(a[i] * factor, 1.0)
"""
DEVICE = "cuda:0"
BLOCK = 4  # position of the block size in a driver call


@pytest.fixture(scope="module")
def kernels(emulated, write_kernels):
    return write_kernels("prepared_on_cuda", SOURCE)


@pytest.fixture
def where(emulated):
    return wp.get_device(DEVICE)


class LaunchRecorder:
    """Recorded driver calls: all parts of a launch but its arguments and block, and their bytes."""

    def __init__(self) -> None:
        self.launches: list[tuple] = []
        self.blocks: list[int] = []
        self.sizes: list[int] | None = None
        self.then = lambda: None  # what happens before the arguments are read

    def __call__(self, *given):
        *rest, addresses, stream, apic = given
        self.then()
        self.blocks.append(rest.pop(BLOCK))
        pointers = ctypes.cast(addresses, ctypes.POINTER(ctypes.c_void_p))
        sizes = self.sizes or []
        self.launches.append((rest, stream, apic, [ctypes.string_at(pointers[k], n) for k, n in enumerate(sizes)]))
        return 0


@pytest.fixture
def recorder(where, monkeypatch):
    result = LaunchRecorder()
    monkeypatch.setattr(warp_parts.core(), "wp_cuda_launch_kernel", result)
    return result


def sizes_of(kernel) -> list[int]:
    parameters = [cuda_launches.Parameter.of(argument.type) for argument in kernel.adj.args]
    return [24, *(56 if p.is_array else p.size for p in parameters)]


def check_same(recorder, kernel, count, arguments, values, device) -> None:
    """The second launch of pointloom, which is prepared, makes the same driver call as Warp's."""
    recorder.sizes = sizes_of(kernel.cuda)
    for _ in range(2):
        lang.launch(kernel, count, arguments)
    prepared = kernel.prepared[device.alias]
    assert prepared is not None and prepared.launch.is_known
    wp.launch(kernel.cuda, count, values, device=device)
    assert recorder.launches[-2] == recorder.launches[-1]
    assert recorder.launches[-1][0][2] == count


NUMBERS = (
    *((1, 2, 3, 4, 0.5, 0.1, 5, 6), (-(2**31), -(2**63), 2**32 - 1, 2**64 - 1, -0.0, 1e300, -128, 65535)),
    (np.int64(7), np.int8(-3), np.uint64(9), True, np.float64(0.1), np.float32(0.1), np.int32(1), np.uint8(2)),
    *((0, 0, 0, 0, x, y, 0, 0) for x, y in ((np.inf, -np.inf), (3, np.array(0.25)), (1e-45, 5e-324))),
)


@pytest.mark.parametrize("numbers", NUMBERS)
def test_numbers_are_passed_with_warps_bits(kernels, recorder, where, numbers):
    out = memory.zeros(4, lang.float64, where)
    check_same(recorder, kernels.numbers_kernel, 4, [*numbers, out], [*numbers, out], where)


VECTORS = [wp.vec2, wp.vec3, wp.vec4, wp.vec2i, wp.vec3i, wp.vec3d, wp.mat33, wp.mat44d]


@pytest.mark.parametrize("form", ["warp", "numpy", "flat", "list"])
def test_vectors_and_matrices_are_passed_with_warps_bits(kernels, recorder, where, form):
    rng, values, given = np.random.default_rng(0), [], []
    for kind in VECTORS:
        numbers = 10.0 * rng.standard_normal(kind._shape_)
        if kind._wp_scalar_type_ is wp.int32:
            numbers = np.rint(numbers).astype(int)
        values.append(kind(*numbers.ravel().tolist()))
        given.append({"warp": values[-1], "numpy": numbers, "flat": numbers.ravel(), "list": numbers.tolist()}[form])
    out = memory.zeros(4, lang.float64, where)
    check_same(recorder, kernels.vectors_kernel, 3, [*given, out], [*values, out], where)


FULL = (5,), (4, 3), (2, 3, 4), (2, 1, 3, 2)
EMPTY = (0,), (0, 3), (2, 0, 4), (0, 0, 0, 0)


@pytest.mark.parametrize("shapes", [FULL, EMPTY, [(1,) * axes for axes in (1, 2, 3, 4)]])
@pytest.mark.parametrize("make", ["ours", "warp's"])
def test_arrays_of_any_shape_are_passed_with_warps_bits(kernels, recorder, where, shapes, make):
    kinds = (wp.float32, wp.vec3, wp.uint8, wp.mat33d)
    new = memory.empty if make == "ours" else lambda s, t, d: wp.empty(s, dtype=t, device=d)
    given = [new(shape, kind, where) for shape, kind in zip(shapes, kinds, strict=True)] + [new(9, wp.int32, where)]
    check_same(recorder, kernels.arrays_kernel, 9, given, given, where)


def test_parts_of_arrays_are_passed_with_warps_bits(kernels, recorder, where):
    kinds = (wp.float32, wp.vec3, wp.uint8, wp.mat33d)
    bases = [memory.empty((9, 4, 3, 2)[: k + 1], kind, where) for k, kind in enumerate(kinds)]
    out = memory.empty(9, wp.int32, where)
    given, values = [memory.rows_of(a, 2, 7) for a in bases], [a[2:7] for a in bases]
    check_same(recorder, kernels.arrays_kernel, 9, [*given, out], [*values, out], where)
    check_same(recorder, kernels.arrays_kernel, 9, [*values, out], [*values, out], where)


def test_the_fields_of_structures_are_passed_with_warps_bits(kernels, recorder, where):
    inner = SimpleNamespace(limit=0.25, rows=memory.zeros((2, 3), lang.int32, where))
    outer = SimpleNamespace(inner=inner, shift=(1, 2, 3), keys=memory.zeros(5, lang.int64, where), not_used=None)
    out = memory.zeros(4, lang.float64, where)
    values = [0.25, inner.rows, wp.vec3(1.0, 2.0, 3.0), outer.keys, 0.25, out]
    check_same(recorder, kernels.structures_kernel, 4, [outer, inner, out], values, where)
    inner.limit, outer.shift, inner.rows = 8.0, wp.vec3(7.0, 8.0, 9.0), memory.zeros((4, 4), lang.int32, where)
    values = [8.0, inner.rows, outer.shift, outer.keys, 8.0, out]
    check_same(recorder, kernels.structures_kernel, 4, [outer, inner, out], values, where)


def test_a_small_launch_has_a_block_for_each_multiprocessor(kernels, recorder, where):
    assert where.sm_count == 132
    sizes = {
        1: 256,
        256: 256,
        257: 32,
        132 * 32: 32,
        9_600: 64,
        132 * 128: 128,
        132 * 256 - 1: 128,
        132 * 256: 256,
        10**6: 256,
    }
    out = memory.zeros(1, lang.float64, where)
    for count in (1, *sizes):  # the first launch may be Warp's
        lang.launch(kernels.numbers_kernel, count, [0, 0, 0, 0, 0.0, 0.0, 0, 0, out])
    assert recorder.blocks[1:] == [*sizes.values()]


def test_the_launch_of_a_sum_matches_warp(kernels, recorder, where, monkeypatch):
    recorder.sizes, a = sizes_of(kernels.add_up.cuda.tiles)[:-2], memory.zeros(1000, lang.float32, where)
    for is_plain in (True, True, False):
        monkeypatch.setattr(launches, "launches_plainly", lambda plain=is_plain: plain)
        lang.reduce(kernels.add_up, 1000, [a, 0.5])
    assert kernels.add_up.prepared[where.alias] is not None
    _, prepared, by_warp = recorder.launches
    assert prepared == by_warp


def test_sums_and_sums_of_segments_are_the_same_prepared(kernels, where, monkeypatch):
    rng = np.random.default_rng(0)
    a = memory.upload(rng.random(5000).astype(np.float32), lang.float32, where)
    blocks = SegmentBlocks([0, 0, 3000, 3001], [2000, 0, 1, 1999], where)
    live, results = memory.full(4, 1, lang.int32, where), []
    for is_plain in (False, True, True):
        monkeypatch.setattr(launches, "launches_plainly", lambda plain=is_plain: plain)
        total = lang.reduce(kernels.add_up, 5000, [a, 0.5])
        partials, out = blocks.partials(lang.vec2), memory.zeros(4, lang.vec2, where)
        lang.reduce_segments(kernels.add_up_parts, blocks, live, [a, 0.5], partials, out)
        results.append([memory.download(x).tolist() for x in (total, out)])
    assert kernels.add_up_parts.prepared[where.alias] is not None
    assert results[0] == results[1] == results[2]


def test_the_second_launch_is_prepared(kernels, where, monkeypatch):
    inner = SimpleNamespace(limit=1.0, rows=memory.zeros((1, 2), lang.int32, where))
    outer = SimpleNamespace(inner=inner, shift=(0, 2, 0), keys=memory.full(1, 4, lang.int64, where))
    out = memory.zeros(3, lang.float64, where)
    lang.launch(kernels.structures_kernel, 1, [outer, inner, out])
    monkeypatch.setattr(wp, "launch", lambda *_, **__: pytest.fail("by Warp"))
    lang.launch(kernels.structures_kernel, 3, [outer, inner, out])
    assert memory.download(out).tolist() == [8.0] * 3


def test_errors_are_the_same_before_and_after_preparation(kernels, where):
    out, number = memory.zeros(4, lang.float64, where), (1, 2, 3, 4, 0.5, 0.1, 5, 6)
    rows = memory.zeros((4, 2), lang.float64, where)
    wrong = {
        "argument a: 2147483648": (2**31, *number[1:], out),
        "int8": (*number[:6], 128, 6, out),
        "'float' object cannot be interpreted": (1.5, *number[1:], out),
        "takes 9 arguments, got 8": number,
        "expected a Warp array": (*number, np.zeros(4)),
        "expected": (*number, rows),
        "contiguous": (*number, rows[:, 0]),
    }
    messages = []
    for _ in range(2):
        for arguments in wrong.values():
            with pytest.raises((TypeError, ValueError)) as caught:
                lang.launch(kernels.numbers_kernel, 4, list(arguments))
            messages.append(str(caught.value))
        lang.launch(kernels.numbers_kernel, 4, [*number, out])
    assert messages[: len(wrong)] == messages[len(wrong) :]
    with pytest.raises(ValueError, match="threads"):
        lang.launch(kernels.numbers_kernel, -1, [*number, out])


def test_an_array_with_a_gradient_brings_it(kernels, recorder, where):
    kernel, number = kernels.numbers_kernel, (1, 2, 3, 4, 0.5, 0.1, 5, 6)
    out = wp.zeros(4, dtype=wp.float64, device=where, requires_grad=True)
    for array in (memory.zeros(4, lang.float64, where), out):
        lang.launch(kernel, 4, [*number, array])
    recorder.sizes = sizes_of(kernel.cuda)
    lang.launch(kernel, 4, [*number, out])
    wp.launch(kernel.cuda, 4, [*number, out], device=where)
    assert recorder.launches[-2] == recorder.launches[-1]


def test_a_nested_launch_does_not_change_the_arguments(kernels, recorder, where):
    """As of a signal handler, or of what is released while a launch is filled."""
    kernel, out = kernels.numbers_kernel, memory.zeros(4, lang.float64, where)
    arguments = [[k, 0, 0, 0, 0.0, 0.0, 0, 0, out] for k in (5, 6)]
    recorder.sizes = sizes_of(kernel.cuda)
    lang.launch(kernel, 4, arguments[0])

    def again() -> None:
        recorder.then = lambda: None
        lang.launch(kernel, 4, arguments[1])

    recorder.then = again
    lang.launch(kernel, 4, arguments[0])
    assert [np.frombuffer(given[1], np.int32)[0] for *_, given in recorder.launches[-2:]] == [6, 5]


def test_a_launch_with_another_layout_is_left_to_warp(kernels, where, monkeypatch):
    out, numbers = memory.zeros(4, lang.float64, where), (1, 2, 3, 4, 0.5, 0.25, 5, 6)
    kernel = kernels.numbers_kernel
    monkeypatch.setattr(kernel, "prepared", {})
    monkeypatch.setattr(cuda_launches, "_BOUNDS", "I4xQI4x4x")
    for _ in range(2):
        lang.launch(kernel, 4, [*numbers, out])
    assert kernel.prepared == {where.alias: None}
    assert memory.download(out).tolist() == [21.75] * 4


def test_the_native_library_gets_arguments_of_its_types(kernels, where, monkeypatch):
    """The emulated device takes any number; ctypes, before a real one, takes none of NumPy's for an address."""
    core, called = warp_parts.core(), set()

    def checked(name):
        run = getattr(core, name)
        takes = run.argtypes

        def call(*given):
            called.add(name)
            for kind, argument in zip(takes, given, strict=True):
                kind.from_param(argument)
            return run(*given)

        return call

    for name in warp_parts.FUNCTIONS:
        monkeypatch.setattr(core, name, checked(name))
    n, numbers = np.int64(4), (1, 2, 3, 4, 0.5, 0.25, 5, 6)
    out, table = memory.zeros((n, np.int32(1)), lang.float64, where), memory.upload(np.arange(4), lang.int32, where)
    memory.empty((n, np.int32(1)), lang.float64, wp.get_device("cpu"))
    for _ in range(2):
        lang.launch(kernels.numbers_kernel, n, [*numbers, memory.flat(out)])
        lang.reduce(kernels.add_up, 4, [memory.rows_of(memory.zeros(9, lang.float32, where), n, 2 * n), 1.0])
    part = memory.rows_of(table, np.int64(1), np.int64(3))
    memory.copy(part, table, count=np.int64(1), offset=np.int64(1))
    memory.write(part, np.zeros(2, np.int32))
    many = np.int64(MAX_RANKED_KEYS + 1)  # fewer are sorted and scanned by own kernels
    keys, sums = memory.zeros((many,), lang.int64, where), memory.zeros((many,), lang.int32, where)
    assert memory.download(argsort_keys(keys, 8)[1]).tolist() == list(range(many))
    inclusive_scan(sums, sums)
    readback = memory.Readback(memory.clone(table))
    readback.send()
    assert memory.download(memory.flat(out)).tolist() == [21.75] * 4 and readback.read().tolist() == [0, 0, 0, 3]
    del out, table, part, readback, keys, sums
    assert called == set(warp_parts.FUNCTIONS)
