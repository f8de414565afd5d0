"""Which compiler serves the CPU, and how Taichi is shared with the program around it; each in its own process."""

import os
import subprocess
import sys
import textwrap

import pytest

pytestmark = pytest.mark.both_compilers
PROGRAM = """
import sys, warnings
warnings.simplefilter("error")
warnings.simplefilter("always", RuntimeWarning)
warnings.simplefilter("ignore", ResourceWarning)  # Warp leaves a folder to be cleaned up at exit
import numpy as np

KERNELS = '''
from pointloom.kernels.lang import *

@kernel
def third_kernel(out: array(dtype=float64)):
    i = tid()
    x = 1.0
    y = x / 3.0
    out[i] = float64(y)
'''

def check():
    import warp as wp
    from pointloom.kernels import lang
    from pointloom.kernels.arrays.bounds import bound_points
    points = wp.array(np.array([[1, 2, 3], [4, -5, 6], [np.nan, 9, 9], [np.inf, 0, 0]]), dtype=wp.vec3, device="cpu")
    low, high, count = bound_points(points)
    with open(__file__[:-3] + "_kernels.py", "w") as file:
        file.write(KERNELS)
    import program_kernels
    out = wp.zeros(2, dtype=wp.float64, device="cpu")
    lang.launch(program_kernels.third_kernel, 2, [out])
    assert out.numpy().tolist() == [float(np.float32(1) / np.float32(3))] * 2, out
    assert (low.tolist(), high.tolist(), count) == ([1, -5, 3], [4, 2, 6], 2), (low, high, count)
    return lang.current_cpu_compiler()

"""


@pytest.fixture
def run(tmp_path):
    def run(program: str, **environment: str) -> subprocess.CompletedProcess:
        path = tmp_path / "program.py"
        path.write_text(PROGRAM + textwrap.dedent(program))
        inherited = {k: v for k, v in os.environ.items() if not k.startswith(("POINTLOOM_CPU", "TI_"))}
        command = [sys.executable, str(path)]
        return subprocess.run(command, env={**inherited, **environment}, capture_output=True, text=True)

    return run


def assert_silent(done: subprocess.CompletedProcess) -> None:
    assert (done.stdout, done.stderr, done.returncode) == ("", "", 0)


@pytest.mark.slow
@pytest.mark.parametrize("compiler", ["", "warp"])
def test_warp_prints_nothing_and_needs_no_taichi(run, compiler):
    assert_silent(run("assert check() == 'warp'\nassert 'taichi' not in sys.modules", POINTLOOM_CPU=compiler))


@pytest.mark.slow
@pytest.mark.taichi
def test_taichi_prints_nothing_and_survives_a_restart_by_the_program(run):
    program = """
        assert check() == "taichi"
        import taichi as ti
        ti.reset()
        assert check() == "taichi"
        ti.init(arch=ti.cpu, log_level=ti.ERROR)  # resets what ran before
        field = ti.field(ti.f32, 4)
        field.fill(3.0)
        assert check() == "taichi"
        assert field.to_numpy().tolist() == [3.0] * 4
    """
    done = run(program, POINTLOOM_CPU="taichi")
    assert (done.stderr, done.returncode) == ("", 0)
    assert all(line.startswith("[Taichi]") for line in done.stdout.splitlines())  # of the program's own ti.init


@pytest.mark.slow
@pytest.mark.taichi
def test_starting_taichi_leaves_numpy_its_subnormal_numbers(run):
    program = """
        tiny = np.array([1e-45, 1e-40], np.float32)
        assert check() == "taichi"
        assert (tiny * np.float32(1) > 0).all()
    """
    assert_silent(run(program, POINTLOOM_CPU="taichi"))


@pytest.mark.slow
@pytest.mark.taichi
def test_a_taichi_started_by_the_program_is_used_unchanged(run):
    """Its fields survive and its settings are restored; kernels use pointloom's: NaN is no number, 2.0 is float32."""
    program = """
        import contextlib, io
        with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            import taichi as ti
            ti.init(arch=ti.cpu, log_level=ti.ERROR, default_fp=ti.f64, default_ip=ti.i64, fast_math=True)
        field = ti.field(float, 4)
        field.fill(0.1)
        runtime = ti.lang.impl.get_runtime()
        before = runtime.prog
        assert check() == "taichi"
        assert runtime.prog is before
        assert field.to_numpy().tolist() == [0.1] * 4
        assert (ti.cfg.fast_math, runtime.default_fp, runtime.default_ip) == (True, ti.f64, ti.i64)

        @ti.kernel
        def third() -> float:
            return 1.0 / 3.0

        assert third() == 1.0 / 3.0
    """
    assert_silent(run(program, POINTLOOM_CPU="taichi", ENABLE_TAICHI_HEADER_PRINT="False", TI_ENABLE_PYBUF="0"))


