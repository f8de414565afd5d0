"""Compile every kernel for GPUs ahead, without one: python -m pointloom.kernels.cuda_cache [--architectures 75 90 ...].

Avoids NVRTC compilation (seconds per module) at the first use of an operation. Writes an archive and an installable
wheel atomically. POINTLOOM_CUDA_KERNELS names an archive that is not installed; language/compiled_ahead.py loads it.
Compiled modules stay in the work folder, so an interrupted run resumes.
"""

from __future__ import annotations

import argparse
import base64
import hashlib
import importlib
import importlib.metadata
import io
import json
import lzma
import multiprocessing
import pkgutil
import shutil
import signal
import sys
import time
import zipfile
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from . import lang  # before Warp: it silences the banner
from .language import casts
from .language.compiled_ahead import ARCHIVE, MANIFEST, PACKAGE, made_from, member, write_atomically
from .language.cpu_pool import usable_cores
from .language.warp_compiler import modules_for_cuda

import warp as wp  # isort: skip

# Turing, Ampere (server, desktop), Ada, Hopper, Blackwell (server, desktop)
ALL_ARCHITECTURES = (75, 80, 86, 89, 90, 100, 120)
CASTS = casts.__name__
Result = TypeVar("Result")
INTERRUPTED_STATUS = 130  # exit status of shells after Ctrl-C


class Code(NamedTuple):
    size: int
    packed: bytes
    seconds: float  # CPU time. 0 if it was cached


class Built(NamedTuple):
    name: str
    key: str  # Warp's module hash
    kernels: int
    meta: dict[str, int]
    code: dict[str, Code]  # by the architecture keys of compiled_ahead.choose


def find_files() -> list[str]:
    """The modules of kernels/, largest sources first to balance the process pool."""
    package = importlib.import_module(__package__ or "pointloom.kernels")
    sizes = {}
    for module in pkgutil.walk_packages(package.__path__, package.__name__ + "."):
        path = Path(module.module_finder.path, module.name.rpartition(".")[2] + ".py")  # type: ignore[union-attr]
        if not module.ispkg:
            sizes[module.name] = path.stat().st_size
    return sorted(sizes, key=lambda name: -sizes[name])


def _modules_of(file: str) -> list[wp.Module]:
    importlib.import_module(file)
    lang.resolve_module(file)
    return modules_for_cuda(file) + ([k.module for k in casts.kernels_ahead()] if file == CASTS else [])


def _drop_outdated(module: wp.Module, folder: Path) -> None:
    """Remove outdated compilations: Warp's hash in the folder name covers only the low 32 bits of integer constants."""
    source = folder / f"{folder.name}.cu"
    if source.exists():
        options = module.resolve_options(wp.config) | {"output_arch": max(ALL_ARCHITECTURES)}
        module.get_module_hash()
        if module._run_codegen(options, False)[0] != source.read_text(encoding="utf-8"):
            shutil.rmtree(folder)


def _compile(module: wp.Module, work: Path, targets: list[tuple[int, bool]]) -> Built:
    key, name = module.get_module_hash().hex(), module.get_module_identifier()
    folder = work / name
    _drop_outdated(module, folder)
    code = {}
    for architecture, is_ptx in targets:
        start = time.process_time()
        (path,) = wp.compile_aot_module(module, arch=architecture, use_ptx=is_ptx)
        seconds, binary = time.process_time() - start, Path(path).read_bytes()
        code[Path(path).name.removeprefix(f"{name}.")] = Code(len(binary), lzma.compress(binary), seconds)
    meta = json.loads((folder / f"{name}.meta").read_text(encoding="utf-8"))
    return Built(module.name, key, len(module.kernels), meta, code)


def compile_file(file: str, work: Path, targets: list[tuple[int, bool]]) -> list[Built]:
    """Compile one file into the work folder. `targets` are (architecture, PTX) pairs."""
    wp.config.kernel_cache_dir = str(work)
    return [_compile(module, work, targets) for module in _modules_of(file)]


def _leave_ctrl_c_to_the_parent() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def in_processes(call: Callable[..., Result], files: Iterable[str], *arguments: Any) -> Iterator[tuple[str, Result]]:
    """Each file and `call(file, *arguments)`, in one process per core, in order of completion.
    Raises RuntimeError for a file that fails."""
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(usable_cores(), spawn, initializer=_leave_ctrl_c_to_the_parent) as pool:
        futures = {pool.submit(call, file, *arguments): file for file in files}
        try:
            for done in as_completed(futures):
                try:
                    yield futures[done], done.result()
                except Exception as error:  # a language rule, NVRTC, LLVM, a full disk
                    raise RuntimeError(f"{futures[done]}: {type(error).__name__}: {error}") from error
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            for child in multiprocessing.active_children():  # their results are used only when complete
                child.terminate()
            raise


def archive_of(built: list[Built]) -> bytes:
    """The archive as bytes, deterministic for the same code."""
    targets = sorted({target for each in built for target in each.code}, key=lambda t: (len(t), t))
    modules = {
        each.key: {"name": each.name, "meta": each.meta, "binaries": sorted(each.code)}
        for each in sorted(built, key=lambda each: each.name)
    }
    manifest = {"made from": made_from(), "architectures": targets, "modules": modules}
    members = {MANIFEST: json.dumps(manifest, indent=1).encode()}
    for each in sorted(built, key=lambda each: each.name):
        members |= {member(each.key, target): each.code[target].packed for target in sorted(each.code)}
    return _zipped(members)


