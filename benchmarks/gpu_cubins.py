"""Registers, local memory and instructions of kernels, from cubins that NVRTC makes without a GPU."""

from __future__ import annotations

import json
import re
import sys
import tempfile
from pathlib import Path
from typing import Any

from gpu_machine import INSTRUCTION_BYTES, Resources
from gpu_sass import read_code, sections

from pointloom.kernels.check_cuda import read_usage

ARCHITECTURE = 90
LARGE = 128 << 10  # bytes of code: of smaller kernels that spill nothing loops need not be known


def _compile(source: Path, architecture: int) -> bytes:
    """The cubin of the CUDA source that Warp leaves beside a module's PTX, with the option that all of ours have."""
    import warp._src.build as build

    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "module.cubin"
        build.build_cuda(
            str(source), architecture, str(out), pch_dir=None, use_precompiled_headers=False, fuse_fp=False
        )
        return out.read_bytes()


def read_resources(
    ptx_path: str, statements: dict[str, int], cache: Path, architecture: int = ARCHITECTURE
) -> dict[str, Resources]:
    """Of each kernel of a module; kept in `cache` by the module's file, whose name holds its content's hash."""
    path = Path(ptx_path)
    kept = cache / f"{path.name}.{architecture}.loops.json"
    found: dict[str, Any] = {}
    if kept.exists():
        found = json.loads(kept.read_text())
    else:
        print(f"compiling {path.name} to a cubin for sm_{architecture}", file=sys.stderr)
        cubin = _compile(Path(re.sub(r"\.sm\d+\w*\.ptx$", ".cu", ptx_path)), architecture)
        texts = sections(cubin)
        for name, usage in read_usage(cubin).items():
            code = read_code(texts.get(name, b""), architecture)
            size = sum(code.code)
            found[name] = {"registers": usage.registers, "local_bytes": usage.local_bytes, "instructions": size}
            if sum(code.local_loads + code.local_stores) or size * INSTRUCTION_BYTES > LARGE:
                found[name] |= vars(code)
        kept.write_text(json.dumps(found))
    return {name: Resources(**values, statements=statements.get(name, 0)) for name, values in found.items()}
