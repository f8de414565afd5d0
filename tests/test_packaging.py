"""Wheels contain exactly the tree, under pointloom/ alone; pins satisfy pyproject.toml."""

import email.parser
import importlib.metadata
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet
from packaging.utils import canonicalize_name
from packaging.version import Version

from pointloom.cli.shell import doctor
from pointloom.kernels.language import warp_parts

from .programs import ROOT, script

PACKAGE = ROOT / "src" / "pointloom"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
DIST_INFO = f"pointloom-{PROJECT['project']['version']}.dist-info"

# Addresses of package registries, in two parts each so that this file contains none.
REGISTRIES = [
    *(f"{name}.org" for name in ("pypi", "pypi.python", "python" + "hosted", "download.pytorch")),
    *(f"{name}.org" for name in ("anaconda", "registry.npmjs")),
    *(f"{name}.com" for name in ("anaconda", "registry.yarnpkg", "pypi.nvidia")),
]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The wheel, built by the backend itself: no network, no build environment."""
    folder = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", str(folder)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True, timeout=120)
    (path,) = folder.glob("*.whl")
    with zipfile.ZipFile(path) as archive:
        yield archive


def modules_of_the_tree() -> set[str]:
    return {path.relative_to(PACKAGE.parent).as_posix() for path in PACKAGE.rglob("*.py")}


def test_the_wheel_contains_every_module(wheel):
    assert {name for name in wheel.namelist() if name.endswith(".py")} == modules_of_the_tree()


def test_the_wheel_contains_the_browser_scripts_styles_and_pages(wheel):
    paths = [path for path in (PACKAGE / "visualization/page").rglob("*") if path.suffix in {".js", ".css", ".html"}]
    assert len(paths) > 20
    assert {f"pointloom/{path.relative_to(PACKAGE).as_posix()}" for path in paths} <= set(wheel.namelist())


def test_the_wheel_contains_nothing_outside_the_package(wheel):
    data = DIST_INFO.replace(".dist-info", ".data")
    assert {name.split("/")[0] for name in wheel.namelist()} == {"pointloom", DIST_INFO, data}
    assert [name for name in wheel.namelist() if name.startswith(data)] == [f"{data}/data/share/man/man1/pointloom.1"]
    assert f"{DIST_INFO}/licenses/LICENSE" in wheel.namelist()


def test_every_file_of_the_package_in_the_wheel_is_in_the_tree(wheel):
    inside = [name.partition("/")[2] for name in wheel.namelist() if name.startswith("pointloom/")]
    assert [name for name in inside if not (PACKAGE / name).is_file()] == []


def test_the_wheel_contains_types_colormaps_the_font_with_its_license_and_the_assistant_guide_with_its_chapters(wheel):
    types = ("py.typed", "__init__.pyi", "registration/__init__.pyi")
    font = ("visualization/render/glyphs.npz", "visualization/render/glyphs.md", "visualization/render/colormaps.txt")
    files = (*types, *font, "cli/shell/SKILL.md", "cli/shell/chapters.toml")
    assert {f"pointloom/{name}" for name in files} <= set(wheel.namelist())


def test_the_wheel_names_its_version_and_its_command(wheel, metadata):
    import pointloom

    assert (metadata["Name"], metadata["Version"]) == ("pointloom", pointloom.__version__)
    assert "pointloom = pointloom.__main__:main" in wheel.read(f"{DIST_INFO}/entry_points.txt").decode()


@pytest.fixture(scope="module")
def metadata(wheel):
    return email.parser.Parser().parsestr(wheel.read(f"{DIST_INFO}/METADATA").decode())


@pytest.fixture(scope="module")
def package_metadata():
    return script("package_metadata")


def test_the_package_readme_has_absolute_links(metadata, package_metadata):
    settings = PROJECT["tool"]["hatch"]["metadata"]["hooks"]["custom"]
    readme = (ROOT / "README.md").read_text()
    expected = package_metadata.absolute_links(readme, settings["repository"], settings["branch"])
    assert metadata.get_payload().strip() == expected.strip()
    urls = package_metadata.project_urls(**{key: settings[key] for key in package_metadata.ADDRESSES})
    assert metadata.get_all("Project-URL", []) == [f"{name}, {address}" for name, address in urls.items()]


def test_an_address_makes_every_link_of_the_readme_absolute(package_metadata):
    readme = (ROOT / "README.md").read_text()
    links = re.findall(r"\]\(([^)\s]+)\)", readme)
    assert len(links) > 5 and not all(link.startswith("https:") for link in links)
    assert package_metadata.absolute_links(readme, "", "main") == readme
    text = package_metadata.absolute_links(readme, "https://host.test/owner/pointloom/", "main")
    for relative, link in zip(links, re.findall(r"\]\(([^)\s]+)\)", text), strict=True):
        if relative.startswith("https:"):
            assert link == relative
            continue
        kind = "raw" if relative.endswith((".png", ".jpg")) else "blob"
        assert link == f"https://host.test/owner/pointloom/{kind}/main/{relative}"
        assert (ROOT / relative.partition("#")[0]).exists()
    urls = package_metadata.project_urls("https://host.test/owner/pointloom/", "main")
    assert urls["Repository"] == "https://host.test/owner/pointloom"
    assert urls["Changelog"] == "https://host.test/owner/pointloom/blob/main/CHANGELOG.md"
    assert urls["Documentation"] == "https://host.test/owner/pointloom/blob/main/docs/README.md"
    urls = package_metadata.project_urls("https://host.test/owner/pointloom", "main", "https://docs.test")
    assert urls["Documentation"] == "https://docs.test/stable/"
    assert package_metadata.project_urls("", "main", issues="https://tracker.test") == {}


def test_the_tracker_and_the_security_contact_are_urls_of_the_package_if_set(package_metadata):
    urls = package_metadata.project_urls("https://host.test/owner/pointloom", "main")
    assert urls["Issues"] == "https://host.test/owner/pointloom/issues" and "Security" not in urls
    contacts = {"issues": "https://tracker.test/pointloom", "security": "mailto:security@host.test"}
    urls = package_metadata.project_urls("https://host.test/owner/pointloom", "main", **contacts)
    assert (urls["Issues"], urls["Security"]) == tuple(contacts.values())


@pytest.mark.parametrize("page", ["README.md", "docs/index.md", "docs/install.md"])
def test_the_first_command_of_a_page_clones_the_repository(page, package_metadata):
    text = (ROOT / page).read_text()
    first = text.partition("```sh\n")[2].splitlines()[:2]
    assert first[0].startswith("git clone REPOSITORY pointloom") and first[1].startswith("make demo")
    address = "https://host.test/owner/pointloom"
    lines = package_metadata.with_address(text, address).partition("```sh\n")[2].splitlines()
    assert lines[0] == f"git clone {address} pointloom && cd pointloom"
    assert package_metadata.with_address(text, "") == text


@pytest.mark.parametrize("page", ["README.md", "CONTRIBUTING.md", "docs/install.md"])
def test_a_page_states_the_versions_of_python_that_make_accepts(page):
    program = (ROOT / "scripts" / "find_python.sh").read_text()
    first, end = re.findall(r"\(3, (\d+)\) <= sys\.version_info < \(3, (\d+)\)", program)[0]
    assert f"Python 3.{first} to 3.{int(end) - 1}" in (ROOT / page).read_text()


INDEX_INSTALL = re.compile(r"""pip install (?:-\S+ )*["']?pointloom(?!\[)""")