def _zipped(members: dict[str, bytes]) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_STORED) as archive:
        for name, content in members.items():
            entry = zipfile.ZipInfo(name)
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content)
    return file.getvalue()


def wheel_of(archive: bytes, version: str) -> tuple[str, bytes]:
    """Name and bytes of a wheel with the archive, for this pointloom version and this Warp."""
    info = f"{PACKAGE}-{version}.dist-info"
    summary = "pointloom's kernels, compiled ahead for NVIDIA's GPUs"
    needs = f"Requires-Dist: pointloom=={version}\nRequires-Dist: warp-lang=={wp.__version__}\n"
    head = f"Metadata-Version: 2.1\nName: {PACKAGE.replace('_', '-')}\nVersion: {version}\nSummary: {summary}\n"
    members = {
        f"{PACKAGE}/__init__.py": f'"""{summary}."""\n'.encode(),
        f"{PACKAGE}/{ARCHIVE}": archive,
        f"{info}/METADATA": f"{head}License-Expression: Apache-2.0\n{needs}".encode(),
        f"{info}/WHEEL": b"Wheel-Version: 1.0\nGenerator: pointloom\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    }
    lines = []
    for name, content in members.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        lines.append(f"{name},sha256={digest},{len(content)}")
    members[f"{info}/RECORD"] = "\n".join([*lines, f"{info}/RECORD,,", ""]).encode()
    return f"{PACKAGE}-{version}-py3-none-any.whl", _zipped(members)


def table_of(built: list[Built]) -> list[str]:
    lines = [f"{'':12}{'kernels':>8}{'modules':>8}{'MB':>8}{'packed MB':>11}{'CPU s':>8}"]
    targets = {target for each in built for target in each.code}
    for target in sorted(targets, key=lambda t: (len(t), t)):
        having = [each for each in built if target in each.code]
        codes = [each.code[target] for each in having]
        size, packed = sum(c.size for c in codes) / 1e6, sum(len(c.packed) for c in codes) / 1e6
        kernels, seconds = sum(each.kernels for each in having), sum(c.seconds for c in codes)
        lines.append(f"{target:12}{kernels:8}{len(having):8}{size:8.1f}{packed:11.1f}{seconds:8.0f}")
    return lines


def build(files: list[str], targets: list[tuple[int, bool]], work: Path, output: Path) -> list[Path]:
    """Compile, write archive and wheel, and print one line per file. Raises RuntimeError or OSError."""
    work.mkdir(parents=True, exist_ok=True)
    output.mkdir(parents=True, exist_ok=True)
    start, built = time.perf_counter(), []
    for count, (file, results) in enumerate(in_processes(compile_file, files, work.resolve(), targets), 1):
        built += results
        seconds = sum(code.seconds for each in results for code in each.code.values())
        kernels = sum(each.kernels for each in results)
        if kernels:
            print(f"[{count}/{len(files)}] {file}: {kernels} kernels, {seconds:.1f} s", flush=True)
    version = importlib.metadata.version("pointloom")
    archive = archive_of(built)
    name, wheel = wheel_of(archive, version)
    paths = [output / f"pointloom-cuda-kernels-{version}.zip", output / name]
    for path, content in zip(paths, (archive, wheel), strict=True):
        write_atomically(path, content)
    print(*table_of(built), sep="\n")
    print(f"{time.perf_counter() - start:.0f} s; written: {', '.join(map(str, paths))}")
    return paths


def _parsed(arguments: list[str]) -> argparse.Namespace:
    summary = (__doc__ or "").split("\n")[0]
    parser = argparse.ArgumentParser(prog="python -m pointloom.kernels.cuda_cache", description=summary)
    add = parser.add_argument
    add(
        "--architectures",
        type=int,
        nargs="*",
        default=list(ALL_ARCHITECTURES),
        metavar="90",
        help="of GPUs, as in sm_90",
    )
    add("--ptx", type=int, nargs="*", default=[], metavar="90", help="PTX too, for GPUs later than these")
    add("--work", type=Path, default=Path("build/cuda-kernels"), help="where what is compiled is kept")
    add("--output", type=Path, default=Path("dist"), help="where archive and wheel go")
    add("--only", nargs="*", default=[], metavar="MODULE", help="these files of kernels alone, by their module's names")
    parsed = parser.parse_args(arguments)
    unknown = sorted({*parsed.architectures, *parsed.ptx} - set(wp.get_cuda_supported_archs()))
    if unknown:
        parser.error(f"Warp {wp.__version__} does not compile for {', '.join(f'sm_{a}' for a in unknown)}")
    if not parsed.architectures and not parsed.ptx:
        parser.error("no architecture")
    return parsed


def main(arguments: list[str]) -> int:
    parsed = _parsed(arguments)
    targets = [*((a, False) for a in parsed.architectures), *((a, True) for a in parsed.ptx)]
    try:
        files = find_files()
        if unknown := sorted(set(parsed.only) - set(files)):
            raise RuntimeError(
                f"--only: {', '.join(unknown)}: no file of kernels; pointloom.kernels.arrays.sort is one"
            )
        build(parsed.only or files, targets, parsed.work, parsed.output)
    except KeyboardInterrupt:
        print("interrupted: what is compiled is kept, run it again to go on", file=sys.stderr)
        return INTERRUPTED_STATUS
    except (RuntimeError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
