"""Messages of the library in terms of commands: options instead of arguments, commands instead of functions."""

from __future__ import annotations

import re

import click

_ANY = r"\([^()]*(?:\([^()]*\)[^()]*)*\)"  # a call's parentheses

# Phrases of the library, as regular expressions, and those of the command line.
_PHRASES = [
    (r"overwrite=True", "--force"),
    (r"Call plan_tiles\(sources, steps, folder\) first, then run_tiles",
     "Run pointloom tile plan first, then tile run"),
    (r"call retry_tiles\(folder\)", "run pointloom tile retry"),
    (r"call run_tiles, then finish_tiles", "call pointloom tile run, then tile finish"),
    (r"Call run_tiles, or first retry_tiles", "Call pointloom tile run, or first tile retry"),
    (r"Pass it as from_crs='EPSG:25832' of the step, or as --from-crs", "Pass it as --from-crs"),
    # units and coordinate systems
    (r"Assign it first, as in cloud\.crs = 25832", "Pass it to pointloom transform as --from-crs EPSG:25832"),
    (r"Assign it first, as in cloud\.unit = '\w+'", "Use pointloom transform --scale"),
    (r"Convert one with reproject\((.*?)\), or set its crs if it is wrong",
     r"Convert one with pointloom transform --crs \1, with --from-crs if its own is wrong"),
    (r"Convert a cloud with to_unit\(\W?(\w+)\W?\), or set cloud\.unit if a unit is wrong",
     r"Convert a cloud with pointloom transform --unit \1, or --scale if a unit is wrong"),
    (r"(?:Convert degrees with|Write|Project it first, for example to meters with) project_to_utm\(cloud\)"
     r"(?:, or set cloud\.unit if (?:a unit|it) is wrong)?",
     "Convert degrees with pointloom transform --crs, such as to a UTM zone"),
    (r"project_to_utm\(cloud\) gives meters", "pointloom transform --crs gives meters, such as in a UTM zone"),
    (r"Convert it with project_to_utm\(cloud\)", "Convert it with pointloom transform --crs"),
    (r"(?:convert with )?(?:cloud)?\.to_unit\(\W?([\w ]+?)\W?\) converts them(?: beforehand)?",
     r"pointloom transform --unit '\1' converts them"),
    (r"convert with cloud\.to_unit\(\W?(\w+)\W?\)", r"convert with pointloom transform --unit \1"),
    (r"to fix it: .*cloud\.points = points", "write the heights in the unit of x and y"),
    (r"Set cloud\.unit if they are wrong", "Use pointloom transform --scale if they are wrong"),
    (r"Use a (smaller|larger) unit of length, such as cloud\.scale\((.*?), cloud\.get_center\(\)\)",
     r"Use a \1 unit of length, such as by pointloom transform --scale \2"),
    (r"call cloud\.scale\(1e-6\) first", "run pointloom transform --scale 1e-6 first"),
    (r"Reproject cloud\.without\(\W*normals\W*\)", "Convert it first to a format without normals, such as .xyz"),
    (r"Use project_to_utm\b", "Use pointloom transform --crs"),
    (r"; create others with LengthUnit\(name, symbol, m\)", ""),
    (r"Give a larger scale, such as scale=[\d.e+-]+, or a nearer offset",
     "Write another format, or split the cloud first"),
    # points
    (rf"(?:C|c)all cloud = cloud\.estimate_normals\(\)(?:, then cloud = cloud\.orient_normals\w+{_ANY})?",
     "Run pointloom normals first"),
    (rf"Call cloud\.orient_normals\w*{_ANY} first", "Run pointloom normals first"),
    (r"call cloud\.voxel_down_sample\(\)", "run pointloom downsample"),
    (r"(?:C|c)all remove_non_finite_points\(\) first", "Run pointloom clean --non-finite first"),
    (r"(?:Use|Remove such points(?: first)? with) (?:cloud\.)?remove_non_finite_points\(\)",
     "Run pointloom clean --non-finite"),
    (r"Classify the ground with classify_ground\(cloud\) and set cloud\[.classification.\]",
     "Run pointloom ground first"),
    (r"set cloud\[.classification.\] to 2 where classify_ground\(cloud\) is True", "run pointloom ground first"),
    # meshes
    (r"Read it as a point cloud with read_point_cloud\. loom\.\S+, or the command pointloom mesh, makes a mesh",
     "It is a point cloud: pointloom mesh makes a mesh"),
    (r"(?:Close holes|Repair it) with repair\(hole_size=\.\.\.\) first", "Run pointloom clean-mesh --fill first"),
    (rf"(?:Call|Orient separate parts outward with) orient_triangles{_ANY}(?: first)?",
     "Run pointloom clean-mesh first"),
    (r"repair\(\) removes such triangles", "pointloom clean-mesh removes such triangles"),
    (r"call compute_vertex_normals\(\)", "run pointloom clean-mesh"),
    (r": trimesh\.load\(source\)\.export\(target\)", ""),
    # frames and recordings
    (r"Read this recording with loom\.open_recording\(path\)\.\w+\(\)",
     "Recordings are read by pointloom info, convert, view, odometry, map, track and reconstruct"),
    (r"; intrinsic\.scaled\(factor\) adapts one to resized images", ""),
    (r"(?:Use|see) loom\.undistort_image", "Undistort the images first"),
    (r"expected a camera pose \(T_world_camera\), got None", "expected a camera pose, got none"),
    (r"Read one file at a time: sorted\(pathlib\.Path\(folder\)\.glob\(pattern\)\) lists them",
     "Leave the pattern to the shell, without quotes"),
    (r"Give format= one of .*$", "Give a name with the extension of its format"),
    (r"; to rate a pose, use evaluate_registration\(\)", ""),
    (r"Pass drop_invalid=True to read_splats to leave them out", "Write the splats again without them"),
    (r", or pass drop_unsupported=True|; drop the others with drop_unsupported=True", ""),
    (r"photogrammetry\.(?:find_features|match_features) (?:creates one|computes them)", "pointloom video creates them"),
    (r"Run photogrammetry\.match_features again", "Run pointloom video again"),
]  # fmt: skip