def test_no_page_and_no_message_promises_a_package_index():
    """Nothing is published. Extras are installed beside an installed pointloom, which pip finds."""
    texts = [*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md"), *(ROOT / "docs" / "examples").rglob("*.*")]
    texts += [path for path in PACKAGE.rglob("*") if path.suffix in {".py", ".pyi", ".md", ".toml", ".html"}]
    assert INDEX_INSTALL.search("pip install -U pointloom") and not INDEX_INSTALL.search('pip install "pointloom[las]"')
    assert [path for path in texts if path.suffix != ".png" and INDEX_INSTALL.search(path.read_text())] == []


def test_the_table_of_extras_lists_those_of_the_package():
    section = (ROOT / "docs" / "install.md").read_text().partition("## Extras\n")[2].partition("\n## ")[0]
    rows = [line.split("|")[1] for line in section.splitlines() if line.startswith("| `")]
    assert sorted(re.findall(r"`([\w-]+)`", "".join(rows))) == sorted(PROJECT["project"]["optional-dependencies"])


def test_the_package_contains_no_links():
    assert [path for path in PACKAGE.rglob("*") if path.is_symlink()] == []


def test_the_links_at_the_top_name_four_packages():
    """A checkout without symbolic links has text files instead, with the same content."""
    for name in ("kernels", "pcd", "registration", "meshing"):
        path = ROOT / name
        content = str(path.readlink()) if path.is_symlink() else path.read_text()
        assert content == f"src/pointloom/{name}" and (PACKAGE / name / "__init__.py").is_file()


def test_the_root_contains_only_files_that_belong_there():
    """Another name is of a file that a program left there, or of a new part of the project."""
    assert {path.relative_to(ROOT).parts[0] for path in tracked_files()} <= {
        ".ci", ".github", ".gitignore", ".pre-commit-config.yaml", "CHANGELOG.md", "CITATION.cff", "CONTRIBUTING.md",
        "LICENSE", "Makefile", "README.md", "SECURITY.md", "benchmarks", "changes", "constraints", "docs", "kernels",
        "meshing", "pcd", "pyproject.toml", "recipe", "registration", "scripts", "src", "tests", "typings",
    }  # fmt: skip


def tracked_files() -> list[Path]:
    if not (ROOT / ".git").exists() or shutil.which("git") is None:
        pytest.skip("no git checkout, so no list of tracked files")
    listing = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=False, capture_output=True)
    if listing.returncode:  # such as a checkout that belongs to another user
        pytest.skip(f"git does not list the tracked files: {listing.stderr.decode().splitlines()[0]}")
    paths = [ROOT / name.decode() for name in listing.stdout.split(b"\0") if name]
    return [path for path in paths if path.is_file() and not path.is_symlink()]