@pytest.mark.slow
def test_a_broken_taichi_matters_only_if_requested(run, tmp_path):
    package = tmp_path / "broken" / "taichi"
    package.mkdir(parents=True)
    error = "libX11.so.6: cannot open shared object file: No such file or directory"
    (package / "__init__.py").write_text(f"raise ImportError({error!r})")
    program = """
        assert check() == check() == "warp"

        from pointloom.kernels import lang
        with lang.cpu_compiler("taichi"):
            try:
                check()
            except RuntimeError as error:
                assert "libX11.so.6" in str(error) and "apt-get install libx11-6" in str(error), error
            else:
                raise AssertionError("Taichi was asked for by name")
    """
    path = os.pathsep.join([str(package.parent), os.environ.get("PYTHONPATH", "")])
    assert_silent(run(program, PYTHONPATH=path))
    done = run("check()", PYTHONPATH=path, POINTLOOM_CPU="taichi")
    assert done.returncode == 1 and "TaichiUnavailableError: Taichi does not import (libX11.so.6" in done.stderr


def test_a_compiler_of_another_name_is_refused(monkeypatch):
    from pointloom.kernels import lang, launches

    monkeypatch.setattr(launches, "compiler_of_environment", lambda: "cuda")
    with pytest.raises(RuntimeError, match="POINTLOOM_CPU:"):
        lang.current_cpu_compiler()


FORK = """
import multiprocessing, warnings
import numpy as np
import pointloom as loom
from pointloom.core.threads import get_num_threads
from pointloom.kernels.lang import cpu_compiler

def count(seed):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        cloud = loom.PointCloud(np.random.default_rng(seed).random((100_000, 3))).voxel_down_sample(0.5)
    return len(cloud), get_num_threads(), [str(w.message) for w in caught]

def count_by_warp(seed):
    with cpu_compiler("warp"):
        return count(seed)

def in_child(call):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # newer Pythons warn of threads at a fork
        with multiprocessing.get_context("fork").Pool(1) as pool:
            return pool.apply_async(call, (0,)).get(60)

expected = count(0)
assert expected[1:] == (2, []), expected
try:
    in_child(count)
except RuntimeError as error:
    assert "spawn" in str(error), error
else:
    raise AssertionError("Taichi has no threads here")
assert in_child(count_by_warp) == expected
"""


@pytest.mark.slow
@pytest.mark.taichi
def test_a_fork_works_by_warp_on_all_threads_and_not_by_taichi():
    environment = os.environ | {"POINTLOOM_CPU": "taichi", "POINTLOOM_CPU_THREADS": "2"}
    done = subprocess.run([sys.executable, "-c", FORK], capture_output=True, text=True, timeout=120, env=environment)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.slow
def test_an_unwritable_home_still_runs(tmp_path):
    program = "import numpy as np, pointloom as l; print(len(l.PointCloud(np.zeros((9, 3))).voxel_down_sample(1.0)))"
    environment = {k: v for k, v in os.environ.items() if k not in ("XDG_CACHE_HOME", "WARP_CACHE_PATH")}
    environment["HOME"] = "/dev/null"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120, env=environment)
    assert (done.returncode, done.stdout.strip()) == (0, "1"), done.stderr


@pytest.mark.slow
@pytest.mark.parametrize("compiler", ["warp", "taichi"])
@pytest.mark.parametrize("threads", ["many", "0", "100000", "9" * 5000])
def test_a_thread_count_that_is_no_number_or_senseless_is_refused_by_name(threads, compiler):
    program = "import pointloom as l; l.PointCloud([[0.0, 0, 0], [5.0, 0, 0]]).voxel_down_sample(1.0)"
    environment = os.environ | {"POINTLOOM_CPU_THREADS": threads, "POINTLOOM_CPU": compiler}
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120, env=environment)
    assert done.returncode == 1 and "ValueError: POINTLOOM_CPU_THREADS: expected a whole number" in done.stderr
