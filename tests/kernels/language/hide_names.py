"""Run small operations with a name of Warp hidden from pointloom: a Warp that calls it otherwise.

    python hide_names.py OWNER NAME DEVICE

It prints a digest of the results.
"""

from __future__ import annotations

import builtins
import hashlib
import sys
import types
from pathlib import Path
from typing import Any


def is_ours() -> bool:
    return sys._getframe(2).f_globals.get("__name__", "").startswith("pointloom")


def hide_from_module(module: Any, name: str) -> None:
    class Hiding(type(module)):
        def __getattribute__(self, asked: str) -> Any:
            if asked == name and is_ours():
                raise AttributeError(f"module has no attribute {asked!r}")
            return super().__getattribute__(asked)

    module.__class__ = Hiding


def hide_from_class(owner: Any, name: str) -> None:
    inherited = owner.__getattribute__

    def get(self: Any, asked: str) -> Any:
        if asked == name and is_ours():
            raise AttributeError(f"{owner.__name__!r} object has no attribute {asked!r}")
        return inherited(self, asked)

    owner.__getattribute__ = get


def hide_module(name: str) -> None:
    through = builtins.__import__

    def imported(asked: str, globals: Any = None, *arguments: Any, **more: Any) -> Any:
        if asked == name and (globals or {}).get("__name__", "").startswith("pointloom"):
            raise ImportError(f"no module named {asked!r}")
        return through(asked, globals, *arguments, **more)

    builtins.__import__ = imported


def replace_header(kind: str) -> None:
    """Let the header of CUDA kernels not compile, or compile to other addresses, with an untested Warp."""
    from pointloom.kernels.language import warp_parts

    warp_parts.TESTED = ("0.0",)
    from pointloom.kernels.language import cuda_code

    text = cuda_code.header()
    faulty = text + "#error" if kind == "refused" else text.replace("return a.data + i;", "return a.data + (i ^ 1);")
    assert faulty != text
    cuda_code.header = lambda: faulty


def digest(device: str) -> str:
    import numpy as np

    import pointloom as loom

    points = np.random.default_rng(0).random((300, 3))
    cloud = loom.PointCloud(points, normals=np.ones((300, 3)), device=device)
    moved = cloud.translate([1, 2, 3]).rotate(np.eye(3))
    parts = (moved.points, moved.normals, moved.get_max_bound())
    return hashlib.sha256(b"".join(part.tobytes() for part in parts)).hexdigest()


def main(owner: str, name: str, device: str) -> None:
    if device != "cpu":
        sys.path.insert(0, str(Path(__file__).resolve().parents[3]))
        from tests.emulated_cuda.install import install

        install()
    import warp as wp

    if owner == "import":
        hide_module(name)
    elif owner == "cuda_access.h":
        replace_header(name)
    elif owner:
        found: Any = wp
        if "runtime" in owner:
            wp.init()
        for part in owner.split(".")[1:]:
            found = getattr(found, part)
        if isinstance(found, types.ModuleType):
            hide_from_module(found, name)
        else:
            hide_from_class(found if isinstance(found, type) else type(found), name)
    print(digest(device))


if __name__ == "__main__":
    main(*sys.argv[1:])