def test_no_tracked_file_contains_a_registry_address():
    pattern = re.compile("|".join(map(re.escape, REGISTRIES)).encode())
    files = tracked_files()
    matches = [path.relative_to(ROOT).as_posix() for path in files if pattern.search(path.read_bytes().lower())]
    assert len(files) > 10
    assert matches == []


def constraints(layer: str) -> dict[str, tuple[str, list[str]]]:
    """The pins of a constraints file and of those that it builds on: name -> version, hashes."""
    text = (ROOT / "constraints" / f"{layer}.txt").read_text().replace("\\\n", "")
    pins = {}
    for line in text.splitlines():
        if line.startswith("-r "):
            pins |= constraints(line.removeprefix("-r ").removesuffix(".txt"))
        elif line and not line.startswith("#"):
            # a line is: name==version [; marker] --hash=sha256:... and nothing else
            match = re.fullmatch(r"([\w.-]+)==(\S+)( ; [^-]+)?((?:\s+--hash=sha256:[0-9a-f]{64})+)", line)
            assert match, f"constraints/{layer}.txt: {line}"
            assert canonicalize_name(match[1]) not in pins, f"constraints/{layer}.txt pins {match[1]} twice"
            pins[canonicalize_name(match[1])] = match[2], match[4].split()
    return pins


FULL = ["test", "oracle", "lint", "docs"]
LAYERS = {"runtime": [], "test": ["test"], "full": FULL, "bench": [*FULL, "bench"]}


def wanted(layer: str) -> list[Requirement]:
    """The requirements of a layer of pyproject.toml and of those below it."""
    listed = [*PROJECT["project"]["dependencies"], *PROJECT["build-system"]["requires"]]
    listed += [requirement for group in LAYERS[layer] for requirement in PROJECT["dependency-groups"][group]]
    return [Requirement(text) for text in listed]


@pytest.mark.parametrize("layer", LAYERS)
def test_the_constraints_pin_every_dependency_within_its_bounds(layer):
    pins = constraints(layer)
    for requirement in wanted(layer):
        version, hashes = pins[canonicalize_name(requirement.name)]
        assert requirement.specifier.contains(version), f"{requirement} is pinned at {version}"
        assert hashes


