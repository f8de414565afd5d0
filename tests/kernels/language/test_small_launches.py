"""Small CPU launches are Warp's and large ones Taichi's, by size alone; a first small operation loads little."""

import subprocess
import sys
import threading

import numpy as np
import pytest
import warp as wp

from pointloom.kernels import lang, launches

pytestmark = pytest.mark.both_compilers

SOURCE = """
@kernel
def scale_kernel(a: array(dtype=float), factor: float, out: array(dtype=float)):
    i = tid()
    out[i] = a[i] * factor


@reduction
def add_up(a: array(dtype=float)) -> vec2d:
    i = tid()
    return vec2d(float64(a[i]), float64(1.0))


@kernel
def step_kernel(left: array(dtype=int), big: array(dtype=float)):
    i = tid()
    if i == 0:
        left[0] = left[0] - 1
    big[i] = big[i] + 1.0
"""


@pytest.fixture(scope="module")
def kernels(write_kernels):
    return write_kernels("small_launches", SOURCE)


@pytest.fixture
def ran(monkeypatch):
    """The compilers that launches went through, in their order."""
    monkeypatch.delenv("POINTLOOM_CPU", raising=False)
    seen = []
    for name in ("warp", "taichi"):
        run = getattr(launches, f"_run_{name}")
        monkeypatch.setattr(
            launches, f"_run_{name}", lambda *a, run=run, name=name, **k: seen.append(name) or run(*a, **k)
        )
    return seen


def scaled(kernels, threads: int, elements: int) -> np.ndarray:
    a = wp.array(np.arange(elements, dtype=np.float32), dtype=float, device="cpu")
    out = wp.zeros(elements, dtype=float, device="cpu")
    lang.launch(kernels.scale_kernel, threads, [a, 3.0, out])
    return out.numpy()


@pytest.mark.parametrize(
    ("threads", "elements", "compiler"),
    [
        (launches.SMALL_THREADS, launches.SMALL_THREADS, "warp"),
        (launches.SMALL_THREADS + 1, launches.SMALL_THREADS + 1, "taichi"),
        (100, launches.SMALL_ELEMENTS // 2, "warp"),
        (100, launches.SMALL_ELEMENTS // 2 + 1, "taichi"),
    ],
)
def test_the_sizes_of_a_launch_choose_its_compiler(kernels, ran, threads, elements, compiler):
    expected = np.where(np.arange(elements) < threads, 3.0 * np.arange(elements), 0.0)
    np.testing.assert_array_equal(scaled(kernels, threads, elements), expected)
    assert ran == [compiler]


@pytest.mark.parametrize("name", ["taichi", "warp"])
def test_who_asks_for_a_compiler_has_it_for_all_sizes(kernels, ran, name):
    with lang.cpu_compiler(name):
        for count in (10, 10_000):
            scaled(kernels, count, count)
    assert ran == [name, name]


@pytest.mark.parametrize("count", [1, 1024, 2048, 2049, 50_000])
def test_a_sum_has_the_same_bits_wherever_it_is_taken(kernels, rng, monkeypatch, count):
    monkeypatch.delenv("POINTLOOM_CPU", raising=False)
    a = wp.array(rng.normal(size=count).astype(np.float32), dtype=float, device="cpu")
    found = {lang.reduce(kernels.add_up, count, [a]).numpy().tobytes()}
    for name in ("taichi", "warp"):
        with lang.cpu_compiler(name):
            found.add(lang.reduce(kernels.add_up, count, [a]).numpy().tobytes())
    assert len(found) == 1


def test_a_loop_of_small_and_large_launches_repeats_both(kernels, ran):
    left = wp.array([5], dtype=int, device="cpu")
    small, large = (wp.zeros(count, dtype=float, device="cpu") for count in (10, 5000))
    idle = wp.array([0], dtype=int, device="cpu")
    calls = []

    def body():
        calls.append(None)
        lang.launch(kernels.step_kernel, 5000, [idle, large])
        lang.launch(kernels.step_kernel, 0, [idle, large])
        lang.launch(kernels.step_kernel, 10, [left, small])

    lang.loop_while(left, body)
    assert (small.numpy() == 5).all() and (large.numpy() == 5).all()
    assert len(calls) == 1 and ran == ["taichi", "warp"]


FIRST = """
import sys
import numpy as np, pointloom as loom
cloud = loom.PointCloud(np.random.default_rng(0).random((400, 3)))
cloud.voxel_down_sample(0.2).estimate_normals(max_nn=10).cluster_dbscan(0.3, 3)
print([name for name in ("taichi", "scipy.spatial", "scipy.sparse", "PIL", "rich") if name in sys.modules])
"""


@pytest.mark.slow
def test_a_first_small_operation_loads_neither_taichi_nor_scipy(monkeypatch):
    monkeypatch.delenv("POINTLOOM_CPU", raising=False)
    done = subprocess.run([sys.executable, "-c", FIRST], capture_output=True, text=True, timeout=300, check=False)
    assert (done.returncode, done.stdout.strip()) == (0, "[]"), done.stderr


@pytest.mark.slow
def test_threads_that_launch_a_kernel_first_at_once_check_it_once(write_kernels, monkeypatch):
    monkeypatch.delenv("POINTLOOM_CPU", raising=False)
    kernel = write_kernels("first_at_once", SOURCE).scale_kernel
    made = []
    make = kernel.make_warp
    kernel.make_warp = lambda: made.append(None) or make()
    vars(kernel).pop("warp", None)
    arrays = [(wp.zeros(8, dtype=float, device="cpu"), wp.zeros(8, dtype=float, device="cpu")) for _ in range(8)]
    threads = [threading.Thread(target=lang.launch, args=(kernel, 8, [a, 2.0, out])) for a, out in arrays]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(made) == 1
