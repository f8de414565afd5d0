"""Shared fixtures: devices, real scans, tolerances, conversion of clouds to Open3D.

A test that takes `device` runs once for each compiler of CPU kernels (in `make test` on one: choice.py), and on the
first GPU if there is one. Without a GPU these runs are skipped, and one line of the summary reports it;
--emulated-cuda uses an emulated one. Runs on Taichi are skipped in the same way if it is not installed.
"""

from __future__ import annotations

import gc
import importlib.util
import logging
import os
import sys
import textwrap
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from . import choice, oracle, rest_set, stray_files
from .cpu_seconds import CpuSeconds
from .emulated_cuda import plugin as emulated_cuda
from .programs import BENCHMARKS, load_program

# Processes started by tests would otherwise report the first use of a kernel on stderr; here it is as for users.
os.environ.setdefault("POINTLOOM_VERBOSITY", "warning")
logging.getLogger("pointloom").setLevel(logging.INFO)

device_requested = False


def pytest_addoption(parser: pytest.Parser, pluginmanager: pytest.PytestPluginManager) -> None:
    emulated_cuda.add_options(parser)
    for plugin in (choice, oracle, rest_set, stray_files, CpuSeconds()):
        pluginmanager.register(plugin)
    emulated_cuda.install_if_requested(pluginmanager.get_plugin("pytestconfig"))  # before the next conftest starts Warp


@cache
def has_cuda() -> bool:
    import warp as wp

    from pointloom.kernels import lang  # noqa: F401  starts Warp without its banner

    return wp.get_cuda_device_count() > 0


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    global device_requested
    if "device" in metafunc.fixturenames:
        device_requested = True
        devices = [*choice.cpu_devices_of(metafunc.definition), *(["cuda:0"] if has_cuda() else [])]
        metafunc.parametrize("device", devices, indirect=True)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Iterator[Any]:
    """What is collected stays till the end: no search for rubbish walks over it, which is most of what there is."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


def pytest_sessionfinish(session: pytest.Session) -> None:
    if hasattr(session.config, "workeroutput"):  # of a process beside others (pytest -n): the first one sums up
        session.config.workeroutput["device_requested"] = device_requested


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    global device_requested
    device_requested |= getattr(node, "workeroutput", {}).get("device_requested", False)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    if device_requested and not has_cuda():
        terminalreporter.write_line("SKIPPED CUDA: no device here, its tests did not run")
    if not (choice.HAS_TAICHI and oracle.HAS_OPEN3D) and not terminalreporter.config.getoption(choice.OPTION):
        terminalreporter.write_line("SKIPPED Taichi or Open3D: not installed, tests that need them did not run")
    if importlib.util.find_spec("torch") is None and not terminalreporter.config.getoption(choice.OPTION):
        terminalreporter.write_line(
            "SKIPPED torch: not installed, tests/torch did not run. `make test-torch` runs them"
        )


@pytest.fixture
def device(request: pytest.FixtureRequest) -> Iterator[str]:
    """A device's name, "cpu" or "cuda:0", with the compiler of CPU kernels given in the test's name."""
    from pointloom.kernels.lang import cpu_compiler

    compiler = choice.COMPILERS.get(request.param)
    if compiler is None:
        yield request.param
        return
    with cpu_compiler(compiler):
        yield "cpu"


@pytest.fixture(scope="session")
def write_kernels(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[[str, str], ModuleType]]:
    """A function (name, source) -> module, for kernels defined by a test; their source must be in a file."""
    folder, names = tmp_path_factory.mktemp("kernels"), []

    def write(name: str, source: str) -> ModuleType:
        path = folder / f"{name}.py"
        path.write_text("import math\nfrom pointloom.kernels.lang import *\n" + textwrap.dedent(source))
        names.append(name)
        return load_program(path)  # Warp looks its modules up in `sys.modules`

    yield write
    for name in names:
        sys.modules.pop(name, None)


@pytest.fixture
def rng() -> np.random.Generator:
    """Random numbers, the same in every run."""
    return np.random.default_rng(0)


@pytest.hookimpl(tryfirst=True)  # before -m selects
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark the tests that read real data: those with the fixture `real_file`, but not on the `shipped` scans."""
    for item in items:
        params = item.callspec.params if hasattr(item, "callspec") else {}
        if "real_file" in item.fixturenames and params.get("scan_set") != "shipped":
            item.add_marker(pytest.mark.real_data)
        elif item.get_closest_marker("real_data"):
            raise pytest.UsageError(f"{item.nodeid} is marked real_data, but does not use the fixture real_file")


