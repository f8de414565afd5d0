"""Run the quick tests with the oldest or the newest allowed versions of Warp, NumPy and SciPy.

    python scripts/test_versions.py {oldest,newest} [paths and options of pytest]

The environment is build/versions/<choice>. The other packages of the tests are those that pip resolves.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
NUMERIC = {"numpy", "scipy", "warp-lang"}


def requirements(choice: str, project: dict[str, list[str]]) -> list[str]:
    """The runtime dependencies. "oldest": the last releases of the lower bounds of NUMERIC."""
    bounds = [(text.partition(">=")[0], text) for text in project["dependencies"]]
    is_oldest = choice == "oldest"
    return [text.replace(">=", "==") + ".*" if is_oldest and name in NUMERIC else text for name, text in bounds]


def main(choice: str, *arguments: str) -> int:
    """Create the environment, print its versions and run the tests. Returns pytest's exit code."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    folder = ROOT / "build" / "versions" / choice
    python = str(folder / "bin" / "python")
    subprocess.run([sys.executable, "-m", "venv", "--clear", folder], check=True)
    install = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--only-binary", ":all:"]
    packages = [*requirements(choice, project["project"]), *project["dependency-groups"]["test"], "hatchling"]
    subprocess.run([*install, *packages], check=True)
    subprocess.run([*install, "--no-deps", "--no-build-isolation", "-e", ROOT], check=True)
    shown = [text.split(">")[0] for text in project["project"]["dependencies"]]
    code = "import importlib.metadata as m, sys; print(*(f'{n} {m.version(n)}' for n in sys.argv[1:]), sep=', ')"
    subprocess.run([python, "-c", code, *shown], check=True)
    tests = [
        python,
        "-m",
        "pytest",
        "-n",
        str(min(4, os.cpu_count() or 1)),
        "--dist",
        "loadscope",
        "--quick",
        *arguments,
    ]
    return subprocess.run(tests, cwd=ROOT, env=os.environ | {"OPENBLAS_NUM_THREADS": "1"}, check=False).returncode


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] not in ("oldest", "newest"):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
