"""Pack files for a GPU machine without network that runs one command at a time, with N MiB per call: make gpu-kit.

    make gpu-kit                                            all missing archives, then the folders of calls
    make gpu-kit CALL_MIB=64 CALLS=3 GPU_PYTHON=3.12 GPU_ARCHITECTURE=90
    make gpu-kit ARGS="kernels layout"                      only these, after a change in kernels/

    warp      Warp with the GPU code of one architecture
    kernels   pointloom's precompiled kernels
    cpu       the same for the CPU of the GPU machine, for tests that compare both
    before    the code before the changes of compare.py, with its kernels
    wheels    small packages that tests and peers.py import and that are missing on such a machine
    open3d    Open3D likewise, with the system libraries that it links; for the Python of the GPU machine
    layout    split into build/gpu-kit/1 to N, with the seconds of the plan (steps.py); the working tree is sent with
              each and counts toward the size of a call

Run it hours before: xz takes minutes and the kernels take an hour of two cores, once. Then run on the GPU machine, one
call after the other: `bash benchmarks/gpu_kit/call.sh build/gpu-kit/1` (see README.md).
"""

from __future__ import annotations

import argparse
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from gpu_kit.compare import CHANGES, checked_out
from gpu_kit.fatbins import keep_architecture
from gpu_kit.layout import Piece, lay_out
from gpu_kit.steps import RUNS, calls_of, steps_of

ROOT = Path(__file__).resolve().parents[2]
OPEN3D = "open3d==0.20.0"
# Tests of point files need laspy. torch-fps and cupy-knn are peers that compile their kernels at run time
WHEELS = ("laspy", "lazrs", "msgspec", "trimesh", "small-gicp", "torch-fps", "cupy-knn")
LARGEST_WHEEL = 6 << 20
PLATFORMS = [f"manylinux_2_{n}_x86_64" for n in (17, 24, 27, 28, 31, 34, 35)]
PLATFORMS += ["manylinux2014_x86_64", "manylinux1_x86_64"]
ON_DEMAND = ("fem", "render", "optim")  # optional modules of Warp, imported on demand
NOT_OF_WARP = ("__pycache__", "tests", "examples", *ON_DEMAND, "jax_experimental")
NOT_OF_OPEN3D = ("resources", "examples", "labextension", "nbextension", "_ml3d", "agent_skills")
PARTS = ("warp", "kernels", "before", "cpu", "wheels", "open3d", "layout")
CPU_LEVELS = ("x86-64-v3", "x86-64-v4")
EVERYWHERE = ("libc.so", "libm.so", "libpthread", "libdl.so", "librt.so", "ld-linux", "libstdc++", "libgcc_s")
EVERYWHERE += ("libresolv", "libOpen3D", "libtbb")

# Imports of Open3D's viewers, replaced by stubs if not installed
STUB = '''"""Import this before open3d if the packages of its viewers are not installed."""
import importlib.abc, importlib.machinery, sys, types
NAMES = set("plotly dash flask werkzeug ipywidgets nbformat configargparse IPython addict pyquaternion".split())
class _Module(types.ModuleType):
    __path__ = []
    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return type(name, (), {"__init__": lambda s, *a, **k: None, "__call__": lambda s, f=None, *a, **k: f})
class _Finder(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] in NAMES:
            return importlib.machinery.ModuleSpec(name, self, is_package=True)
    def create_module(self, spec):
        return _Module(spec.name)
    def exec_module(self, module):
        pass
sys.meta_path.append(_Finder())
'''