def test_the_newest_tested_versions_are_those_of_the_constraints():
    pins = constraints("runtime")
    assert {name: Version(pins[name][0]).release[:2] for name in doctor._TESTED_VERSIONS} == doctor._TESTED_VERSIONS
    assert warp_parts.TESTED[-1] == pins["warp-lang"][0]


def needs_of(requirement: Requirement) -> list[Requirement]:
    """The requirements of an installed package here, by its metadata and the requested extras."""
    try:
        listed = importlib.metadata.requires(requirement.name) or []
    except importlib.metadata.PackageNotFoundError:
        return []
    extras = [{"extra": extra} for extra in ("", *requirement.extras)]
    return [need for need in map(Requirement, listed) if need.marker is None or any(map(need.marker.evaluate, extras))]


@pytest.mark.parametrize("layer", LAYERS)
def test_the_constraints_leave_out_nothing_that_their_packages_need(layer):
    """They are installed without a resolver, so what they do not list is not there."""
    pins, queue, visited = constraints(layer), wanted(layer), set()
    while queue:
        requirement = queue.pop()
        if str(requirement) in visited or not (requirement.marker is None or requirement.marker.evaluate()):
            continue
        visited.add(str(requirement))
        name = canonicalize_name(requirement.name)
        assert name in pins, f"constraints/{layer}.txt lacks {requirement}"
        assert requirement.specifier.contains(pins[name][0]), f"{requirement} is pinned at {pins[name][0]}"
        queue += needs_of(requirement)


def test_the_table_of_platforms_lists_each_system_and_tested_python():
    platforms = script("check_platforms")
    table = platforms.read_table((ROOT / "docs" / "install.md").read_text(encoding="utf-8"))
    assert set(table) == {(platform, python) for platform in platforms.PLATFORMS for python in platforms.PYTHONS}
    assert set(table.values()) == platforms.AVAILABLE | platforms.MISSING
    classifiers = [text.rpartition(" ")[2] for text in PROJECT["project"]["classifiers"] if "Python ::" in text]
    assert classifiers == [python for _, python in table if table[_, python] == "tested"]


def test_new_versions_of_python_are_not_rejected():
    supported = SpecifierSet(PROJECT["project"]["requires-python"])
    assert [python for python in ("3.10", "3.11", "3.15", "3.99", "4.0") if python in supported] == [
        *("3.11", "3.15", "3.99", "4.0")
    ]


@pytest.mark.parametrize("problem", ["", "no wheel"])
def test_a_wrong_table_of_platforms_is_an_error(problem, monkeypatch, capsys):
    platforms = script("check_platforms")
    monkeypatch.setattr(platforms, "problem_of", lambda platform, python: problem)
    assert platforms.main() == 1
    lines = capsys.readouterr().out.splitlines()[1 + len(platforms.PLATFORMS) :]
    expected = 28 if problem else 7  # macOS on x86-64 has no wheel
    assert len(lines) == expected and all(f"but pip: {problem or 'resolves'}" in line for line in lines)


def test_dependencies_of_another_system_are_resolved_too(monkeypatch):
    """pip compares markers and the limits of Python with its own system and Python."""
    platforms, calls = script("check_platforms"), []
    new = {"name": "A", "version": "2", "requires_python": ">=3.12"}
    old = {"name": "A", "version": "1", "requires_dist": ["B>=1; sys_platform == 'win32'", "C; extra == 'all'"]}

    def resolve(wanted, tags, python):
        calls.append(wanted[len(platforms.DEPENDENCIES) :])
        return [old if "A!=2" in wanted else new, *([{"name": "b", "version": "1"}] if "B>=1" in wanted else [])], ""

    monkeypatch.setattr(platforms, "resolve", resolve)
    assert platforms.problem_of("Windows x86-64", "3.11t") == ""
    assert calls[-1] == ["A!=2", "B>=1"]
    assert platforms.problem_of("macOS 12, arm64", "3.11") == "" and calls[-1] == ["A!=2"]
    assert platforms.problem_of("macOS 12, arm64", "3.12") == "" and calls[-1] == []
