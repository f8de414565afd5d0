"""Give modules the names of their field: run once.

A module is found by the path within the package, and each import by the module that it resolves to. Dotted names and
paths in text follow.
"""

from __future__ import annotations

import ast
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LINKED = ("kernels", "pcd", "registration", "meshing")
NAMES = {
    "core/halves": "batch_splitting", "core/upward": "up_axis", "core/told_arguments": "argument_errors",
    "core/watching": "observers", "core/number_runs": "number_ranges", "core/plain_poses": "pose_checks",
    "core/known_names": "attribute_hints", "core/yes_or_no": "callable_bool",
    "visualization/render/upward": "up_axis", "visualization/viewer/arrivals": "home_views",
    "visualization/viewer/presence": "client_presence", "visualization/viewer/stills": "screenshots",
    "visualization/viewer/calls": "callback_queue", "visualization/viewer/logged": "timed_calls",
    "visualization/viewer/whole_cloud": "point_transfer",
    "pcd/length_doubts": "length_checks", "pcd/shape_verdicts": "shape_checks", "pcd/kept_tree": "cached_tree",
    "pcd/probes": "point_spacing", "datasets/kept": "array_cache",
    "kernels/language/kept_kernels": "kernel_cache", "kernels/language/once": "lazy_property",
    "kernels/language/notices": "compile_notices", "kernels/language/trees": "syntax_trees",
    "rgbd/odometry/verdicts": "motion_checks", "rgbd/slam/verdicts": "frame_checks", "rgbd/slam/joins": "map_joins",
    "rgbd/slam/movers": "moving_objects", "rgbd/slam/sizes": "volume_sizes", "rgbd/slam/paths": "path_statistics",
    "rgbd/reconstruction/places": "job_files", "kernels/rgbd/verdict_rows": "check_rows",
    "io/fans": "triangulation", "io/foreign": "optional_imports", "io/growing": "growing_columns",
    "io/meshes/gltf_left": "gltf_unsupported", "io/bags/pieces": "message_chunks",
    "registration/given_pairs": "correspondence_input", "registration/open_motions": "unobservable_motions",
    "kernels/poses/sight": "line_of_sight", "kernels/stereo/place_planes": "region_planes",
    "kernels/stereo/plain_places": "textureless_regions", "kernels/rays/surface_places": "surface_positions",
    "tiling/borders": "border_merging", "tiling/loose_files": "unindexed_files",
    "meshing/volume/occupancy_questions": "occupancy_queries", "kernels/remeshing/edge_prices": "edge_costs",
    "kernels/remeshing/squeezed_mesh": "compacted_mesh", "kernels/segmentation/shape_rivals": "shape_alternatives",
    "photogrammetry/sfm/picture_places": "image_positions", "photogrammetry/depth/readings": "network_outputs",
    "kernels/arrays/changes": "atomic_changes",
}  # fmt: skip
DOTTED = {f"pointloom.{old.replace('/', '.')}": new for old, new in NAMES.items()}
TEXT = {".py", ".pyi", ".md", ".toml", ".json", ".js", ".h", ""}


def git(*args: str) -> str:
    """The output of a git command."""
    return subprocess.run(["git", *args], cwd=ROOT, check=True, capture_output=True, text=True).stdout


def file_of(name: str) -> str:
    """The path of a module in the repository."""
    return f"{name}.py" if name.startswith(LINKED) else f"src/pointloom/{name}.py"


def renamed(source: str, path: str) -> str:
    """A Python file with its imports, and the names that they bind, renamed."""
    parts = path.removeprefix("src/").split("/")
    package = (["pointloom"] if parts[0] in LINKED else []) + parts[:-1]
    lines, bound = source.split("\n"), {}
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.ImportFrom):
            continue
        base = package[: len(package) + 1 - node.level] if node.level else []
        full = ".".join([*base, *([node.module] if node.module else [])])
        row = node.lineno - 1
        if full in DOTTED and node.module:
            old = "." * node.level + node.module
            new = "." * node.level + ".".join([*node.module.split(".")[:-1], DOTTED[full]])
            assert f"from {old} " in lines[row], (path, lines[row])
            lines[row] = lines[row].replace(f"from {old} ", f"from {new} ", 1)
        for alias in node.names:
            new = DOTTED.get(f"{full}.{alias.name}")
            if new is None:
                continue
            at = (alias.lineno or node.lineno) - 1
            lines[at] = re.sub(rf"(?<![\w.]){alias.name}\b", new, lines[at])
            if alias.asname is None:
                bound[alias.name] = new
    text = "\n".join(lines)
    for old, new in bound.items():
        assert not re.search(rf"\b{new}\b(?!,|$|\n| as | import)", source), (path, old, new)
        text = re.sub(rf"(?<![\w.\"'/]){old}(?=[.,)]|$)(?!\.py)", new, text, flags=re.M)
        print("bound:", path, old, new)
    return text


def main() -> None:
    """Rename in all text, then move the files."""
    tracked = git("ls-files").split("\n")[:-1]
    dotted = re.compile(r"\b(?:" + "|".join(re.escape(name) for name in DOTTED) + r")\b")
    paths = {old: f"{Path(old).parent}/{new}" for old, new in NAMES.items()}
    path_like = re.compile(r"(?<![\w-])(" + "|".join(map(re.escape, paths)) + r")(?=\.py\b|::|`|\")")
    short = {}
    for old, new in NAMES.items():
        two = "/".join(old.split("/")[-2:])
        short[f"{two}.py"] = f"{Path(two).parent}/{new}.py"
    stems = [Path(path).name for path in tracked if not path.startswith(("tests/", "benchmarks/", "docs/"))]
    for old, new in NAMES.items():
        name = f"{Path(old).name}.py"
        if stems.count(name) == 1:
            short[name] = f"{new}.py"
            short[f"test_{name}"] = f"test_{new}.py"
    short_like = re.compile(r"(?<![\w-])(" + "|".join(sorted(map(re.escape, short), key=len, reverse=True)) + r")\b")
    for path in tracked:
        file = ROOT / path
        if file.is_symlink() or not file.is_file() or file.suffix not in TEXT or path.startswith("tests/data/"):
            continue
        if path == "scripts/rename_modules.py" or path.startswith("benchmarks/results"):
            continue
        try:
            source = file.read_text()
        except UnicodeDecodeError:
            continue
        text = renamed(source, path) if file.suffix in {".py", ".pyi"} else source
        text = dotted.sub(lambda m: f"{m[0].rpartition('.')[0]}.{DOTTED[m[0]]}", text)
        text = path_like.sub(lambda m: paths[m[1]], text)
        text = short_like.sub(lambda m: short[m[1]], text)
        if text != source:
            file.write_text(text)
    for old, new in NAMES.items():
        git("mv", file_of(old), file_of(f"{Path(old).parent}/{new}"))
        name = f"{Path(old).name}.py"
        for test in [path for path in tracked if Path(path).name == f"test_{name}" and stems.count(name) == 1]:
            git("mv", test, str(Path(test).with_name(f"test_{new}.py")))


if __name__ == "__main__":
    main()
