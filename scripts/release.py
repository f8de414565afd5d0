"""Build and check a release: `make release`. Needs a clean tree and no GPU.

    make release                                        everything; the CUDA kernels take an hour of two cores, once
    make release ARGS="--without-cuda"                  without the wheel of CUDA kernels
    make release ARGS="--gallery"                       the site with its gallery
    .venv/bin/python scripts/release.py --prepare 0.2.0        before: version, changelog and record of names, to commit

Writes to dist/: the sdist, the wheel with compiled CPU kernels, the wheel of CUDA kernels, an SBOM (CycloneDX JSON) and
SHA256SUMS. They depend only on the commit and `SOURCE_DATE_EPOCH`, by default the time of the commit. The wheel is
installed in a fresh environment of each supported CPython on PATH or of pyenv, the sdist in one. There,
scripts/smoke.py runs without network and with an empty, read-only home folder. Each step writes
build/release/<step>.log. If the tree or a package is faulty, the later steps are left out. The exit code is 1 if a
step failed.
"""

from __future__ import annotations

import argparse
import hashlib
import importlib.metadata
import json
import os
import re
import shutil
import stat
import subprocess
import sys
import tempfile
import time
import tomllib
import uuid
from collections.abc import Callable, Iterable, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet
from packaging.utils import canonicalize_name
from packaging.version import Version

ROOT = Path(__file__).resolve().parents[1]
LOGS, DIST = ROOT / "build" / "release", ROOT / "dist"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
NAME, VERSION = PROJECT["name"], PROJECT["version"]
STATE_VERSION = (
    "pyproject.toml",
    "src/pointloom/__init__.py",
    "recipe/recipe.yaml",
    "CITATION.cff",
    "docs/pointloom.1",
)
PREPARE = "scripts/release.py --prepare VERSION"
CLOSED_PORT = "http://127.0.0.1:9"  # the discard service, which no current system runs
KERNELS_ARE_CURRENT = """
import json
from pointloom.kernels import lang
from pointloom.kernels.language import cpu_archive as a
files = [a.FOLDER / level / a.MANIFEST for level in a.LEVELS]
raise SystemExit(not all(f.exists() and json.loads(f.read_text()) == a.made_from() for f in files))
"""


class StepError(RuntimeError):
    """A step failed, for the reason in the message."""


def changelog_section(text: str) -> tuple[str, str]:
    """Heading and content of the newest section of a changelog."""
    _, heading, content = re.split(r"^## (.+)$", text, maxsplit=2, flags=re.MULTILINE)[:3]
    return heading, content


def check_version(changelog: str, version: str) -> None:
    """Check that a changelog starts with a dated section of the version. Raises StepError."""
    heading = changelog_section(changelog)[0]
    if not re.fullmatch(rf"{re.escape(version)} \(\d{{4}}-\d\d-\d\d\)", heading):
        raise StepError(f"CHANGELOG.md: expected the first heading '{version} (YYYY-MM-DD)', got '{heading}'")


def prepare(version: str, date: str, root: Path = ROOT) -> None:
    """Write a version into the files that state it, move changes/ into CHANGELOG.md, and record the public names."""
    old = rf"(version[_\W]+|pointloom ){re.escape(VERSION)}"
    for name in STATE_VERSION:
        text, count = re.subn(old, rf"\g<1>{version}", (root / name).read_text(), count=1)
        if not count:
            raise StepError(f"{name}: expected the version {VERSION}, found none")
        (root / name).write_text(re.sub(r"(?m)^(date-released: ).*", rf"\g<1>{date}", text))
    command = [sys.executable, "-m", "towncrier", "build", "--yes", "--version", version, "--date", date]
    subprocess.run(command, cwd=root, check=True)
    changelog = root / "CHANGELOG.md"
    changelog.write_text(changelog.read_text().replace("\n## Unreleased\n", "\n### Other changes\n", 1))
    shutil.copyfile(root / "docs/api.txt", root / f"docs/api-{version}.txt")


def checksums(paths: Iterable[Path]) -> str:
    """The content of SHA256SUMS, sorted by name, for `sha256sum --check`."""
    return "".join(f"{sha256(path)}  {path.name}\n" for path in sorted(paths, key=lambda path: path.name))


def sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def license_of(metadata: Any) -> list[dict[str, Any]]:
    """The license of a package in CycloneDX's form: the expression, else its name or classifiers."""
    if expression := metadata.get("License-Expression"):
        return [{"expression": expression}]
    trove = [each.rpartition(" :: ")[2] for each in metadata.get_all("Classifier", []) if each.startswith("License ::")]
    text = (metadata.get("License") or "").strip()
    names = [text] if text and "\n" not in text else trove  # some packages have the full text there
    return [{"license": {"name": name}} for name in names]


