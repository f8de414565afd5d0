"""Parts of `make release`: version check, checksums, SBOM, the comparison of public names, sdist and conda recipe."""

import hashlib
import importlib.metadata
import json
import re
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile

import pytest
from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet

from .programs import ROOT, script

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
release, write_api = script("release"), script("write_api")


def test_the_first_section_of_the_changelog_must_be_the_dated_version():
    text = "# Changelog\n\n## 0.2.0 (2027-01-31)\n\n**BREAKING** no\n\n## 0.1.0 (2026-11-26)\n\nfirst\n"
    release.check_version(text, "0.2.0")
    assert release.changelog_section(text) == ("0.2.0 (2027-01-31)", "\n\n**BREAKING** no\n\n")
    with pytest.raises(release.StepError, match=r"expected the first heading '0.1.0 \(YYYY-MM-DD\)', got '0.2.0"):
        release.check_version(text, "0.1.0")
    for heading in ("Unreleased (0.2.0)", "0.2.0", "0x2y0 (2027-01-31)"):
        with pytest.raises(release.StepError):
            release.check_version(f"# Changelog\n\n## {heading}\n", "0.2.0")


def test_all_files_state_the_version_of_the_project():
    pattern = rf"(?:version[_\W]+|pointloom ){re.escape(PROJECT['version'])}\b"
    assert [name for name in release.STATE_VERSION if not re.search(pattern, (ROOT / name).read_text())] == []
    released = re.search(r"^date-released: (.+)$", (ROOT / "CITATION.cff").read_text(), re.MULTILINE)[1]
    assert f"\n## {PROJECT['version']} ({released})\n" in (ROOT / "CHANGELOG.md").read_text()


@pytest.mark.slow  # `make test` has no towncrier
def test_a_prepared_version_is_in_all_files_that_state_it(tmp_path):
    pytest.importorskip("towncrier")
    for name in (*release.STATE_VERSION, "docs/api.txt", "changes/template.md"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, tmp_path / name)
    marker = "<!-- towncrier release notes start -->\n"
    assert (ROOT / "CHANGELOG.md").read_text().count(f"\n{marker}\n") == 1
    (tmp_path / "CHANGELOG.md").write_text(f"# Changelog\n\n{marker}\n## Unreleased\n\n- C.\n\n## 0.1.0 (2026-11-26)\n")
    for name, text in {"b-c.added": "Add b\nand c.\n", "a.fixed": "Fix a.", "d.breaking": "Use d."}.items():
        (tmp_path / f"changes/{name}.md").write_text(text)
    release.prepare("9.8.0", "2027-01-31", tmp_path)
    text = (tmp_path / "CHANGELOG.md").read_text()
    entries = {"**BREAKING**": "Use d.", "Added": "Add b\n  and c.", "Fixed": "Fix a.", "Other changes": "C."}
    section = "".join(f"### {title}\n\n- {entry}\n\n" for title, entry in entries.items())
    assert text.partition(marker)[2] == f"\n## 9.8.0 (2027-01-31)\n\n{section}## 0.1.0 (2026-11-26)\n"
    release.check_version(text, "9.8.0")
    assert [path.name for path in (tmp_path / "changes").iterdir()] == ["template.md"]
    assert (tmp_path / "docs/api-9.8.0.txt").read_text() == (ROOT / "docs/api.txt").read_text()
    for name in release.STATE_VERSION:
        before, after = ((folder / name).read_text().splitlines() for folder in (ROOT, tmp_path))
        changed = [new for old, new in zip(before, after, strict=True) if new != old]
        assert sum("9.8.0" in line for line in changed) == 1, name
    assert "date-released: 2027-01-31\n" in (tmp_path / "CITATION.cff").read_text()
    with pytest.raises(release.StepError, match=r"pyproject.toml: expected the version .*, found none"):
        release.prepare("9.9.0", "2027-02-28", tmp_path)


def test_checksums_are_sorted_and_can_be_checked(tmp_path):
    for name, content in {"b.whl": b"wheel", "a.tar.gz": b"archive"}.items():
        (tmp_path / name).write_bytes(content)
    text = release.checksums(tmp_path.iterdir())
    sums = (hashlib.sha256(content).hexdigest() for content in (b"archive", b"wheel"))
    assert text == "{}  a.tar.gz\n{}  b.whl\n".format(*sums)
    (tmp_path / "SHA256SUMS").write_text(text)
    subprocess.run(["sha256sum", "--check", "--strict", "SHA256SUMS"], cwd=tmp_path, check=True, capture_output=True)


@pytest.fixture
def packages(tmp_path):
    """An environment: the project, two packages that it needs, and one that it does not need."""
    texts = {
        "pointloom": "Version: 0.1.0\nLicense-Expression: Apache-2.0\nRequires-Dist: numpy>=1\n"
        "Requires-Dist: Rich; python_version > '3'\nRequires-Dist: laspy; extra == 'las'\n",
        "numpy": "Version: 2.4.6\nLicense: BSD\n",
        "Rich": "Version: 14.3\nLicense: a long\n   text\nClassifier: License :: OSI Approved :: MIT License\n"
        "Requires-Dist: numpy\n",
        "pip": "Version: 26\n",
    }
    for name, text in texts.items():
        folder = tmp_path / f"{name}-0.dist-info"
        folder.mkdir()
        (folder / "METADATA").write_text(f"Metadata-Version: 2.4\nName: {name}\n{text}")
    return lambda: importlib.metadata.distributions(path=[str(tmp_path)])


