"""Programs without standard streams, packages without sources, and machines without a GPU or with an old driver."""

import compileall
import importlib.metadata
import os
import shutil
import subprocess
import sys
import threading
from pathlib import Path
from types import SimpleNamespace

import pytest
import warp as wp

import pointloom
from pointloom.core import cuda_driver
from pointloom.core.cuda_driver import OLDEST_DRIVERS, installed_driver, needed_driver
from pointloom.core.devices import resolve_device
from pointloom.core.errors import DeviceError
from pointloom.core.standard_streams import is_terminal, write_to_stderr
from pointloom.kernels.language.warp_compiler import lines_removed_from_stderr

PROGRAM = """
import io, os, sys, traceback
class Console:
    def write(self, text): return len(text)
closed = io.StringIO()
closed.close()
{begin}
try:
    import pointloom as loom
    cloud = loom.PointCloud([[0.0, 0.0, 0.0]])
    cloud.cluster_dbscan(1.0, 1, print_progress=True)
    said = str(len(cloud.voxel_down_sample(1.0)))
except BaseException:
    said = traceback.format_exc()
open({path!r}, "w").write(said)
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    "begin",
    [
        "sys.stdin = sys.stdout = sys.stderr = None",
        "sys.stdout = sys.stderr = Console()",
        "sys.stdout = sys.stderr = closed",
        "os.closerange(0, 3)",
        "os.close(2)",
    ],
)
def test_programs_without_standard_streams_import_and_run(tmp_path, begin):
    path = tmp_path / "said"
    subprocess.run([sys.executable, "-c", PROGRAM.format(begin=begin, path=str(path))], capture_output=True)
    assert path.read_text() == "1"


def test_a_stream_with_write_alone_gets_the_line_and_is_no_terminal(monkeypatch):
    written: list[str] = []
    stream = SimpleNamespace(write=written.append)
    monkeypatch.setattr(sys, "stderr", stream)
    write_to_stderr("a line")
    assert "".join(written) == "a line\n" and not is_terminal(stream) and not is_terminal(None)


def test_output_of_other_libraries_is_written_to_stderr(capfd):
    with lines_removed_from_stderr("no driver"):
        os.write(2, b"no driver here\n")
        other = threading.Thread(target=os.write, args=(2, b"a line of another thread\n"))
        other.start()
        other.join()
    assert capfd.readouterr().err == "a line of another thread\n"


@pytest.mark.slow
@pytest.mark.parametrize(("removed", "name"), [(".py", ".py files"), (".pyi", "__init__.pyi")])
def test_a_package_without_sources_or_stubs_is_an_import_error(tmp_path, removed, name):
    package = tmp_path / "pointloom"
    shutil.copytree(Path(pointloom.__file__).parent, package, ignore=shutil.ignore_patterns("__pycache__"))
    compileall.compile_dir(package, quiet=2, legacy=True)
    for path in package.rglob(f"*{removed}"):
        path.unlink()
    program = f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import pointloom; pointloom.PointCloud"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    last = run.stderr.splitlines()[-1]
    assert last.startswith("ImportError") and name in last


APPLICATION = """
import numpy as np
import pointloom as loom
cloud = loom.PointCloud(np.random.default_rng(0).random((1000, 3)))
T = np.eye(4)
T[0, 3] = 0.01
moved = loom.registration.registration_icp(cloud, cloud.transform(T), 0.1).transformation
print(len(cloud.voxel_down_sample(0.5)), np.abs(moved - T).max() < 1e-5)
"""
# Optional for pointloom or its dependencies: they make the folder larger and the test slower.
NOT_PACKED = ("torch", "jax", "open3d", "numba", "IPython", "dash", "plotly", "ipywidgets", "sympy", "pytest")


@pytest.mark.nightly
def test_an_application_packed_by_pyinstaller_runs_with_an_empty_home(tmp_path):
    pytest.importorskip("PyInstaller")
    if not any(e.value.startswith("pointloom.") for e in importlib.metadata.entry_points(group="pyinstaller40")):
        pytest.skip("pointloom is not installed, so PyInstaller does not find its hook")
    (tmp_path / "application.py").write_text(APPLICATION)
    command = [sys.executable, "-m", "PyInstaller", "--log-level", "ERROR", "application.py"]
    command += [f"--exclude-module={name}" for name in NOT_PACKED]
    subprocess.run(command, cwd=tmp_path, check=True, timeout=1500)
    home = tmp_path / "home"
    home.mkdir()
    program = tmp_path / "dist" / "application" / "application"
    surroundings = {"HOME": str(home), "PATH": os.defpath, "POINTLOOM_VERBOSITY": "warning"}
    run = subprocess.run([program], env=surroundings, cwd=home, capture_output=True, text=True, timeout=600)
    assert (run.returncode, run.stdout.split(), run.stderr) == (0, ["27", "True"], "")


PROPRIETARY = """NVRM version: NVIDIA UNIX x86_64 Kernel Module  535.183.01  Sun May 12 19:39:15 UTC 2024
GCC version:  gcc version 12.2.0 (Debian 12.2.0-14)
"""
OPEN = """NVRM version: NVIDIA UNIX Open Kernel Module for x86_64  580.65.06  Release Build  (a@b)
GCC version:
"""


@pytest.fixture
def driver(tmp_path, monkeypatch):
    """A function that loads a driver, by the text that the kernel shows; without a call there is none."""
    path = tmp_path / "version"
    monkeypatch.setattr(cuda_driver, "PROC", path)
    monkeypatch.setattr(wp, "get_cuda_device_count", lambda: 0)
    monkeypatch.setattr(wp, "get_cuda_toolkit_version", lambda: (13, 4))
    monkeypatch.delenv("CUDA_VISIBLE_DEVICES", raising=False)
    return path.write_text


@pytest.mark.parametrize(("text", "version"), [(PROPRIETARY, "535.183.01"), (OPEN, "580.65.06"), ("nothing", None)])
def test_the_driver_s_version_is_read_from_the_kernel(driver, text, version):
    assert installed_driver() is None
    driver(text)
    assert installed_driver() == version


@pytest.mark.parametrize(("toolkit", "needed"), [((13, 4), 580), ((12, 0), 525), ((99, 0), None), (None, None)])
def test_the_driver_needed_is_that_of_warp_s_cuda(driver, monkeypatch, toolkit, needed):
    monkeypatch.setattr(wp, "get_cuda_toolkit_version", lambda: toolkit)
    assert needed_driver() == needed


def test_the_warp_that_is_installed_is_of_a_known_generation():
    toolkit = wp.get_cuda_toolkit_version()
    assert toolkit is None or toolkit[0] in OLDEST_DRIVERS


@pytest.mark.parametrize("name", ["cuda", "cuda:99"])
def test_a_missing_gpu_is_reported_with_the_reason(driver, name):
    why = rf"no NVIDIA driver is loaded; Warp {wp.__version__} \(CUDA 13\) needs 580 or newer; run pointloom doctor"
    with pytest.raises(DeviceError, match=f"got '{name}'; no CUDA GPU was found: {why}"):
        resolve_device(name)
    driver(PROPRIETARY)
    with pytest.raises(DeviceError, match=r"^device:.*535\.183\.01.*580"):
        resolve_device(name)