def sbom(distributions: Iterable[importlib.metadata.Distribution], files: Iterable[Path], epoch: int) -> str:
    """Software bill of materials in CycloneDX 1.6: this project, what it needs as installed, and the built files."""
    installed = {canonicalize_name(each.metadata["Name"]): each for each in distributions}
    needs, queue = {}, [NAME]
    while queue:
        name = queue.pop()
        listed = [Requirement(text) for text in installed[name].requires or []]
        own = [each for each in listed if each.marker is None or each.marker.evaluate({"extra": ""})]
        needs[name] = sorted({canonicalize_name(each.name) for each in own} & installed.keys())
        queue += [each for each in needs[name] if each not in needs]
    references = {name: f"pkg:pypi/{name}@{installed[name].version}" for name in sorted(needs)}
    components = [
        {"type": "library", "bom-ref": reference, "name": name, "version": installed[name].version, "purl": reference}
        | ({"licenses": found} if (found := license_of(installed[name].metadata)) else {})
        for name, reference in references.items()
    ]
    own = next(each for each in components if each["name"] == NAME)
    built = [
        {"type": "file", "name": path.name, "hashes": [{"alg": "SHA-256", "content": sha256(path)}]}
        for path in sorted(files, key=lambda path: path.name)
    ]
    content = {
        "metadata": {"timestamp": f"{datetime.fromtimestamp(epoch, UTC):%Y-%m-%dT%H:%M:%SZ}", "component": own},
        "components": [each for each in components if each is not own] + built,
        "dependencies": [
            {"ref": reference, "dependsOn": [references[each] for each in needs[name]]}
            for name, reference in references.items()
        ],
    }
    serial = uuid.uuid5(uuid.NAMESPACE_URL, json.dumps(content))
    head = {"bomFormat": "CycloneDX", "specVersion": "1.6", "serialNumber": f"urn:uuid:{serial}", "version": 1}
    return json.dumps(head | content, indent=2) + "\n"


def find_pythons() -> dict[str, str]:
    """Supported CPython versions on PATH and of pyenv: "3.11" -> executable."""
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv"))
    folders = [*map(Path, os.environ["PATH"].split(os.pathsep)), *sorted(pyenv.glob("versions/*/bin"))]
    ask = "import sys, sysconfig; print(sys.implementation.name, sysconfig.get_config_var('Py_GIL_DISABLED') or 0, "
    ask += "'%d.%d' % sys.version_info[:2], sys.executable)"
    result, supported = {}, SpecifierSet(PROJECT["requires-python"])
    for path in dict.fromkeys(path for folder in folders for path in sorted(folder.glob("python3.[0-9]*"))):
        if re.fullmatch(r"python3\.\d+", path.name) and os.access(path, os.X_OK):
            done = subprocess.run([path, "-I", "-c", ask], capture_output=True, text=True, check=False)
            implementation, free, version, executable = [*done.stdout.strip().split(" ", 3), *[""] * 4][:4]
            if (implementation, free) == ("cpython", "0") and version in supported and ".venv" not in path.parts:
                result.setdefault(version, executable)
    return dict(sorted(result.items(), key=lambda item: Version(item[0])))