class Packer:
    """Builds the archives in a folder, for one GPU architecture and one Python."""

    def __init__(self, out: Path, architecture: int, python: str) -> None:
        self.out, self.architecture, self.python = out, architecture, python

    def archive(self, stage: Path, name: str) -> None:
        """A tar.xz of a folder's contents, optimized for size."""
        to = self.out / name
        partial = to.with_suffix(".partial")
        squeeze = "xz -T1 --x86 --lzma2=preset=9,dict=128MiB"
        subprocess.run(["tar", "-I", squeeze, "-cf", partial, "-C", stage, "."], check=True)
        partial.replace(to)
        print(f"{name}: {to.stat().st_size / 2**20:.1f} MiB", flush=True)

    def warp(self) -> None:
        """The installed Warp, without its tests and other GPUs' code."""
        spec = importlib.util.find_spec("warp")
        if spec is None or not spec.submodule_search_locations:
            raise SystemExit(f"warp is not installed for {sys.executable}")
        source = Path(next(iter(spec.submodule_search_locations)))
        with tempfile.TemporaryDirectory(dir=self.out) as folder:
            stage = Path(folder)
            shutil.copytree(source, stage / "warp", ignore=shutil.ignore_patterns(*NOT_OF_WARP))
            for name in ON_DEMAND:
                if (source / name).is_dir():
                    shutil.copytree(source / name, stage / "warp" / name, ignore=shutil.ignore_patterns("__pycache__"))
            for info in source.parent.glob("warp_lang-*.dist-info"):
                shutil.copytree(info, stage / info.name)
            keep_architecture(stage / "warp" / "bin" / "warp.so", self.architecture)
            self.archive(stage, "warp.tar.xz")

    def kernels(self) -> None:
        """The archive of `make cuda-cache`, for one architecture."""
        self.compile(ROOT / "src", self.out / "kernels.zip")
        print(f"kernels.zip: {(self.out / 'kernels.zip').stat().st_size / 2**20:.1f} MiB", flush=True)

    def compile(self, sources: Path, to: Path) -> None:
        """Compile the kernels of a folder of sources into an archive, without those that were compiled before."""
        with tempfile.TemporaryDirectory(dir=self.out) as folder:
            command = [sys.executable, "-m", "pointloom.kernels.cuda_cache", "--architectures", str(self.architecture)]
            command += ["--work", str(ROOT / "build" / "cuda-kernels"), "--output", folder]
            subprocess.run(command, check=True, env={**os.environ, "PYTHONPATH": str(sources)})
            (archive,) = Path(folder).glob("pointloom-cuda-kernels-*.zip")
            shutil.copy(archive, to)

    def before(self) -> None:
        """The code before each change of compare.py, with its kernels."""
        with tempfile.TemporaryDirectory(dir=self.out) as folder:
            for change in CHANGES:
                sources = Path(folder, "before", change.folder)
                sources.mkdir(parents=True)
                if not checked_out(change.before, sources):
                    raise SystemExit(f"{change.name}: git has no commit {change.before}")
                self.compile(sources / "src", sources / "kernels.zip")
            self.archive(Path(folder), "before.tar.xz")

    def cpu(self) -> None:
        """The compiled CPU kernels of `make cpu-kernels`, for recent processors."""
        with tempfile.TemporaryDirectory(dir=self.out) as folder:
            command = [sys.executable, "-m", "pointloom.kernels.cpu_kernels", "--levels", *CPU_LEVELS]
            subprocess.run([*command, "--output", str(Path(folder, "cpu-kernels"))], check=True)
            self.archive(Path(folder), "cpu.tar.xz")

    def download(self, names: tuple[str, ...], to: Path) -> None:
        """Download wheels for the Python of the GPU machine; prints packages without a wheel."""
        base = [sys.executable, "-m", "pip", "download", "-q", "--no-deps", "--only-binary=:all:"]
        base += ["--python-version", self.python, "--implementation", "cp", "-d", str(to)]
        base += [word for platform in PLATFORMS for word in ("--platform", platform)]
        for name in names:
            if subprocess.run([*base, name], check=False).returncode:
                print(f"{name}: no wheel for Python {self.python}; skipped")

    def wheels(self) -> None:
        """Small packages, unpacked into one folder."""
        with tempfile.TemporaryDirectory(dir=self.out) as folder:
            got, stage = Path(folder, "wheels"), Path(folder, "stage")
            self.download(WHEELS, got)
            stage.mkdir()
            for wheel in sorted(got.glob("*.whl")):
                if wheel.stat().st_size > LARGEST_WHEEL:
                    print(f"{wheel.name}: too large, skipped")
                else:
                    shutil.unpack_archive(wheel, stage, "zip")
            self.archive(stage, "wheels.tar.xz")

    def open3d(self) -> None:
        """Open3D without viewers, machine learning and other GPUs' code."""
        with tempfile.TemporaryDirectory(dir=self.out) as folder:
            got, stage = Path(folder, "wheels"), Path(folder, "stage")
            self.download((OPEN3D,), got)
            (wheel,) = got.glob("open3d-*.whl")
            shutil.unpack_archive(wheel, stage, "zip")
            wheel.unlink()
            package = stage / "open3d"
            for name in NOT_OF_OPEN3D:
                shutil.rmtree(package / name, ignore_errors=True)
            for path in [*package.glob("open3d_*_ops.so"), *stage.glob("open3d-*.data")]:
                shutil.rmtree(path) if path.is_dir() else path.unlink()
            for library in stage.rglob("libOpen3D.so*"):
                keep_architecture(library, self.architecture)
                copy_system_libraries(library, package)  # beside its binding, which is searched first
            (stage / "open3d_stub.py").write_text(STUB)
            self.archive(stage, "open3d.tar.xz")


