"""Messages without a GPU: a driver without CUDA, and the driver version that Warp needs."""

import pytest
import warp as wp

from pointloom.core import cuda_driver
from pointloom.core.cuda_driver import OLDEST_DRIVERS, installed_driver, needed_driver
from pointloom.core.devices import resolve_device
from pointloom.core.errors import DeviceError

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
