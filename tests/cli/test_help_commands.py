"""Help for the commands: completion, chapters, the man page, and messages for invalid calls."""

import json
import math
import os
import re
import shutil
import subprocess
import sys
import tomllib
from types import SimpleNamespace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.cli.shell import chapters as book
from pointloom.cli.shell.cli import cli
from pointloom.cli.shell.completion import SHELLS, complete_path
from pointloom.cli.shell.help_commands import VARIABLE
from pointloom.core.wording import format_fraction

from ..programs import ROOT, script
from .commands import names_in, run


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
    assert run("docs").stdout.splitlines()[6] == " 7  ICP: align two point clouds"
    icp = run("docs", "icp").stdout
    assert "loom.registration.registration_icp" in icp and "pointloom register" in icp and "Poisson" not in icp
    report = json.loads(run("docs", "POISSON", "density", "--json").stdout)
    assert [row["number"] for row in report["chapters"]] == [11]
    assert [row["number"] for row in json.loads(run("docs", "3", "--json").stdout)["chapters"]] == [3]
    nothing = run("docs", "elephants")
    assert (
        nothing.exit_code == 2
        and "public name contains elephants; the chapters are 1 Read a point cloud" in nothing.stderr
    )


WANTED = {
    "ground": "classify_ground", "stations": "register_stations", "change": "m3c2", "bag": "open_recording",
    "dtm": "rasterize", "e57": "read_", "volume cut": "m3c2", "gaussian": "GaussianSplats", "trimesh": "from_any",
    "farthest": "loom.torch", "LAS": "read_point_cloud", "gps": "LidarSLAM", "jacobian": "loom.torch",
    "export contours": "pointloom ground, pointloom dtm, pointloom contours", "voxel grid origin": "tiling.",
}  # fmt: skip


@pytest.mark.parametrize("words", WANTED)
def test_docs_finds_guides_and_public_names(words):
    assert WANTED[words] in run("docs", *words.split()).stdout


def test_every_command_is_found_under_a_topic():
    found = {command for entry in (*book.chapters(), *book.guides()) for command in entry.commands}
    assert set(cli.commands) - found == {"completion", "docs"}


def test_short_words_are_found_at_the_beginning_of_words_only():
    assert "Ground" not in run("docs", "las").stdout  # classify_ground


def test_the_guides_name_existing_pages_commands_and_functions():
    for guide in book.guides():
        assert set(guide.commands) <= set(cli.commands), guide.title
        for name in guide.names:
            owner = loom
            *modules, last = name.split(".")
            for part in modules:
                owner = getattr(owner, part)
            assert last in dir(owner), name  # loom.torch needs torch to load its names
        page = ROOT / "docs" / f"{guide.slug}.md"
        assert not page.parent.exists() or page.read_text().startswith(f"# {guide.title}\n"), guide.title


def test_the_guides_are_the_pages_of_the_index_of_the_documentation():
    listed = re.findall(r"^\| \[[^\]]+\]\(([\w-]+)\.md\)", (ROOT / "docs" / "README.md").read_text(), re.MULTILINE)
    assert len(listed) > 30 and {guide.slug for guide in book.guides()} == set(listed)


def test_docs_reports_the_pages_or_their_absence(tmp_path, monkeypatch):
    monkeypatch.setattr(book, "CHECKOUT_FOLDER", tmp_path)
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
    writer = script("write_man_page")
    page = writer.man_page()
    assert (ROOT / "docs/pointloom.1").read_text() == page, "run scripts/write_man_page.py"
    assert [name for name in cli.commands if f'.SS "{writer.escaped(name)}"' not in page] == []
    options = [option for command in cli.commands.values() for one in command.params for option in one.opts]
    long = [option for option in options if option.startswith("--")]
    assert len(long) > 100 and [option for option in long if writer.escaped(option) not in page] == []
    installed = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["hatch"]["build"]["targets"]["wheel"]
    assert installed["shared-data"] == {"docs/pointloom.1": "share/man/man1/pointloom.1"}
    assert writer.escaped(".ply a-b\n'x\\") == "\\&.ply a\\-b\n\\&'x\\e"


