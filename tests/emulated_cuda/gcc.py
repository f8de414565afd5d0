"""C to shared libraries, kept in the user's cache folder under what they are made of."""

import ctypes
import functools
import hashlib
import os
import platform
import shutil
import subprocess
import tempfile
from pathlib import Path

from .settings import settings

RUNTIME = Path(__file__).parent / "runtime"
# -Og: half the seconds of -O1 for large kernels. The rest is what PTX promises: no fused products, integers that wrap.
FLAGS = ["-shared", "-fPIC", "-w", "-fno-strict-aliasing", "-ffp-contract=off", "-fwrapv", f"-I{RUNTIME}"]


class EmulationError(RuntimeError):
    """The emulated device cannot work here."""


def check_machine() -> None:
    """Refuse a machine on which nothing would run, in one line."""
    if platform.system() != "Linux" or platform.machine() != "x86_64":
        here = f"{platform.system()} on {platform.machine()}"
        raise EmulationError(f"the emulated device needs Linux on x86-64, this is {here}")
    if shutil.which("gcc") is None:
        raise EmulationError("the emulated device needs gcc: apt-get install gcc libc6-dev")


@functools.cache
def cache_folder() -> Path:
    user = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    folder = Path(settings.cache or Path(user) / "pointloom" / "emulated-cuda")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except OSError:
        return Path(tempfile.mkdtemp(prefix="emulated-cuda-"))


@functools.cache
def headers_key() -> str:
    """What modules depend on: the headers of the runtime, and the machine's kind of processor."""
    return _key("*.h")


@functools.cache
def runtime_key() -> str:
    """What the runtime depends on: its headers and sources, and the machine's kind of processor."""
    return _key("*")


def _key(files: str) -> str:
    text = "".join(path.read_text() for path in sorted(RUNTIME.glob(files)))
    return hashlib.sha256((text + " ".join(_machine_flags())).encode()).hexdigest()


@functools.cache
def _machine_flags() -> list[str]:
    return ["-mfma"] if " fma " in Path("/proc/cpuinfo").read_text() else []


def write_atomically(path: Path, content: bytes) -> None:
    """Write a file so that other processes see all of it or nothing."""
    with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as file:
        file.write(content)
    Path(file.name).replace(path)


def build(name: str, sources: list[Path], flags: list[str]) -> Path:
    """The library of some C files, made if it is not there; several processes may do so at once."""
    library = cache_folder() / f"{name}.so"
    if library.exists():
        return library
    check_machine()
    with tempfile.TemporaryDirectory(dir=cache_folder()) as folder:
        made = Path(folder) / "made.so"
        command = ["gcc", *flags, *FLAGS, *_machine_flags(), "-o", str(made), *map(str, sources), "-lm"]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode:
            raise EmulationError(f"gcc: {done.stderr[:2000]}")
        made.replace(library)
    return library


def build_text(name: str, source: str) -> Path:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "module.c"
        path.write_text(source)
        return build(name, [path], ["-Og"])


@functools.cache
def load_runtime() -> ctypes.CDLL:
    """The runtime, whose functions all modules call."""
    sources = sorted(RUNTIME.glob("*.c"))
    # -flto and -Bsymbolic: the runtime calls its own functions directly
    flags = ["-O2", "-flto", "-Wl,-Bsymbolic"]
    return ctypes.CDLL(str(build(f"runtime-{runtime_key()[:24]}", sources, flags)), mode=ctypes.RTLD_GLOBAL)
