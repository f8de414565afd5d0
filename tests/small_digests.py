"""Print a digest of every operation on the small scenes, for tests that compare processes.

    python -m tests.small_digests [--cpu-target x86-64-v3] [--device cuda:0]

The first line is a JSON object with the BLAS kernels and the vector instructions of NumPy in use. Every other line is
a digest, or an error, and the operation's name.
"""

from __future__ import annotations

import argparse
import ctypes
import json
import warnings
from pathlib import Path

import numpy as np
import scipy.linalg  # noqa: F401  loads SciPy's own OpenBLAS

from pointloom.kernels import lang  # noqa: F401  starts Warp without its banner
from pointloom.kernels.language import cpu_code, pool_code

from .small_scenes import ON_CLOUDS, ONCE, SmallScenes, digest

NAMES = ("scipy_openblas_get_corename64_", "scipy_openblas_get_corename", "openblas_get_corename")


def blas_kernels() -> list[str]:
    """The name of the kernels of each loaded OpenBLAS."""
    lines = Path("/proc/self/maps").read_text().splitlines()
    names = []
    for path in sorted({line.split()[-1] for line in lines if "openblas" in line}):
        library = ctypes.CDLL(path)
        function = next((getattr(library, name) for name in NAMES if hasattr(library, name)), None)
        if function is not None:
            function.restype = ctypes.c_char_p
            names.append(function().decode())
    return names


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cpu-target", help="of CPU kernels, such as x86-64-v2; this processor by default")
    parser.add_argument("--device", default="cpu", help="device of the scenes")
    options = parser.parse_args()
    if options.cpu_target:
        cpu_code.set_target(options.cpu_target)
    warnings.simplefilter("ignore")
    core = getattr(np, "_core", None) or np.core  # np.core in NumPy 1
    features = [name for name, has in core._multiarray_umath.__cpu_features__.items() if has]
    print(
        json.dumps({"blas": blas_kernels(), "numpy": features, "flags": cpu_code.FLAGS, "pool": pool_code.is_usable()})
    )
    scenes = SmallScenes(options.device)
    scene_names = ("surface", "far", "dirty")
    works = {f"{name} [{p}]": (work, p) for name, work in ON_CLOUDS.items() for p in scene_names}
    for name, (work, scene) in {**works, **{name: (work, "") for name, work in ONCE.items()}}.items():
        try:
            result = digest(work(getattr(scenes, scene) if scene else scenes))
        except Exception as error:  # on clouds that are far too small an error is a result too
            result = f"error-{type(error).__name__}"
        print(result, name, flush=True)


if __name__ == "__main__":
    main()