def copy_system_libraries(library: Path, to: Path) -> None:
    """Copy the system libraries that a library links (X11, GL, EGL, usb, ...), since a minimal machine has none."""
    listing = subprocess.run(["ldd", library], capture_output=True, text=True, check=True).stdout
    for line in listing.splitlines():
        name, _, target = line.strip().partition(" => ")
        if target.startswith("not found") and not name.startswith(EVERYWHERE):
            print(
                f"{name}: not found on this machine. Install it, otherwise Open3D cannot be loaded on the GPU machine"
            )
        elif target.startswith("/") and not name.startswith(EVERYWHERE):
            shutil.copy(Path(target.split(" ")[0]).resolve(), to / name)


def tree_size() -> int:
    """Bytes of the working tree: tracked files, and untracked ones that git does not ignore."""
    command = ["git", "ls-files", "-z", "-co", "--exclude-standard"]
    listed = subprocess.run(command, capture_output=True, check=True, cwd=ROOT).stdout
    paths = [ROOT / os.fsdecode(name) for name in listed.split(b"\0") if name]
    return sum(path.lstat().st_size for path in paths if path.is_symlink() or path.exists())


def main() -> int:
    """Build the requested archives."""
    parser = argparse.ArgumentParser(
        prog="make gpu-kit", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("parts", nargs="*", metavar="PART", help=f"of {', '.join(PARTS)}; default: all missing ones")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "gpu-kit", help="output folder, ignored by git")
    parser.add_argument("--call-mib", type=float, default=64, help="size limit of a call, including the working tree")
    parser.add_argument("--calls", type=int, default=3, help="calls that carry the archives")
    parser.add_argument("--run", type=int, choices=RUNS, default=1, help="run of the plan")
    parser.add_argument("--python", default="3.12", help="Python version of the GPU machine")
    parser.add_argument(
        "--architecture", type=int, default=90, help="architecture of its GPU: 90 for Hopper, 89 for Ada"
    )
    options = parser.parse_args()
    if unknown := set(options.parts) - set(PARTS):
        parser.error(f"no such part: {', '.join(sorted(unknown))}")
    options.out.mkdir(parents=True, exist_ok=True)
    packer = Packer(options.out, options.architecture, options.python)
    archives: dict[str, Callable[[], None]] = {name: getattr(packer, name) for name in PARTS[:-1]}
    pieces = [Piece(name, next(iter(options.out.glob(f"{name}.*z*")), None)) for name in archives]
    for piece in pieces:
        if piece.name in options.parts or (not options.parts and piece.path is None):
            archives[piece.name]()
    if not options.parts or "layout" in options.parts:
        room = int(options.call_mib * 2**20) - tree_size()
        needed = {name for step in steps_of(options.run) for name in step.needs} | {"cpu", "wheels"}
        made = [Piece(name, next(iter(sorted(options.out.glob(f"{name}.*z*"))), None)) for name in archives]
        made = [piece for piece in made if piece.name in needed]
        print("\n".join(lay_out(options.out, made, calls_of(options.run, options.calls), options.run, room)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