def test_the_sbom_lists_resolved_versions_licenses_and_hashes(packages, tmp_path):
    wheel = tmp_path / "pointloom.whl"
    wheel.write_bytes(b"wheel")
    text = release.sbom(packages(), [wheel], 86_400)
    content = json.loads(text)
    assert (content["bomFormat"], content["specVersion"], content["version"]) == ("CycloneDX", "1.6", 1)
    assert content["metadata"]["timestamp"] == "1970-01-02T00:00:00Z"
    assert content["metadata"]["component"]["licenses"] == [{"expression": "Apache-2.0"}]
    hashes = [{"alg": "SHA-256", "content": hashlib.sha256(b"wheel").hexdigest()}]
    assert content["components"] == [
        {
            **{"type": "library", "bom-ref": f"pkg:pypi/{name}@{version}", "name": name, "version": version},
            **{"purl": f"pkg:pypi/{name}@{version}", "licenses": [{"license": {"name": license_name}}]},
        }
        for name, version, license_name in (("numpy", "2.4.6", "BSD"), ("rich", "14.3", "MIT License"))
    ] + [{"type": "file", "name": "pointloom.whl", "hashes": hashes}]
    assert {each["ref"]: each["dependsOn"] for each in content["dependencies"]} == {
        "pkg:pypi/numpy@2.4.6": [],
        "pkg:pypi/pointloom@0.1.0": ["pkg:pypi/numpy@2.4.6", "pkg:pypi/rich@14.3"],
        "pkg:pypi/rich@14.3": ["pkg:pypi/numpy@2.4.6"],
    }
    assert re.fullmatch(r"urn:uuid:[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}", content["serialNumber"])
    assert release.sbom(packages(), [wheel], 86_400) == text  # no time, no random number
    wheel.write_bytes(b"another wheel")
    assert json.loads(release.sbom(packages(), [wheel], 86_400))["serialNumber"] != content["serialNumber"]


def test_the_comparison_of_public_names_reports_what_breaks_callers():
    earlier = "loom\n    LIMIT\n    class A(x)\n        go(self)\n        old(self)\n    f(a, b=1)\n    g()\n"
    earlier += "    h(a)\n    k(a)\n"
    current = "loom\n    class A(x, y)\n        go(self, n=2)\n    f(b=1, a=2)\n    g(a=1)\n"
    current += "    h(a, *, b=1)\n    k(a, *, b)\n    new()\n"
    earlier, current = (f"4 names\n\n{names}" for names in (earlier, current))
    assert list(write_api.breaking(earlier, current)) == [
        "removed: loom.LIMIT",
        "changed: loom.A(x) -> loom.A(x, y)",
        "removed: loom.A.old(self)",
        "changed: loom.f(a, b=1) -> loom.f(b=1, a=2)",
        "changed: loom.k(a) -> loom.k(a, *, b)",
    ]
    assert list(write_api.breaking(current, current)) == []
    names = write_api.entries((ROOT / "docs/api.txt").read_text())
    assert "loom.PointCloud.voxel_down_sample" in names and "loom.registration.registration_icp" in names


@pytest.mark.slow
def test_the_sdist_builds_the_same_wheel_as_the_tree(tmp_path):
    """The four linked packages are in it, too."""
    build = [sys.executable, "-m", "hatchling", "build", "--directory", str(tmp_path), "--target"]
    subprocess.run([*build, "sdist"], cwd=ROOT, check=True, capture_output=True, timeout=300)
    subprocess.run([*build, "wheel"], cwd=ROOT, check=True, capture_output=True, timeout=300)
    (wheel,), (sdist,) = tmp_path.glob("*.whl"), tmp_path.glob("*.tar.gz")
    expected = wheel.rename(tmp_path / "expected.zip")
    with tarfile.open(sdist) as archive:
        archive.extractall(tmp_path, filter="data")
    folder = tmp_path / sdist.name.removesuffix(".tar.gz")
    subprocess.run([*build, "wheel"], cwd=folder, check=True, capture_output=True, timeout=300)
    shutil.rmtree(folder)
    with zipfile.ZipFile(wheel) as built, zipfile.ZipFile(expected) as archive:
        contents, wanted = ({each.filename: each.CRC for each in file.infolist()} for file in (built, archive))
        assert contents == wanted


def test_the_conda_recipe_has_the_version_and_the_requirements_of_the_project():
    text = (ROOT / "recipe/recipe.yaml").read_text()
    assert re.search(r'^  version: "(.+)"$', text, re.MULTILINE)[1] == PROJECT["version"]
    python_min = re.search(r'^  python_min: "(.+)"$', text, re.MULTILINE)[1]
    section = text.partition("\n  run:\n")[2].partition("\n\n")[0].replace("${{ python_min }}", python_min)
    listed = [line.strip().removeprefix("- ") for line in section.splitlines()]
    assert listed.pop(0) == "__linux"
    needs = {name: SpecifierSet(limits) for name, _, limits in (line.partition(" ") for line in listed)}
    assert needs.pop("python") == SpecifierSet(PROJECT["requires-python"])
    wanted = [Requirement(text) for text in PROJECT["dependencies"]]
    assert needs == {each.name.lower(): each.specifier for each in wanted}
    hatchling = tomllib.loads((ROOT / "pyproject.toml").read_text())["build-system"]["requires"][0]
    assert f"    - {hatchling.replace('>=', ' >=')}\n" in text
    (command,) = PROJECT["scripts"].items()
    assert f"      - {' = '.join(command)}\n" in text
    assert f'"{PROJECT["description"]}"' in text and f"license: {PROJECT['license']}" in text