MESH, TILES = "mesh a.ply b.ply", "tile plan survey --steps steps.toml -o job"
CALLS = [
    ("fus", "did you mean fuse?"),
    ("xyzzy", "the commands are change, clean, clean-mesh"),
    ("fuse", "missing argument"),
    ("fuse frames", "missing option '-o'"),
    ("fuse frames -o a.ply --voxl 1", "no option --voxl of pointloom fuse; did you mean --voxel?"),
    ("normals a.ply b.ply --voxel 1", "which downsample and simplify have; its options are --radius,"),
    ("view a.ply --eps 1", "no option --eps of pointloom view; its options are --port"),
    ("clean a.ply", "missing argument 'OUT'"),
    ("clean a.ply b.ply -o c.ply", "expected one OUT, got b.ply and -o c.ply"),
    ("fuse frames -o a.ply --voxel 0", "above 0, got '0'"),
    ("fuse frames -o a.ply --depth-max inf", "above 0, got 'inf'"),
    ("fuse frames -o a.ply --every 0", "--every"),
    ("fuse frames -o a.ply --layout kitti", "--layout"),
    ("fuse frames -o a.ply --device gpu", "such as cuda:0"),
    ("normals a.ply b.ply --neighbors 2", "'--neighbors'"),
    ("normals a.ply b.ply --toward 0 0 0 --direction 0 0 1", "pass one of them"),
    ("change a.ply b.ply --toward 0 0 0", "expected a direction"),
    ("demo --seed -1", "--seed"),
    ("reconstruct frames -o a.ply --resume", "--resume requires --method fragments"),
    ("reconstruct frames -o a.ply --config a.json", "--config requires --method fragments"),
    ("reconstruct frames -o a.ply --picture ./a.ply", "--picture is the same file as --output, a.ply"),
    ("register a.ply", "missing argument 'B'"),
    ("register a.ply b.ply --init globl", "--init: expected global, identity or a pose file, got 'globl'"),
    ("register a.ply b.ply --aligned c.png --picture ./c.png", "--picture is the same file as --aligned, c.png"),
    ("register a.ply b.ply --picture x.html --record x.html", "--record"),
    ("register a.ply b.ply --record r.avi", ".html, .gif, .mp4"),
    ("register a.ply b.ply --free x,yav", "expected motions among x, y, z, roll, pitch, yaw, each once, got 'yav'"),
    ("register a.ply b.ply --free x,x", "each once, got 'x'"),
    ("register a.ply b.ply --free x", "expected all six or x,y,z,yaw for a global search, got x; others need --init"),
    ("register a.ply b.ply --prior-sigma 0.1 1", "--prior, --prior-sigma: expected both or none"),
    ("multiway scans -o a.log --loops 0", "'--loops': expected a whole number from 1"),
    ("multiway scans -o a.log --job job", "missing option '--voxel'; --job"),
    ("multiway scans -o a.log --voxel 1 --job job --merged b.ply", "--merged needs all clouds in memory"),
    ("multiway scans -o a.log --workers 2", "--workers, --places and --place-error require --job"),
    ("odometry scans -o a.txt --format json", "'--format'"),
    ("odometry drive -o x.html --record x.html", "--record"),
    ("odometry scans -o a.txt --min-range -1", "'--min-range': expected a distance in meters, 0 or above"),
    ("odometry scans -o a.txt --max-range 3", "--min-range 5 leaves nothing within --max-range 3"),
    ("map scans -o a.ply --max-range 3", "--min-range 5 leaves nothing within --max-range 3"),
    ("map scans -o a.ply --trajectory a.ply", "--trajectory"),
    ("evaluate a.txt b.txt --alignment umeyama", "'--alignment'"),
    ("clean a.ply b.ply --radius 1", "--radius requires --min-neighbors"),
    ("clean a.ply b.ply --deviations inf", "'--deviations': expected a finite number above 0, got 'inf'"),
    ("clean a.ply b.ply --neighbors 2147483647", "'--neighbors': expected a whole number from 1 to"),
    ("clean a.ply b.ply --removed ./b.ply", "--removed is the same file as OUT"),
    ("cluster a.ply b.ply", "missing option '--radius'"),
    ("plane a.ply b.ply --distance 1 --planes 2 --invert", "--invert selects points, --planes labels"),
    ("plane a.ply b.ply --distance 1 --min-points 9", "--min-points requires --planes"),
    ("plane a.ply b.ply --distance 1 --seed 2147483648", "'--seed': expected a whole number from 0"),
    ("crop a.ply b.ply", "one of --box and --polygon"),
    ("crop a.ply b.ply --box 0 0 0 1 nan 1", "'--box': expected a coordinate"),
    ("crop a.ply b.ply --box 0 2 0 1 1 1", "--box: expected Y0 <= Y1, got 2 and 1"),
    ("downsample a.ply b.ply", "one of --every, --ratio, --farthest and --voxel, got none"),
    ("downsample a.ply b.ply --ratio 1.5", "'--ratio': expected a fraction above 0 and up to 1"),
    ("downsample a.ply b.ply --every 2 --nearest", "--nearest requires --voxel"),
    ("simplify a.ply b.ply", "--triangles"),
    ("simplify a.ply b.ply --voxel 0.1 --max-error 1", "--max-error"),
    ("smooth-mesh a.ply b.ply --method simple --mu -0.5", "--mu requires --method taubin"),
    (f"{MESH} --radii 0.1", "--radii requires --method ball"),
    (f"{MESH} --alpha 0.1", "--alpha requires --method alpha"),
    (f"{MESH} --method ball --depth 7", "--depth requires --method poisson"),
    (f"{MESH} --method alpha --new-normals", "--new-normals requires --method poisson or ball"),
    (f"{MESH} --method ball --radii 0.1,0", "expected lengths in meters above 0"),
    (f"{MESH} --method alpha --alpha much", "expected a length in meters above 0, or auto"),
    (f"{MESH} --density-quantile 1", "expected a fraction from 0 and below 1"),
    (f"{MESH} --picture b.ply", "--picture is the same file as OUT"),
    ("texture a.ply frames -o b.ply --picture b.ply", "--picture is the same file as --output"),
    ("convert - b.ply", "- has no extension; pass its format, such as --from ply"),
    ("convert a.ply -", "such as --to ply"),
    ("convert a.ply b.ply --from ply", "--from requires - as IN"),
    ("convert a.ply b.ply --up z", "--up z requires a .glb or .gltf file"),
    ("info - - --from ply", "- is duplicated"),
    ("info a.ply --from ply", "--from requires -"),
    ("convert - - --from docx --to ply", "--from"),
    ("view a.ply --port 70000", "--port"),
    ("view a.ply --point-size 0", "above 0"),
    ("view a.ply --colormap jet", "--colormap requires --color-by"),
    ("view a.ply --screenshot a.ply", "is one of the FILES"),
    ("view a.ply --screenshot a.png --save-html a.png", "is the same file as"),
    ("tile plan survey -o job", "missing option '--steps'"),
    (f"{TILES} --size 5 --points 9", "both define the tiles"),
    (f"{TILES} --only 1,2,3,nan", "expected X0,Y0,X1,Y1"),
    (f"{TILES} --output ply", "'laz', 'copc'"),
    ("tile plan survey --steps steps.toml", "missing option '-o'"),
    ("tile run job --part 1/2 --tile 0_0", "pass one of them"),
    ("tile run job --part 0/2", "such as 17/400"),
    ("tile runs job", "did you mean run?"),
    ("tile finish job --output gltf", "'gltf' is not one of 'laz', 'las', 'copc'"),
]


