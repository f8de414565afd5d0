"""Archive of kernels compiled ahead for CUDA, unpacked into Warp's kernel cache on first use.

`make cuda-cache` (kernels/cuda_cache.py) writes the archive. It is found as the package `pointloom_cuda_kernels` or
through POINTLOOM_CUDA_KERNELS. The archive must have the same kernel sources, Warp, and CUDA, and modules are looked up
by Warp's hash. The sources are compared too, since Warp hashes only the low 32 bits of an integer constant.
"""

from __future__ import annotations

import functools
import hashlib
import importlib.util
import json
import lzma
import os
import re
import tempfile
import warnings
import zipfile
from pathlib import Path
from typing import Any, NamedTuple

import warp as wp

from ..array_types import Device
from .cache_folders import is_intact, seal, temporary_cache, write_atomically

VARIABLE = "POINTLOOM_CUDA_KERNELS"  # path of the archive. Empty disables all archives
PACKAGE = "pointloom_cuda_kernels"
ARCHIVE = "kernels.zip"
MANIFEST = "manifest.json"
ARCHIVE_FORMAT = 1
ON_BOARDS = {72, 87, 101, 110}  # GPUs of Jetson: their machine code is incompatible with that of others


class UnpackedFiles(NamedTuple):
    binary: Path
    meta: Path
    architecture: int


@functools.cache
def digest_of_sources() -> str:
    root, digest = Path(__file__).parents[1], hashlib.sha256()
    for path in sorted(root.rglob("*.py")):
        content = path.read_bytes()
        digest.update(f"{path.relative_to(root).as_posix()} {len(content)}\n".encode() + content)
    return digest.hexdigest()


def made_from() -> dict[str, Any]:
    """Versions and sources that machine code depends on, apart from its module."""
    toolkit = wp.get_cuda_toolkit_version() or ()
    return {
        "format": ARCHIVE_FORMAT,
        "Warp": wp.__version__,
        "CUDA": ".".join(map(str, toolkit)),
        "sources of kernels": digest_of_sources(),
    }


_MANIFEST = {"made from": dict, "architectures": list, "modules": dict}


class Archive:
    """Archive of machine code. Raises OSError, ValueError, KeyError, or BadZipFile if it cannot be read."""

    def __init__(self, path: Path) -> None:
        self.path = path
        with zipfile.ZipFile(path) as file:
            manifest = json.loads(file.read(MANIFEST))
        if not isinstance(manifest, dict):
            raise ValueError(f"{MANIFEST}: expected an object, got a {type(manifest).__name__}")
        for name, kind in _MANIFEST.items():
            if not isinstance(manifest[name], kind):
                raise ValueError(f"{MANIFEST}: {name}: expected a {kind.__name__}, got {str(manifest[name])[:80]}")
        self.made_from: dict[str, Any] = manifest["made from"]
        self.architectures: list[str] = manifest["architectures"]
        self.modules: dict[str, dict[str, Any]] = manifest["modules"]

    def mismatch(self) -> str:
        here = made_from()
        others = [name for name in here if self.made_from.get(name) != here[name]]
        named = (
            f"{name} {self.made_from.get(name)} instead of {here[name]}" for name in others if "sources" not in name
        )
        words = ", ".join([*named, *(f"other {name}" for name in others if "sources" in name)])
        return f"made from {words}" if words else ""

    def unpack(self, module: Any, device: Device, block_dim: int) -> UnpackedFiles | None:
        """Unpack the code of a module for a GPU into Warp's cache unless it exists. Raises as above or LZMAError."""
        key = module.get_module_hash(block_dim).hex()
        entry = self.modules.get(key)
        chosen = choose(entry["binaries"], device) if entry else None
        if entry is None or chosen is None:
            return None
        name = module.get_module_identifier(block_dim)
        folder = Path(wp.config.kernel_cache_dir or tempfile.gettempdir()) / name
        files = UnpackedFiles(folder / f"{name}.{chosen}", folder / f"{name}.meta", _architecture(chosen))
        if is_intact(files.binary, files.meta):
            return files
        with zipfile.ZipFile(self.path) as file:
            code = lzma.decompress(file.read(member(key, chosen)))
        if not _is_written(files, code, entry["meta"]):
            folder = Path(temporary_cache())
            files = files._replace(binary=folder / files.binary.name, meta=folder / files.meta.name)
            if not _is_written(files, code, entry["meta"]):
                return None
        return files


def member(key: str, binary: str) -> str:
    return f"{key}/{binary}.xz"


def _architecture(binary: str) -> int:
    return int(re.sub(r"\D", "", binary))


def choose(binaries: list[str], device: Device) -> str | None:
    """Select the code for a GPU among "sm90.cubin", "sm90.ptx" and the like, or None. Machine code runs on later
    architectures of the same major number. PTX on all later ones if the driver is not older than the compiler."""
    own, candidates = device.arch, {kind: [] for kind in ("cubin", "ptx")}
    for binary in binaries:
        architecture = _architecture(binary)
        is_sibling = architecture // 10 == own // 10 and not {architecture, own} & ON_BOARDS
        if architecture == own or (architecture < own and (is_sibling or binary.endswith(".ptx"))):
            candidates[binary.rpartition(".")[2]].append((architecture, binary))
    if candidates["cubin"]:
        return max(candidates["cubin"])[1]
    return max(candidates["ptx"])[1] if candidates["ptx"] and device.get_cuda_output_format() == "ptx" else None


def _is_written(files: UnpackedFiles, code: bytes, meta: dict[str, int]) -> bool:
    """Write both files atomically, the code last."""
    try:
        files.binary.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(files.meta, json.dumps(meta, sort_keys=True).encode())
        write_atomically(files.binary, code)
        seal(files.binary, files.meta)
    except OSError:
        return False
    return True


def archive_path() -> Path | None:
    named = os.environ.get(VARIABLE)
    if named is not None:
        return Path(named) if named else None
    spec = importlib.util.find_spec(PACKAGE)
    return Path(spec.origin).parent / ARCHIVE if spec and spec.origin else None


class _Search:
    done = False
    result: Archive | None = None
    problem = "none is installed"


def archive(*, warns: bool = True) -> Archive | None:
    """The archive that fits the installation. One that does not fit causes one warning."""
    if not _Search.done:
        _Search.done = True
        path = archive_path()
        if path is not None:
            try:
                opened = Archive(path)
                problem = opened.mismatch()
                _Search.result = None if problem else opened
            except Exception as error:  # zipfile raises some ten types on damaged archives
                problem = f"cannot be read: {type(error).__name__}: {error}"
            if problem:
                refuse(path, problem, warns=warns)
    return _Search.result


def refuse(path: Path, problem: str, *, warns: bool = True) -> None:
    _Search.done, _Search.result, _Search.problem = True, None, f"{path}: {problem}"
    if not warns:
        return
    warnings.warn(
        f"kernels compiled ahead are not used: {path}: {problem}. They are compiled here when first needed, which "
        f"takes seconds each; install those that belong to this pointloom, or set {VARIABLE} to nothing",
        RuntimeWarning,
        stacklevel=2,
    )


def described() -> str:
    opened = archive(warns=False)
    return f"{opened.path} for {', '.join(map(str, opened.architectures))}" if opened else f"none: {_Search.problem}"
