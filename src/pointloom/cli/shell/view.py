"""The command `view`: files in the browser, as an image or as a page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .options import FILE, SCALE, columns_option, force_option, json_option, refuse, refuse_same
from .pipes import from_option, open_pipes

_COLORMAPS = ("viridis", "plasma", "inferno", "magma", "cividis", "turbo", "gray", "coolwarm", "jet")


@click.command(short_help="Show files in the browser, or render an image.")
@click.argument("files", nargs=-1, required=True, type=FILE, metavar="FILES...")
@click.option(
    "--port", type=click.IntRange(0, 65535), default=8080, show_default=True, metavar="N",
    help="Port of the page. If in use: the next free one. 0: any free port.",
)  # fmt: skip
@click.option(
    "--host", default="127.0.0.1", show_default=True, metavar="ADDRESS",
    help="Address to listen on. With another address, anyone with the URL and its token can see the files.",
)  # fmt: skip
@click.option(
    "--max-points", type=click.IntRange(min=1), default=2_000_000, show_default=True, metavar="N",
    help="Maximum points on the page. Larger clouds use levels of detail.",
)  # fmt: skip
@click.option("--screenshot", type=FILE, metavar="PNG", help="Render an image and exit. Needs no browser.")
@click.option("--save-html", type=FILE, metavar="HTML", help="Write a page that needs no server, and exit.")
@click.option("--no-open", is_flag=True, help="Do not open a browser.")
@click.option(
    "--keep-alive", type=click.FloatRange(min=0), default=60, show_default=True, metavar="S",
    help="Time until the command exits after the last page closed [s]. inf: never.",
)  # fmt: skip
@click.option("--color-by", metavar="NAME", help="Color by rgb, height, normal, label, or an attribute of the clouds.")
@click.option("--colormap", type=click.Choice(_COLORMAPS), help="Colormap of values. Default: viridis.")
@click.option("--view", "view_file", type=FILE, metavar="JSON", help="Camera view, as copied from Open3D (Ctrl+C).")
@click.option("--up", type=click.Choice(("y", "z")), help="Up axis. Default: that of the files, else z.")
@click.option("--point-size", type=SCALE, metavar="PX", help="Diameter of points [px].")
@click.option("--topic", metavar="NAME", help="Recordings: topic of the clouds. Default: the only one with clouds.")
@click.option("--frame", metavar="NAME", help="Recordings: tf frame in which all clouds are merged.")
@columns_option()
@from_option()
@json_option()
@force_option()
def view(
    files: tuple[Path, ...],
    screenshot: Path | None,
    save_html: Path | None,
    read_as: str | None,
    as_json: bool,
    **options: Any,
) -> int:
    """Show clouds, meshes, trajectories and TSDF volumes in the browser, on this machine or remotely over SSH.

    The URL, and the ssh command for a remote browser, are printed to stderr. The command exits --keep-alive seconds
    after the last page closed, with a notice on stderr, or with Ctrl-C.

    \b
    clouds        .ply .pcd .npz .xyz .xyzn .xyzrgb .pts .csv .txt .asc .bin .las .laz .e57 .ptx
    meshes        .ply .obj .stl .off .glb .gltf
    trajectories  .log .tum .kitti .txt .json
    volumes       .npz of TSDFVolume.save, .json of SelectionPolygonVolume
    recordings    .bag .mcap .db3 and folders of them: the first cloud, or all clouds with --frame

    One of FILES may be -, standard input, with --from.

    --screenshot and --save-html need no browser, and exit when done.

    \b
    pointloom view scan.las --color-by intensity
    pointloom view room.ply poses.log --no-open --port 9000
    pointloom view mesh.ply --screenshot mesh.png --view view.json
    pointloom view run.mcap --topic /points --frame odom
    """
    refuse_same(screenshot=screenshot, save_html=save_html)
    for written in (screenshot, save_html):
        if written is not None and written.resolve() in [path.resolve() for path in files]:
            refuse(f"{written} is one of the FILES; pass another name")
    if options["colormap"] is not None and options["color_by"] is None:
        refuse("--colormap requires --color-by")
    from .view_job import ViewJob, ViewOptions, check_outputs

    check_outputs(screenshot, save_html, force=options["force"])

    with open_pipes(files, read_as=read_as) as ends:
        job = ViewJob(ends, ViewOptions(**options))
        if screenshot is not None or save_html is not None:
            return job.write(screenshot, save_html, as_json)
        return job.serve(as_json)


COMMANDS = (view,)