@pytest.mark.parametrize(("words", "hint"), CALLS)
def test_a_wrong_call_exits_with_2_and_explains_the_fix(tmp_path, monkeypatch, words, hint):
    monkeypatch.chdir(tmp_path)
    result = run(*words.split())
    assert (result.exit_code, result.stdout) == (2, "")
    first, *others = result.stderr.splitlines()
    assert first.startswith("error: ") and all(line.startswith("See 'pointloom") for line in others)
    assert hint.lower() in first.lower() and names_in(tmp_path) == []


@pytest.mark.parametrize(
    ("fraction", "text"),
    [
        (0, "0.0%"), (1, "100.0%"), (0.5, "50.0%"), (51 / 113662, "0.04%"), (0.0004, "0.04%"), (0.001, "0.1%"),
        (0.9996, "99.96%"), (1 - 1e-6, "99.9999%"), (0.905, "90.5%"), (math.nan, "nan%"), (1e-7, "0.00001%"),
    ],
)  # fmt: skip
def test_fractions_have_enough_digits(fraction, text):
    assert format_fraction(fraction) == text


@settings(max_examples=25)
@given(st.integers(1, 10**9).flatmap(lambda total: st.tuples(st.integers(0, total), st.just(total))))
def test_only_0_and_1_are_printed_as_0_and_100_percent(counts):
    count, total = counts
    printed = float(format_fraction(count / total).rstrip("%"))
    assert (printed == 0) == (count == 0) and (printed == 100) == (count == total)