is_of_real_data = False  # the test that runs now


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    global is_of_real_data
    is_of_real_data = item.get_closest_marker("real_data") is not None


@pytest.fixture(scope="session")
def real_file() -> Callable[[str], Path]:
    """A function: the path of a file or folder of the real data. The test is skipped if it does not exist."""
    folder = os.environ.get("POINTLOOM_DATA", "")
    if folder and not Path(folder).is_dir():
        pytest.fail(f"POINTLOOM_DATA: expected a folder, got {folder}")

    def find(name: str) -> Path:
        assert is_of_real_data, f"{name}: the test is not marked real_data; name the fixture in its signature"
        path = Path(folder, name)
        if not folder or not path.exists():
            pytest.skip(f"{name} does not exist in POINTLOOM_DATA ({folder or 'not set'})")
        return path

    return find


@pytest.fixture(scope="session")
def shipped_file() -> Callable[[str], Path]:
    """A function: the path of a file or folder of tests/data, which must exist."""
    return lambda name: (Path(__file__).parent / "data" / name).resolve(strict=True)


@pytest.fixture(scope="session", params=["shipped", "real"])
def scan_set(request: pytest.FixtureRequest) -> str:
    """The scans of a test that runs on both: shipped or made-up ones, and real ones."""
    return request.param


@pytest.fixture(scope="session")
def scan_file(scan_set, real_file, shipped_file) -> Callable[[str], Path]:
    """`shipped_file` or `real_file`: tests/data contains cuts of scans by the paths of the complete ones."""
    return {"shipped": shipped_file, "real": real_file}[scan_set]


@pytest.fixture(scope="session")
def tolerances():
    """The values of tests/tolerances.py by name."""
    from . import tolerances

    return tolerances


@pytest.fixture(scope="session")
def to_open3d(o3d):
    """A function that makes a legacy Open3D cloud of arrays."""

    def convert(points, normals=None, colors=None):
        cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.array(points, np.float64)))
        if normals is not None:
            cloud.normals = o3d.utility.Vector3dVector(np.array(normals, np.float64))
        if colors is not None:
            cloud.colors = o3d.utility.Vector3dVector(np.array(colors, np.float64))
        return cloud

    return convert


@pytest.fixture(scope="session")
def fragment(scan_file):
    """The arrays of the indoor fragment (real), or of a corner of it (shipped), in float64."""
    import pointloom as loom

    cloud = loom.read_point_cloud(scan_file("cloud-cupoch/fragment.pcd"))
    points, normals, colors = (np.asarray(a, np.float64) for a in (cloud.points, cloud.normals, cloud.colors))
    assert points.shape == normals.shape == colors.shape and len(points) in (8000, 113662)
    return SimpleNamespace(points=points, normals=normals, colors=colors)


@pytest.fixture(scope="session")
def legacy_fragment(o3d, scan_file):
    """The fragment as Open3D reads it."""
    return o3d.io.read_point_cloud(str(scan_file("cloud-cupoch/fragment.pcd")))


@pytest.fixture(scope="session")
def made_street():
    """The module benchmarks/street.py: drives of a scanner through a made-up street."""
    return load_program(BENCHMARKS / "street.py", "odometry_street")


@pytest.fixture(scope="session")
def lidar(scan_set, real_file, made_street):
    """One scan of a rotating LiDAR, (n, 4): x, y, z [m] and intensity; its density varies a thousandfold.

    KITTI's (real), 17,238 points, whose license does not allow to ship it, or one of a made-up street (shipped).
    """
    if scan_set == "real":
        return np.fromfile(real_file("lidar-kitti-frame/kitti/000008.bin"), np.float32).reshape(-1, 4)
    points = made_street.drive(1, speed=0.0, beams=40, azimuths=480, noise=0.02).scans[0]
    return np.column_stack([points, np.linspace(0, 1, len(points))]).astype(np.float32)


@pytest.fixture(scope="session")
def terrain(shipped_file):
    """An airborne tile at UTM coordinates, [n, 3] float64; its file stores y in steps of 0.5 m."""
    import pointloom as loom

    return loom.read_point_cloud(shipped_file("lidar-pcl-terrain/samp21-utm.pcd")).points
