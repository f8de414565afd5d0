"""Write constraints/*.txt: name, version and SHA-256 hashes of every package that pointloom is tested with.

    .venv/bin/python scripts/update_constraints.py                           # after a change of dependencies
    .venv/bin/python scripts/update_constraints.py --upgrade-package scipy   # upgrade one package
    .venv/bin/python scripts/update_constraints.py --upgrade                 # upgrade all packages

uv resolves pyproject.toml for Linux x86-64 and the Python versions in PYTHONS (`pip install uv` if it is missing; it
takes the package index from its settings). Existing versions stay unchanged unless an upgrade is requested. Only
hashes of wheels for these platforms are written, and no URL of an index.

The files build on each other: runtime.txt (with the build backend, for the editable install), test.txt (`make test`),
full.txt (Open3D, Taichi, lint, types, the site), bench.txt (the baselines of the benchmarks). The Makefile installs
them without pip's resolver, and then `pip check` looks for missing packages.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path
from typing import Any

from packaging.markers import Marker
from packaging.tags import Tag, compatible_tags, cpython_tags
from packaging.utils import canonicalize_name, parse_wheel_filename

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "constraints"
PYTHONS = ((3, 11), (3, 12), (3, 13), (3, 14))
GLIBC_MINOR = 35  # Ubuntu 22.04 has glibc 2.35, Debian 12 has 2.36

# file -> dependency groups added to those of the previous file
LAYERS = {"runtime": (), "test": ("test",), "full": ("oracle", "lint", "docs"), "bench": ("bench",)}
TITLES = {
    "runtime": "Runtime dependencies of pointloom, and the build backend for editable installs.",
    "test": "The tests of `make test`.",
    "full": "Open3D and Taichi for `make test-all`, lint, types and the site.",
    "bench": "Baselines of the benchmarks.",
}


def main() -> int:
    """Resolve the layers and write them; returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--upgrade", action="store_true", help="take the newest version of every package")
    parser.add_argument(
        "--upgrade-package", action="append", default=[], metavar="NAME", help="take the newest version of this package"
    )
    options = parser.parse_args()

    released = {canonicalize_name(name) for name in options.upgrade_package}
    pins = {} if options.upgrade else {name: pin for name, pin in present_pins().items() if name not in released}
    requirements = layer_requirements()
    everything = resolve(requirements["bench"], pins)
    fixed = {package["name"]: package["version"] for package in everything}

    written: set[str] = set()
    FOLDER.mkdir(exist_ok=True)
    before = None
    for layer in LAYERS:
        names = {package["name"] for package in resolve(requirements[layer], fixed)}
        packages = [package for package in everything if package["name"] in names - written]
        written |= names
        lines = [f"# {TITLES[layer]}", "# Written by scripts/update_constraints.py; do not edit."]
        lines += [f"-r {before}.txt"] if before else []
        entries = [entry for package in packages if (entry := requirement_entry(package))]
        (FOLDER / f"{layer}.txt").write_text("\n".join([*lines, *entries]) + "\n")
        print(f"constraints/{layer}.txt: {len(entries)} packages")
        before = layer
    return 0


def layer_requirements() -> dict[str, list[str]]:
    """The requirements of each layer from pyproject.toml, including those of the layers below."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    requirements = [*project["project"]["dependencies"], *project["build-system"]["requires"]]
    layers = {}
    for layer, groups in LAYERS.items():
        for group in groups:
            requirements += project["dependency-groups"][group]
        layers[layer] = list(requirements)
    return layers


def present_pins() -> dict[str, str]:
    """The versions in the existing files."""
    text = "\n".join(path.read_text() for path in sorted(FOLDER.glob("*.txt")))
    return {canonicalize_name(name): pin for name, pin in re.findall(r"^([\w.-]+)==([^\s;\\]+)", text, re.MULTILINE)}


def resolve(requirements: list[str], pins: dict[str, str]) -> list[dict[str, Any]]:
    """Resolve requirements for all platforms with uv; one entry per package in alphabetical order."""
    uv = shutil.which("uv", path=Path(sys.executable).parent) or shutil.which("uv")
    if uv is None:
        sys.exit("update_constraints: uv is not installed; install it first: python -m pip install uv")
    with tempfile.TemporaryDirectory() as folder:
        wanted, constraints, lock_file = (Path(folder, name) for name in ("in.txt", "pins.txt", "pylock.toml"))
        wanted.write_text("\n".join(requirements) + "\n")
        constraints.write_text("".join(f"{name}=={pin}\n" for name, pin in pins.items()))
        command = [uv, "pip", "compile", "in.txt", "--constraints", "pins.txt", "--output-file", "pylock.toml"]
        command += ["--universal", "--python-version", "{}.{}".format(*PYTHONS[0]), "--fork-strategy", "fewest"]
        command += ["--only-binary", ":all:", "--no-header", "--no-annotate", "--quiet"]
        if subprocess.run(command, cwd=folder, check=False).returncode:
            sys.exit("update_constraints: uv found no resolution (a pin may be out of bounds: --upgrade-package NAME)")
        return tomllib.loads(lock_file.read_text())["packages"]


def requirement_entry(package: dict[str, Any]) -> str | None:
    """A requirement with its hashes, or None if no supported Python version needs it."""
    marker = Marker(package["marker"]) if "marker" in package else None
    pythons = [python for python in PYTHONS if marker is None or marker.evaluate(machine(python))]
    if not pythons:
        return None
    hashes = set()
    for python in pythons:
        fitting = [wheel for wheel in package.get("wheels", []) if wheel_tags(wheel) & accepted_tags(python)]
        if not fitting:
            raise SystemExit(f"{package['name']} {package['version']}: no Linux x86-64 wheel for Python {python}")
        hashes |= {wheel["hashes"]["sha256"] for wheel in fitting}
    condition = ""
    if pythons != list(PYTHONS):
        condition = " ; " + " or ".join("python_version == '{}.{}'".format(*python) for python in pythons)
    return f"{package['name']}=={package['version']}{condition}" + "".join(
        f" \\\n    --hash=sha256:{digest}" for digest in sorted(hashes)
    )


def machine(python: tuple[int, int]) -> dict[str, str]:
    """The marker environment of a Linux x86-64 machine with this CPython."""
    version = "{}.{}".format(*python)
    return {
        "implementation_name": "cpython",
        "implementation_version": f"{version}.0",
        "os_name": "posix",
        "platform_machine": "x86_64",
        "platform_python_implementation": "CPython",
        "platform_release": "",
        "platform_system": "Linux",
        "platform_version": "",
        "python_full_version": f"{version}.0",
        "python_version": version,
        "sys_platform": "linux",
        "extra": "",
    }


def wheel_tags(wheel: dict[str, Any]) -> frozenset[Tag]:
    """The tags in the wheel's file name."""
    name = wheel.get("name") or wheel["url"].rsplit("/", 1)[1].split("#")[0]
    return parse_wheel_filename(name.replace("%2B", "+"))[3]


def accepted_tags(python: tuple[int, int]) -> set[Tag]:
    """The tags that pip accepts on these machines."""
    platforms = [f"manylinux_2_{minor}_x86_64" for minor in range(GLIBC_MINOR, 4, -1)]
    platforms += ["manylinux2014_x86_64", "manylinux2010_x86_64", "manylinux1_x86_64", "linux_x86_64"]
    return {*cpython_tags(python, platforms=platforms), *compatible_tags(python, "cp{}{}".format(*python), platforms)}


if __name__ == "__main__":
    sys.exit(main())