# Arguments that are options of other commands where the running one has none, and a command that has it.
_ELSEWHERE = {
    "intrinsic": "track", "depth_scale": "track", "layout": "track", "columns": "convert", "skip_missing": "fuse"
}  # fmt: skip
_SYNONYMS = {"voxel_size": "--voxel"}  # arguments that parameters of some commands name otherwise


def in_options(text: str) -> str:
    """A message of the library with options and commands instead of arguments and functions."""
    for phrase, words in _PHRASES:
        text = re.sub(phrase, words, text)
    context = click.get_current_context(silent=True)
    options = [one for one in context.command.params if isinstance(one, click.Option) and one.name] if context else []
    own = {str(one.name): one.opts[0] for one in options}
    own |= {name: option for name, option in _SYNONYMS.items() if option in own.values()}
    pairs = [(name, option, "") for name, option in own.items()]
    pairs += [
        (name, f"--{name.replace('_', '-')}", f" of pointloom {command}" if own else "")
        for name, command in _ELSEWHERE.items()
        if name not in own
    ]
    for name, option, command in pairs:
        start = rf"(?<![\w/.-]){re.escape(name)}"  # not within the name of a file
        text = re.sub(rf"^{re.escape(name)}: ", f"{option}: ", text) if name in own else text
        text = re.sub(rf"{start}=True(?!\w)", option + command, text)
        text = re.sub(rf"{start}=([\w.+-]*\w|'[^']*'|\"[^\"]*\")", lambda found: f"{option} {found[1]}{command}", text)  # noqa: B023
        text = re.sub(rf"{start}=(?!\w)", option + command, text)
        if "_" in name and name in own:
            text = re.sub(rf"{start}(?!\w|[/.]\w)", option, text)
    return text
