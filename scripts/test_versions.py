"""Run the tests with the oldest or the newest allowed versions of all dependencies.

    python scripts/test_versions.py {oldest,newest} [paths and options of pytest]
    python scripts/test_versions.py oldest --rest        the tests that `make test` leaves out, not the quick ones

The dependencies are those of pyproject.toml with all extras, but not Taichi, a compiler of its own. uv resolves them to
wheels for this interpreter. "oldest" takes the lower bound of each requirement, or the next version that has a wheel
and that the other requirements allow. A lower bound that is not reached is printed. "newest" takes the newest release.
A requirement without any wheel is left out and printed. The packages of the tests are the newest ones that fit.

The environment is build/versions/<choice>, and is made again when the versions change. uv is in build/versions/uv,
unless it is installed. Both take the package index from their settings.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from packaging.version import Version

ROOT = Path(__file__).resolve().parents[1]
VERSIONS = ROOT / "build" / "versions"
MODES = {"oldest": "lowest-direct", "newest": "highest"}
LEFT_OUT = {"taichi"}  # extras
# Indirect dependencies of old releases, whose newest versions issue warnings, which are errors in the tests.
COMPANIONS = {"oldest": ["pyparsing<3.3"], "newest": []}  # matplotlib 3.8 calls names that are deprecated in 3.3


class ResolutionError(Exception):
    """Requirements that cannot be met by wheels."""


def main(choice: str, *arguments: str) -> int:
    """Create the environment, print its versions and run the tests. Returns pytest's exit code."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    uv = find_uv()
    direct, without_wheel = with_wheels(requirements_of(project["project"]), uv)
    chosen = {requirement.name: pin for requirement, pin in zip(direct, pins_of(direct, choice, uv), strict=True)}
    tools = [*project["dependency-groups"]["test"], *project["build-system"]["requires"]]
    pins = [f"{name}=={pin}" for name, pin in chosen.items()]
    packages = resolve([*map(str, direct), *pins, *COMPANIONS[choice], *tools], "newest", uv)
    python = environment(VERSIONS / choice, packages)
    print(", ".join(f"{name} {pin}" for name, pin in sorted(chosen.items())))
    for requirement in without_wheel:
        print(f"left out: {requirement} has no wheel for this interpreter")
    for requirement in direct if choice == "oldest" else ():
        bound = lower_bound(requirement)
        if bound and Version(chosen[requirement.name]).release[: len(bound.release)] != bound.release:
            print(f"lower bound not tested: {requirement} is {chosen[requirement.name]}, the oldest that fits")
    sys.stdout.flush()
    selection = [] if "--rest" in arguments else ["--quick"]
    workers = ["-n", str(min(4, os.cpu_count() or 1)), "--dist", "loadscope", "--no-loadscope-reorder"]
    tests = [python, "-m", "pytest", *workers, *selection, *arguments]
    return subprocess.run(tests, cwd=ROOT, env=os.environ | {"OPENBLAS_NUM_THREADS": "1"}, check=False).returncode


def find_uv() -> str:
    """The uv of this environment or of the system, else one in an environment of its own."""
    own = VERSIONS / "uv" / "bin" / "uv"
    found = shutil.which("uv", path=Path(sys.executable).parent) or shutil.which("uv")
    if found is None and not own.exists():
        subprocess.run([sys.executable, "-m", "venv", "--clear", own.parents[1]], check=True)
        subprocess.run([own.with_name("python"), "-m", "pip", "install", "--quiet", "uv"], check=True)
    return found or str(own)


def requirements_of(project: dict[str, Any]) -> list[Requirement]:
    """The runtime dependencies and those of all extras that apply to this interpreter."""
    extras = project["optional-dependencies"]
    texts = [*project["dependencies"], *(text for name in extras if name not in LEFT_OUT for text in extras[name])]
    requirements = [Requirement(text) for text in dict.fromkeys(texts)]
    return [each for each in requirements if each.marker is None or each.marker.evaluate()]


def with_wheels(requirements: list[Requirement], uv: str) -> tuple[list[Requirement], list[Requirement]]:
    """The requirements that wheels can meet, and the others."""
    usable, others = [], []
    for requirement in requirements:
        try:
            resolve([str(requirement)], "newest", uv)
            usable.append(requirement)
        except ResolutionError:
            others.append(requirement)
    return usable, others


def pins_of(requirements: list[Requirement], choice: str, uv: str) -> list[str]:
    """The version of each requirement, if all of them are installed together."""
    versions = dict(pin.split("==") for pin in resolve([str(each) for each in requirements], choice, uv))
    return [versions[canonicalize_name(each.name)] for each in requirements]


def resolve(requirements: list[str], choice: str, uv: str) -> list[str]:
    """Resolve requirements to wheels for this interpreter: lines `name==version`.

    Raises:
        ResolutionError: No wheels meet all of them.
    """
    command = [uv, "pip", "compile", "-", "--resolution", MODES[choice], "--python", sys.executable]
    command += ["--only-binary", ":all:", "--no-header", "--no-annotate", "--quiet"]
    text = "\n".join(requirements)
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False, cwd=VERSIONS)
    if done.returncode:
        raise ResolutionError(done.stderr)
    return re.findall(r"^[\w.-]+==[^\s;]+", done.stdout, re.MULTILINE)


def lower_bound(requirement: Requirement) -> Version | None:
    return next((Version(part.version) for part in requirement.specifier if part.operator == ">="), None)


def environment(folder: Path, packages: list[str]) -> str:
    """An environment with these packages and this checkout; returns its interpreter."""
    python, listed = folder / "bin" / "python", folder / "packages.txt"
    text = "\n".join(packages) + "\n"
    if python.exists() and listed.exists() and listed.read_text() == text:
        return str(python)
    subprocess.run([sys.executable, "-m", "venv", "--clear", folder], check=True)
    install = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps"]
    subprocess.run([*install, "--only-binary", ":all:", *packages], check=True)
    subprocess.run([*install, "--no-build-isolation", "-e", ROOT], check=True)
    subprocess.run([python, "-m", "pip", "check"], check=True)
    listed.write_text(text)
    return str(python)


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] not in MODES:
        sys.exit(__doc__)
    VERSIONS.mkdir(parents=True, exist_ok=True)
    try:
        sys.exit(main(*sys.argv[1:]))
    except ResolutionError as error:
        sys.exit(f"test_versions: uv found no wheels for all requirements:\n{error}")
