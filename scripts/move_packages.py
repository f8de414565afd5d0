"""Move ten packages from the top level into src/pointloom and give them standard names: run once.

Renames imports by the modules that they resolve to, dotted names in text, and paths that exist in the repository.
"""

from __future__ import annotations

import ast
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NAMES = {
    "core": "core", "cameras": "cameras", "rgbd": "rgbd", "files": "io", "drawing": "visualization",
    "photos": "photogrammetry", "scale": "tiling", "data": "datasets", "app": "cli", "bridge": "open3d",
}  # fmt: skip
PUBLIC = {"data": "datasets", "scale": "tiling"}  # attributes of pointloom
IMPORTED = {old: new for old, new in NAMES.items() if old not in {new, "bridge"}}
TEXT = {".py", ".pyi", ".md", ".toml", ".json", ".rst", ".txt", ".sh", ".yaml", ".yml", ".js", ".ipynb", ".1", ""}


def git(*args: str) -> str:
    """The output of a git command."""
    return subprocess.run(["git", *args], cwd=ROOT, check=True, capture_output=True, text=True).stdout


LOCAL = {
    "tests/test_imports.py",
    "tests/test_process_state.py",
    "tests/test_fixed_order.py",
    "tests/choice.py",
}  # names of the package or of tests/


def moves(paths: list[str]) -> dict[str, str]:
    """Old path -> new path of every file that moves."""
    found = {}
    for path in paths:
        top, _, rest = path.partition("/")
        if top in NAMES:
            found[path] = f"src/pointloom/{NAMES[top]}/{rest}"
        elif top == "tests" and "/" in rest:
            house, _, inside = rest.partition("/")
            if house == "oracle_answers" and (kind := inside.partition("/")[0]) in NAMES:
                found[path] = f"tests/oracle_answers/{NAMES[kind]}/{inside.partition('/')[2]}"
            is_shipped = house == "data" and not re.fullmatch(r"[^/]+\.py", inside)
            if not is_shipped and NAMES.get(house, house) != house:
                found[path] = f"tests/{NAMES[house]}/{inside}"
    return {old: new for old, new in found.items() if old != new}


def module_of(path: str) -> list[str]:
    """The package that relative imports of a file start from."""
    parts = path.removeprefix("src/").split("/")
    if parts[0] in NAMES:
        parts = ["pointloom", "open3d" if parts[0] == "bridge" else parts[0], *parts[1:]]
    elif parts[0] in {"kernels", "pcd", "registration", "meshing"}:
        parts = ["pointloom", *parts]
    return parts[:-1]


def renamed(source: str, path: str) -> str:
    """A Python file with its imports renamed."""
    package, lines = module_of(path), source.split("\n")
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.ImportFrom):
            continue
        base = package[: len(package) + 1 - node.level] if node.level else []
        module = (node.module or "").split(".") if node.module else []
        full = [*base, *module]
        names = {**IMPORTED, "bridge": "open3d"} if full[:1] == ["tests"] else IMPORTED
        if full[:1] not in (["pointloom"], ["tests"]):
            continue
        row = node.lineno - 1
        if len(full) > 1 and full[1] in names:
            if len(base) > 1:  # inside its own package
                continue
            new = [*full[:1], names[full[1]], *full[2:]]
            old_text = "." * node.level + ".".join(module)
            new_text = "." * node.level + ".".join(new[len(base) :])
            assert f"from {old_text} " in lines[row], (path, lines[row])
            lines[row] = lines[row].replace(f"from {old_text} ", f"from {new_text} ", 1)
        elif len(full) == 1 and any(alias.name in names for alias in node.names):
            lines[row] = re.sub(r"\b(data|scale)\b", lambda m: PUBLIC[m[1]], lines[row])
            print("imported as a name:", path, node.lineno, lines[row])
    return "\n".join(lines)


def main() -> None:
    """Move the files, then rename in all text."""
    tracked = git("ls-files").split("\n")[:-1]
    links = [f"src/pointloom/{name}" for name in (*NAMES, "open3d") if f"src/pointloom/{name}" in tracked]
    table = moves(tracked)
    folders = {}
    for old, new in table.items():
        a, b = Path(old).parent, Path(new).parent
        while str(a) not in (".", "tests"):
            folders.setdefault(str(a), str(b))
            a, b = a.parent, b.parent
    folders.pop("tests/data", None)
    places = {**folders, **table}
    dotted = "|".join(sorted(IMPORTED, key=len, reverse=True))
    tops = "|".join(sorted(NAMES, key=len, reverse=True))
    path_like = re.compile(rf"(?<![\w/.\0-])((?:\.\./)*)((?:tests/)?(?:{tops})(?:/[\w.*-]+)+/?)")

    def to_new(match: re.Match[str]) -> str:
        up, path = match.groups()
        tail = "/" if path.endswith("/") else ""
        bare = path.rstrip("/")
        dots = ""
        while bare and bare not in places and bare.endswith((".", "-")):
            bare, dots = bare[:-1], bare[-1] + dots
        return up + places[bare] + tail + dots if bare in places else match.group()

    texts = {}
    for path in tracked:
        file = ROOT / path
        if (
            file.is_symlink()
            or not file.is_file()
            or file.suffix not in TEXT
            or (path.startswith("tests/data/") and path not in table)
        ):
            continue
        if path in {"scripts/move_packages.py", "docs/api.txt"} or path.startswith("benchmarks/results"):
            continue
        try:
            source = file.read_text()
        except UnicodeDecodeError:
            continue
        text = source
        if file.suffix in {".py", ".pyi"}:
            text = renamed(text, path)
        text = re.sub(rf"\bpointloom([./])({dotted})\b(?!\()", lambda m: f"pointloom{m[1]}{IMPORTED[m[2]]}", text)
        text = re.sub(r"\bloom\.(data|scale)\b(?!\()", lambda m: f"loom.{PUBLIC[m[1]]}", text)
        if path.startswith("tests/"):
            text = re.sub(rf'(oracle\(\s*f?")({tops})/', lambda m: m[1] + NAMES[m[2]] + "\0", text)
        text = path_like.sub(to_new, text).replace("\0", "/")
        if path in LOCAL:
            text = text.replace("src/pointloom/", "")
        if text != source:
            texts[path] = text
    for link in links:
        git("rm", "-q", link)
    for old, new in table.items():
        (ROOT / new).parent.mkdir(parents=True, exist_ok=True)
        git("mv", old, new)
    for path, text in texts.items():
        (ROOT / table.get(path, path)).write_text(text)
    print(len(table), "files moved,", len(texts), "files changed")


if __name__ == "__main__":
    main()
