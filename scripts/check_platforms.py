"""Check that the dependencies of pointloom have wheels for each platform in docs/install.md.

    .venv/bin/python scripts/check_platforms.py

For each platform and version of Python, pip resolves the dependencies of pyproject.toml to wheels for that version of
the system. Nothing is installed. pip takes the package index from its settings. The exit code is 1 if a pair that
docs/install.md lists as tested or available does not resolve, or if one that it lists as not available does.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet
from packaging.utils import canonicalize_name

ROOT = Path(__file__).resolve().parents[1]
DEPENDENCIES = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["dependencies"]
PYTHONS = ("3.11", "3.12", "3.13", "3.14", "3.14t", "3.15", "3.15t")
AVAILABLE, MISSING = {"tested", "available"}, {"not available"}

# platform, as in the table of docs/install.md -> tags of wheels, and what markers of dependencies compare
PLATFORMS: dict[str, tuple[list[str], dict[str, str]]] = {
    "Linux x86-64, glibc 2.28": (
        [*(f"manylinux_2_{minor}_x86_64" for minor in range(28, 4, -1)), "manylinux2014_x86_64"],
        {"sys_platform": "linux", "platform_system": "Linux", "os_name": "posix", "platform_machine": "x86_64"},
    ),
    "Linux aarch64, glibc 2.34": (
        [*(f"manylinux_2_{minor}_aarch64" for minor in range(34, 16, -1)), "manylinux2014_aarch64"],
        {"sys_platform": "linux", "platform_system": "Linux", "os_name": "posix", "platform_machine": "aarch64"},
    ),
    "macOS 12, arm64": (
        ["macosx_12_0_arm64"],
        {"sys_platform": "darwin", "platform_system": "Darwin", "os_name": "posix", "platform_machine": "arm64"},
    ),
    "macOS 12, x86-64": (
        ["macosx_12_0_x86_64"],
        {"sys_platform": "darwin", "platform_system": "Darwin", "os_name": "posix", "platform_machine": "x86_64"},
    ),
    "Windows x86-64": (
        ["win_amd64"],
        {"sys_platform": "win32", "platform_system": "Windows", "os_name": "nt", "platform_machine": "AMD64"},
    ),
}


def main() -> int:
    """Print the table; returns the exit code."""
    documented = read_table((ROOT / "docs" / "install.md").read_text(encoding="utf-8"))
    pairs = [(platform, python) for platform in PLATFORMS for python in PYTHONS]
    with ThreadPoolExecutor(2) as pool:
        problems = dict(zip(pairs, pool.map(lambda pair: problem_of(*pair), pairs), strict=True))
    print(f"{'':<26}" + "".join(f"{python:>8}" for python in PYTHONS))
    for platform in PLATFORMS:
        print(f"{platform:<26}" + "".join(f"{'-' if problems[platform, p] else 'wheels':>8}" for p in PYTHONS))
    failures = 0
    for (platform, python), problem in problems.items():
        words = documented.get((platform, python), "no cell")
        if words not in (MISSING if problem else AVAILABLE):
            failures += 1
            print(f"docs/install.md: {platform}, Python {python}: {words}, but pip: {problem or 'resolves'}")
    return 1 if failures else 0


def read_table(text: str) -> dict[tuple[str, str], str]:
    """Cells of the table whose header names Python versions: (platform, version) -> text."""
    cells, pythons = {}, []
    for line in text.splitlines():
        first, *others = [cell.strip() for cell in line.strip("| ").split("|")]
        if re.fullmatch(r"3\.\d+t?", others[0] if others else ""):
            pythons = others
        elif pythons and not line.startswith("|"):
            break
        elif first != "---":
            cells |= {(first, python): cell for python, cell in zip(pythons, others, strict=False)}
    return cells


def problem_of(platform: str, python: str) -> str:
    """Reason why the dependencies do not resolve to wheels. Empty if they do."""
    tags, markers = PLATFORMS[platform]
    version = python.rstrip("t")
    environment = markers | {"python_version": version, "python_full_version": f"{version}.0", "extra": ""}
    wanted = list(DEPENDENCIES)
    while True:
        installed, error = resolve(wanted, tags, python)
        if error:
            return error
        # pip compares the limits of Python versions and the markers with its own Python and system.
        names = {canonicalize_name(item["name"]) for item in installed}
        unfit = [
            f"{item['name']}!={item['version']}"
            for item in installed
            if not SpecifierSet(item.get("requires_python", "")).contains(version)
        ]
        needs = [Requirement(text) for item in installed for text in item.get("requires_dist", [])]
        needs = [need for need in needs if need.marker is None or need.marker.evaluate(environment)]
        missing = [f"{need.name}{need.specifier}" for need in needs if canonicalize_name(need.name) not in names]
        if not unfit and not missing:
            return ""
        wanted += [*unfit, *missing]


def resolve(wanted: list[str], tags: list[str], python: str) -> tuple[list[dict[str, Any]], str]:
    """Metadata of the wheels that pip would install, and the last error of pip."""
    version, compact = python.rstrip("t"), python.replace(".", "")
    abis = [f"cp{compact}", "none"] if python.endswith("t") else [f"cp{compact}", "abi3", "none"]
    command = [sys.executable, "-m", "pip", "install", "--dry-run", "--quiet", "--ignore-installed"]
    command += ["--ignore-requires-python", "--only-binary", ":all:", "--implementation", "cp"]
    command += ["--python-version", version, *(word for abi in abis for word in ("--abi", abi))]
    command += [word for tag in tags for word in ("--platform", tag)]
    with tempfile.TemporaryDirectory() as folder:
        command += ["--target", folder, "--report", "-", *wanted]
        done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    if done.returncode:
        errors = [line for line in done.stderr.splitlines() if line.startswith("ERROR")]
        return [], errors[-1] if errors else done.stderr[-200:]
    return [item["metadata"] for item in json.loads(done.stdout)["install"]], ""


if __name__ == "__main__":
    sys.exit(main())
