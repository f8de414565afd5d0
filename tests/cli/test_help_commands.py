"""Help for the commands: tab completion, chapters, the man page and the guide for assistants."""

import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
from types import SimpleNamespace

import pytest

import pointloom as loom
from pointloom.cli.shell import chapters as book
from pointloom.cli.shell.cli import cli
from pointloom.cli.shell.completion import SHELLS, complete_path
from pointloom.cli.shell.help_commands import VARIABLE

from ..test_imports import ROOT
from .commands import run


def completed(words: str, shell: str = "bash") -> list[tuple[str, str]]:
    given = words.split(" ")
    complete = SHELLS[shell](cli, {}, "pointloom", VARIABLE)
    return [(item.type, item.value) for item in complete.get_completions(given[1:-1], given[-1])]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scans").mkdir()
    for name in ("scan.ply", "scan.LAZ", "notes.md", "poses.log", "camera.json", ".hidden.ply", "scans/a.ply"):
        (tmp_path / name).touch()
    return tmp_path


def test_commands_options_and_choices_are_completed(folder):
    assert completed("pointloom cle") == [("plain", "clean"), ("plain", "clean-mesh")]
    assert ("plain", "--device") in completed("pointloom clean --de")
    assert completed("pointloom completion z") == [("plain", "zsh")]
    assert completed("pointloom normals --max-") == []  # an earlier name


def test_files_are_completed_by_type(folder):
    assert completed("pointloom clean ") == [("path", "scan.LAZ"), ("path", "scan.ply"), ("path", "scans/")]
    assert completed("pointloom clean scans/") == [("path", "scans/a.ply")]
    assert completed("pointloom evaluate p") == [("path", "poses.log")]
    assert completed("pointloom fuse scans --intrinsic c") == [("path", "camera.json")]
    assert completed("pointloom multiway ") == [("path", "scans/")]
    assert completed("pointloom info n") == [("file", "n")]  # of any kind: the shell's own
    assert completed("pointloom clean notes") == [("file", "notes")]
    assert [item.value for item in complete_path("IN", "./sc")] == ["./scan.LAZ", "./scan.ply", "./scans/"]


@pytest.mark.parametrize("shell", SHELLS)
def test_each_shell_gets_a_script_that_completes_files(shell, monkeypatch):
    result = run("completion", shell)
    assert result.exit_code == 0 and f"{VARIABLE}={shell}_complete" in result.stdout and "path" in result.stdout
    monkeypatch.setenv("SHELL", f"/usr/bin/{shell}")
    assert run("completion").stdout == result.stdout
    monkeypatch.setenv("SHELL", "/bin/sh")
    assert run("completion").exit_code == 2


@pytest.mark.slow
def test_bash_itself_completes(folder):
    """Call the completion function as bash does; it runs the command."""
    bash = shutil.which("bash") or pytest.skip("no bash")
    command = folder / "pointloom"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m pointloom "$@"\n')
    command.chmod(0o755)
    script = run("completion", "bash").stdout
    script += "COMP_WORDS=(pointloom clean s); COMP_CWORD=2; _pointloom_completion pointloom 2>&1\n"
    script += 'printf "%s\\n" "${COMPREPLY[@]}"'
    environment = os.environ | {"PATH": f"{folder}:{os.environ['PATH']}", "PYTHONPATH": str(ROOT / "src")}
    result = subprocess.run([bash, "-c", script], capture_output=True, text=True, env=environment, timeout=300)
    words = [line for line in result.stdout.splitlines() if "compopt" not in line]
    assert words == ["scan.LAZ", "scan.ply", "scans"], result


def test_the_chapters_name_existing_commands_and_functions():
    numbers = [chapter.number for chapter in book.chapters()]
    assert numbers == list(range(1, 16))
    for chapter in book.chapters():
        assert set(chapter.commands) <= set(cli.commands), chapter.title
        for name in chapter.names:
            owner = loom
            for part in name.split("."):
                owner = getattr(owner, part)
    scripts = ROOT / "docs/examples/chapters"
    written = sorted(path.stem.removeprefix("plot_") for path in scripts.glob("plot_*.py"))
    assert not written or set(written) <= {chapter.slug for chapter in book.chapters()}


def test_docs_searches_chapters_by_words_and_numbers():
    assert run("docs").stdout.splitlines()[6] == " 7  ICP: bring two clouds together"
    icp = run("docs", "icp").stdout
    assert "loom.registration.registration_icp" in icp and "pointloom register" in icp and "Poisson" not in icp
    report = json.loads(run("docs", "POISSON", "density", "--json").stdout)
    assert [row["number"] for row in report["chapters"]] == [11]
    assert [row["number"] for row in json.loads(run("docs", "3", "--json").stdout)["chapters"]] == [3]
    nothing = run("docs", "elephants")
    assert nothing.exit_code == 2 and "no chapter contains elephants; the chapters are 1 Read a cloud" in nothing.stderr


def test_docs_reports_the_pages_or_their_absence(tmp_path, monkeypatch):
    monkeypatch.setattr(book, "CHECKOUT", tmp_path)
    monkeypatch.setattr(book.importlib.metadata, "metadata", lambda _: SimpleNamespace(get_all=lambda name: None))
    assert "No built pages" in run("docs").stdout
    refused = run("docs", "icp", "--open")
    assert refused.exit_code == 2 and "no page to open" in refused.stderr
    built = tmp_path / "build/docs/html"
    built.mkdir(parents=True)
    (built / "index.html").touch()
    opened = []
    monkeypatch.setattr("click.launch", opened.append)
    assert f"{built.as_uri()}/chapters/plot_07_icp.html" in run("docs", "icp", "--open").stdout
    assert opened == [f"{built.as_uri()}/chapters/plot_07_icp.html"]


def test_the_guide_for_assistants_is_printed_unchanged():
    text = run("docs", "--skill").stdout
    assert text == (ROOT / "src/pointloom/cli/shell/SKILL.md").read_text()
    head = text.split("---")[1]
    assert "name: pointloom" in head and "description: " in head
    assert len(re.findall(r"^\d+\. \*\*", text, flags=re.MULTILINE)) == 10
    assert run("docs", "icp", "--skill").exit_code == 2


def test_groff_reports_no_error_in_the_man_page():
    groff = shutil.which("groff") or pytest.skip("no groff")
    command = [groff, "-man", "-Tutf8", "-ww", "-z", str(ROOT / "docs/pointloom.1")]
    result = subprocess.run(command, capture_output=True, timeout=60)
    assert (result.returncode, result.stderr) == (0, b"")


def test_the_man_page_matches_the_commands():
    spec = importlib.util.spec_from_file_location("write_man_page", ROOT / "scripts" / "write_man_page.py")
    writer = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(writer)
    page = writer.man_page()
    assert (ROOT / "docs/pointloom.1").read_text() == page, "run scripts/write_man_page.py"
    assert [name for name in cli.commands if f'.SS "{writer.escaped(name)}"' not in page] == []
    options = [option for command in cli.commands.values() for one in command.params for option in one.opts]
    long = [option for option in options if option.startswith("--")]
    assert len(long) > 100 and [option for option in long if writer.escaped(option) not in page] == []
    installed = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["hatch"]["build"]["targets"]["wheel"]
    assert installed["shared-data"] == {"docs/pointloom.1": "share/man/man1/pointloom.1"}
    assert writer.escaped(".ply a-b\n'x\\") == "\\&.ply a\\-b\n\\&'x\\e"
