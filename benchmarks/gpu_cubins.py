"""Registers, local memory and instructions of kernels, from cubins for sm_90 that NVRTC makes without a GPU."""

from __future__ import annotations

import json
import re
import struct
import sys
import tempfile
from pathlib import Path
from typing import Any

from gpu_machine import Resources

from pointloom.kernels.check_cuda import read_usage

ARCHITECTURE, INSTRUCTION_BYTES = 90, 16


def _code_bytes(cubin: bytes) -> dict[str, int]:
    """Bytes of each kernel's code: sections .text.<kernel> of the ELF file."""
    table, entry_size, count, names_at = struct.unpack_from("<Q", cubin, 40) + struct.unpack_from("<3H", cubin, 58)
    sections = [struct.unpack_from("<IIQQQQII", cubin, table + k * entry_size) for k in range(count)]
    found = {}
    for section in sections:
        start = sections[names_at][4] + section[0]
        name = cubin[start : cubin.index(b"\0", start)].decode()
        if name.startswith(".text."):
            found[name.removeprefix(".text.")] = section[5]
    return found


def _compile(source: Path) -> bytes:
    """The cubin of the CUDA source that Warp leaves beside a module's PTX, with the option that all of ours have."""
    import warp._src.build as build

    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "module.cubin"
        build.build_cuda(
            str(source), ARCHITECTURE, str(out), pch_dir=None, use_precompiled_headers=False, fuse_fp=False
        )
        return out.read_bytes()


def read_resources(ptx_path: str, statements: dict[str, int], cache: Path) -> dict[str, Resources]:
    """Of each kernel of a module; kept in `cache` by the module's file, whose name holds its content's hash."""
    path = Path(ptx_path)
    kept = cache / f"{path.name}.resources.json"
    found: dict[str, Any] = {}
    if kept.exists():
        found = json.loads(kept.read_text())
    else:
        print(f"compiling {path.name} to a cubin", file=sys.stderr)
        cubin = _compile(Path(re.sub(r"\.sm\d+\w*\.ptx$", ".cu", ptx_path)))
        code = _code_bytes(cubin)
        for name, usage in read_usage(cubin).items():
            found[name] = [usage.registers, usage.local_bytes, code.get(name, 0) // INSTRUCTION_BYTES]
        kept.write_text(json.dumps(found))
    return {name: Resources(*values[:3], statements=statements.get(name, 0)) for name, values in found.items()}
