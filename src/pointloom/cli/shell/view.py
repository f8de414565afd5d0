"""The command `view`: files in the browser, as an image or as a page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .format_lists import with_lists
from .options import COLUMNS, FILE, FORCE, JSON, SCALE, in_order, option, refuse, refuse_same
from .pipes import FROM, open_pipes

_COLORMAPS = ("viridis", "plasma", "inferno", "magma", "cividis", "turbo", "gray", "coolwarm", "jet")


@click.command(short_help="Show files in the browser, or render an image.")
@click.argument("files", nargs=-1, required=True, type=FILE, metavar="FILES...")
@option(
    "--port=N",
    click.IntRange(0, 65535),
    "Port of the page. If in use: the next free one. 0: any free port.",
    default=8080,
)
@option(
    "--host=ADDRESS",
    str,
    "Address to listen on. With another address, anyone with the URL and its token can see the files.",
    default="127.0.0.1",
)
@option(
    "--max-points=N",
    click.IntRange(min=1),
    "Maximum points on the page. Larger clouds use levels of detail.",
    default=2_000_000,
)
@option("--screenshot=PNG", FILE, "Render an image and exit. Needs no browser.")
@option("--save-html=HTML", FILE, "Write a page that needs no server, and exit.")
@option("--no-open", bool, "Do not open a browser.")
@option(
    "--keep-alive=S",
    click.FloatRange(min=0),
    "Time until the command exits after the last page closed [s]. inf: never.",
    default=60,
)
@option("--color-by=NAME", str, "Color by rgb, height, normal, label, or an attribute of the clouds.")
@option("--colormap", click.Choice(_COLORMAPS), "Colormap of values. Default: viridis.")
@option("--view view_file=JSON", FILE, "Camera view, as copied from Open3D (Ctrl+C).")
@option("--up", ["y", "z"], "Up axis. Default: that of the files, else z.")
@option("--point-size=PX", SCALE, "Diameter of points [px].")
@option("--topic=NAME", str, "Recordings: topic of the clouds. Default: the only one with clouds.")
@option("--frame=NAME", str, "Recordings: tf frame in which all clouds are merged.")
@in_order(COLUMNS, FROM, JSON, FORCE)
@with_lists
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
    clouds        {clouds}
    meshes        {meshes}
    trajectories  {trajectories}
    rasters       .tif of pointloom dtm: the centers of their cells
    volumes       .npz of TSDFVolume.save, .json of SelectionPolygonVolume
    recordings    {recordings} and folders of them: the first cloud, or all clouds with --frame

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
