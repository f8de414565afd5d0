"""CUDA's driver library has another name on Windows."""

import ctypes
import sys

import pytest

from pointloom.kernels.language import driver, warp_compiler


@pytest.mark.parametrize(("system", "names"), [("linux", ["libcuda.so", "libcuda.so.1"]), ("win32", ["nvcuda.dll"])])
def test_the_driver_is_loaded_by_its_name_on_each_system(system, names, monkeypatch):
    requested = []

    def load(name):
        requested.append(name)
        raise OSError(f"no {name}")

    monkeypatch.setattr(sys, "platform", system)
    monkeypatch.setattr(ctypes.cdll, "LoadLibrary", load)
    with pytest.raises(OSError, match=f"no {names[-1]}"):
        driver.driver.__wrapped__()
    assert requested == names
    monkeypatch.setattr(ctypes, "CDLL", load)
    assert not warp_compiler._has_driver() and requested.pop() == names[-1]
    monkeypatch.setattr(ctypes, "CDLL", requested.append)
    assert warp_compiler._has_driver() and requested.pop() == names[-1]