class Release:
    """The steps, their settings and their results."""

    def __init__(self, options: argparse.Namespace):
        self.options = options
        commit_time = ["git", "log", "-1", "--format=%ct"]
        seconds = os.environ.get("SOURCE_DATE_EPOCH") or subprocess.check_output(commit_time, cwd=ROOT, text=True)
        self.epoch = int(seconds)
        # A make of its own: ARGS are those of this target.
        passed = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MFLAGS", "ARGS")}
        self.environment = passed | {"SOURCE_DATE_EPOCH": str(self.epoch)}
        self.rows: list[str] = []
        self.has_failed = False

    def run(self, name: str, work: Callable[[Path], str]) -> bool:
        """Run a step with its log file, and print its row. Returns True if it passed."""
        print(f"{name} ...", flush=True)
        log, begin = LOGS / f"{name}.log", time.monotonic()
        log.write_text("")
        try:
            result, detail = "passed", work(log)
        except (StepError, OSError, subprocess.SubprocessError) as error:
            result, detail, self.has_failed = "failed", str(error), True
        self.rows.append(f"{name:<14} {result:<8} {time.monotonic() - begin:6.0f} s  {detail}")
        print(self.rows[-1], flush=True)
        return result == "passed"

    def call(self, log: Path, command: Sequence[str | Path], **settings: Any) -> str:
        """Run a command and append its output to the log. Returns the last line. Raises StepError."""
        done = subprocess.run(
            list(map(str, command)),
            **{"cwd": ROOT, "env": self.environment} | settings,
            text=True,
            errors="replace",
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            check=False,
        )
        with log.open("a") as file:
            file.write(f"$ {' '.join(map(str, command))}\n{done.stdout}")
        last = (done.stdout.strip().splitlines() or [""])[-1]
        if done.returncode:
            raise StepError(f"exit code {done.returncode}, {log.relative_to(ROOT)}: {last[:160]}")
        return last[:160]

    def check_tree(self, log: Path) -> str:
        """The tree has no changes, and the changelog starts with the version."""
        if changes := subprocess.check_output(["git", "status", "--porcelain"], cwd=ROOT, text=True):
            log.write_text(changes)
            raise StepError(f"expected a clean tree, got {len(changes.splitlines())} changed or new files")
        if count := len([*(ROOT / "changes").glob("*.*.md")]):
            raise StepError(f"expected all changes in CHANGELOG.md, got {count} in changes/. Run {PREPARE}")
        check_version((ROOT / "CHANGELOG.md").read_text(), VERSION)
        return f"{NAME} {VERSION}, {subprocess.check_output(['git', 'rev-parse', 'HEAD'], cwd=ROOT, text=True)[:12]}"

    def compare_api(self, log: Path) -> str:
        """Names that the newest earlier release had and this one has not are listed as **BREAKING**."""
        records = {Version(path.stem.removeprefix("api-")): path for path in (ROOT / "docs").glob("api-*.txt")}
        earlier = [version for version in records if version < Version(VERSION)]
        self.call(log, [sys.executable, "scripts/write_api.py", "--check"])
        current = ROOT / "docs/api.txt"
        if (record := records.get(Version(VERSION))) is None or record.read_text() != current.read_text():
            raise StepError(f"docs/api-{VERSION}.txt: expected a copy of docs/api.txt. Run {PREPARE}")
        if not earlier:
            return "docs/api.txt is current; no record of an earlier release"
        try:
            return self.call(log, [sys.executable, "scripts/write_api.py", "--compare", records[max(earlier)]])
        except StepError as error:
            if "**BREAKING**" not in changelog_section((ROOT / "CHANGELOG.md").read_text())[1]:
                raise StepError(f"{error}; CHANGELOG.md has no **BREAKING** line") from error
            return "removed or changed names, with a **BREAKING** line in CHANGELOG.md"

    def cpu_kernels(self, log: Path) -> str:
        """Compile the CPU kernels, unless those of these sources are there."""
        if subprocess.run([sys.executable, "-c", KERNELS_ARE_CURRENT], cwd=ROOT, check=False).returncode == 0:
            return "kernels/compiled is current"
        return self.call(log, [sys.executable, "-m", "pointloom.kernels.cpu_kernels"])

    def packages(self, log: Path) -> str:
        """Build sdist and wheel twice, and check that the bytes are equal."""
        DIST.mkdir(exist_ok=True)
        for path in [*DIST.glob(f"{NAME}-{VERSION}*"), DIST / "SHA256SUMS"]:
            path.unlink(missing_ok=True)
        with tempfile.TemporaryDirectory() as again:
            for folder in (DIST, again):
                command = [sys.executable, "-m", "hatchling", "build", "--target", "sdist", "--target", "wheel"]
                self.call(log, [*command, "--directory", folder])
            first, second = (checksums(Path(folder).glob(f"{NAME}-{VERSION}*")) for folder in (DIST, again))
        if first != second:
            raise StepError(f"two builds differ:\n{first}{second}")
        return "sdist and wheel, two builds equal"

    def cuda_kernels(self, log: Path) -> str:
        """Compile the CUDA kernels into a wheel."""
        return self.call(log, [sys.executable, "-m", "pointloom.kernels.cuda_cache"])

    def site(self, log: Path) -> str:
        """Build the site."""
        gallery = {} if self.options.gallery else {"POINTLOOM_GALLERY": "False"}
        self.call(log, ["make", "docs"], env=self.environment | gallery)
        return f"build/docs/html, gallery {'executed' if self.options.gallery else 'not executed'}"

    def install(self, log: Path, python: str, artifact: Path, folder: Path) -> Path:
        """Install an artifact in a fresh environment. Returns its interpreter."""
        shutil.rmtree(folder, ignore_errors=True)
        self.call(log, [python, "-m", "venv", folder])
        self.call(log, [folder / "bin/python", "-m", "pip", "install", "--no-cache-dir", artifact])
        return folder / "bin/python"

    def smoke(self, log: Path, python: Path) -> str:
        """Run scripts/smoke.py without network and with an empty, read-only home folder, which must stay empty."""
        unshare = ["unshare", "--map-root-user", "--net"] if shutil.which("unshare") else []
        if unshare and subprocess.run([*unshare, "true"], capture_output=True, check=False).returncode:
            unshare = []
        with tempfile.TemporaryDirectory() as temporary:
            home, work = Path(temporary, "home"), Path(temporary, "work")
            home.mkdir()
            work.mkdir()
            home.chmod(stat.S_IRUSR | stat.S_IXUSR)
            proxies = {name: CLOSED_PORT for name in ("http_proxy", "https_proxy", "HTTP_PROXY", "HTTPS_PROXY")}
            environment = {"HOME": str(home), "PATH": "/usr/bin:/bin", "TMPDIR": str(work), **proxies}
            last = self.call(log, [*unshare, python, "-I", ROOT / "scripts/smoke.py"], cwd=work, env=environment)
            if created := [path.name for path in home.iterdir()]:  # root may write anywhere
                raise StepError(f"expected an empty home folder, got {', '.join(created)}")
        return last + ("" if unshare else "; network: closed proxies only")

    def environments(self) -> list[Path]:
        """Install and check the artifacts in fresh environments. Returns the interpreters that have the wheel."""
        (wheel,), (sdist,) = DIST.glob(f"{NAME}-{VERSION}-*.whl"), DIST.glob(f"{NAME}-{VERSION}.tar.gz")
        pythons = find_pythons()
        made = []
        for index, (version, python) in enumerate(pythons.items()):
            for artifact in [wheel, sdist][: 2 if index == 0 else 1]:
                name = f"{version}-{'wheel' if artifact == wheel else 'sdist'}"

                def work(log: Path, python: str = python, artifact: Path = artifact, name: str = name) -> str:
                    inside = self.install(log, python, artifact, LOGS / "environments" / name)
                    return self.smoke(log, inside)

                if self.run(name, work) and artifact == wheel:
                    made.append(LOGS / "environments" / name / "bin/python")
        return made

    def records(self, log: Path, pythons: Sequence[Path]) -> str:
        """Write the SBOM, with the packages of the last environment, and SHA256SUMS."""
        if not pythons:
            raise StepError(f"expected a CPython {PROJECT['requires-python']} that runs the wheel, found none")
        (packages,) = pythons[-1].parents[1].glob("lib/python3*/site-packages")
        kernels = [] if self.options.without_cuda else DIST.glob(f"{NAME}_cuda_kernels-{VERSION}-*.whl")
        files = [*DIST.glob(f"{NAME}-{VERSION}-*.whl"), *DIST.glob(f"{NAME}-{VERSION}.tar.gz"), *kernels]
        bom = DIST / f"{NAME}-{VERSION}.cdx.json"
        bom.write_text(sbom(importlib.metadata.distributions(path=[str(packages)]), files, self.epoch))
        (DIST / "SHA256SUMS").write_text(checksums([*files, bom]))
        log.write_text((DIST / "SHA256SUMS").read_text())
        return f"{bom.name}, SHA256SUMS of {len(files) + 1} files"

    def all_steps(self) -> None:
        """Run the steps. A release without packages ends there."""
        steps = {"tree": self.check_tree, "api": self.compare_api, "cpu-kernels": self.cpu_kernels}
        for name, work in (steps | {"packages": self.packages}).items():
            if not self.run(name, work):
                return
        if self.options.without_cuda:
            self.rows.append(
                "cuda-kernels   left out (--without-cuda): dist/ has no wheel of CUDA kernels of this build"
            )
        else:
            self.run("cuda-kernels", self.cuda_kernels)
        self.run("site", self.site)
        made = self.environments()
        self.run("records", lambda log: self.records(log, made))


def main() -> int:
    """Run the steps and print the table; returns the exit code."""
    parser = argparse.ArgumentParser(prog="make release", description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--without-cuda", action="store_true", help="leave out the wheel of CUDA kernels")
    parser.add_argument("--gallery", action="store_true", help="run the gallery of the site")
    parser.add_argument("--prepare", metavar="VERSION", help="write the files of a version, and end")
    options = parser.parse_args()
    if options.prepare:
        prepare(options.prepare, datetime.now(UTC).date().isoformat())
        return 0
    LOGS.mkdir(parents=True, exist_ok=True)
    release = Release(options)
    release.all_steps()
    print("\n".join(["", *release.rows]))
    return int(release.has_failed)


if __name__ == "__main__":
    sys.exit(main())
