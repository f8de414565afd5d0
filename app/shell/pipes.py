"""`-` in place of a file: standard input spooled to a file before the work, a file copied to standard output after it.

Readers look into files from both ends and writers check the place first, so both work on a temporary file; its name
shows nowhere. What a command says goes to stderr where its output takes stdout.
"""

from __future__ import annotations

import contextlib
import dataclasses
import shutil
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import click

from ...core.reports import values_of
from ...core.standard_streams import is_terminal
from .console import OutputLostError
from .options import Decorator, refuse

INPUT, OUTPUT = "standard input", "standard output"

_PIPE = Path("-")

# The extensions of files/bags/recording.py, files/points/formats.py and files/meshes/tables.py, which cannot be loaded
# for --help; a test holds them alike.
RECORDINGS = (".bag", ".mcap", ".db3")
_MESHES = ["obj", "stl", "off", "glb", "gltf"]
READ = ["ply", "pcd", "npz", "xyz", "xyzn", "xyzrgb", "pts", "csv", "txt", "asc", "bin", "las", "laz", "e57", "ptx"]
READ += _MESHES
WRITTEN = ["ply", "pcd", "npz", "xyz", "xyzn", "xyzrgb", "pts", "las", "laz", "e57", *_MESHES]


def from_option() -> Decorator:
    """`--from ply`."""
    text = "What comes through standard input, where - stands for a file."
    return click.option("--from", "read_as", type=click.Choice(READ), metavar="EXT", help=text)


def to_option() -> Decorator:
    """`--to ply`."""
    text = "What to write to standard output, where - stands for OUT."
    return click.option("--to", "write_as", type=click.Choice(WRITTEN), metavar="EXT", help=text)


class Ends(NamedTuple):
    """Files in place of pipes.

    Attributes:
        sources: What to read.
        output: What to write; None where nothing is.
        names: What to call the temporary files among them.
    """

    sources: list[Path]
    output: Path | None
    names: dict[str, str]

    @property
    def writes_pipe(self) -> bool:
        """Whether the output goes to standard output."""
        return OUTPUT in self.names.values()

    @contextlib.contextmanager
    def errors_renamed(self) -> Iterator[None]:
        """Errors over temporary files come under the names of the pipes."""
        from ...core.errors import FileError

        try:
            yield
        except FileError as error:
            if error.path not in self.names:
                raise
            renamed = type(error)(self.names[error.path], error.reason, where=error.where, remedy=error.remedy)
            raise renamed from error

    def rename(self, value: Any) -> Any:
        """A report with the names of pipes in place of temporary files."""
        if not self.names:
            return value
        if isinstance(value, dict):
            return {key: self.rename(item) for key, item in value.items()}
        if isinstance(value, list):
            return [self.rename(item) for item in value]
        if type(value) is tuple:
            return tuple(self.rename(item) for item in value)
        if dataclasses.is_dataclass(value) and not isinstance(value, type):
            return dataclasses.replace(value, **self.rename(values_of(value)))
        return self.names.get(value, value) if isinstance(value, str) else value


@contextlib.contextmanager
def open_pipes(
    sources: Sequence[Path],
    output: Path | None = None,
    *,
    read_as: str | None,
    write_as: str | None = None,
    as_json: bool = False,
) -> Iterator[Ends]:
    """Files in place of `-` among these, as long as the block lasts; at its end standard output has what was written.

    Args:
        sources: Files to read, at most one of them `-`.
        output: A file to write.
        read_as, write_as: The extensions of `-`.
        as_json: Whether the report takes standard output.

    Raises:
        click.UsageError: An extension without its `-` or the other way round, or a terminal in place of a pipe.
        FileError: What the block raises over a temporary file, under its own name.
    """
    reads, writes = list(sources).count(_PIPE), output == _PIPE
    _check("from", "IN", reads > 0, read_as)
    _check("to", "OUT", writes, write_as)
    if reads > 1:
        refuse("- stands twice for a file to read; there is one standard input")
    if writes and as_json:
        refuse("--json and - both take standard output; give a file in place of -")
    if not reads and not writes:
        yield Ends(list(sources), output, {})
        return
    if (reads and sys.stdin is None) or (writes and sys.stdout is None):
        refuse("- needs a standard stream, and this process has none; give a name in place of -")
    stdin: Any = getattr(sys.stdin, "buffer", None)
    stdout: Any = getattr(sys.stdout, "buffer", None)
    if reads and is_terminal(stdin):
        refuse("standard input is a terminal; pipe a file into it, or give a name in place of -")
    if writes and is_terminal(stdout):
        refuse("standard output is a terminal; pipe it into a program or a file, or give a name in place of -")
    with tempfile.TemporaryDirectory(prefix="pointloom-") as folder:
        spool, result = Path(folder) / f"in.{read_as}", Path(folder) / f"out.{write_as}"
        if reads:
            with spool.open("wb") as file:
                shutil.copyfileobj(stdin, file)
        names = ({str(spool): INPUT} if reads else {}) | ({str(result): OUTPUT} if writes else {})
        ends = Ends([spool if path == _PIPE else path for path in sources], result if writes else output, names)
        with ends.errors_renamed():
            yield ends
        if writes and any(path not in (spool, result) for path in Path(folder).iterdir()):
            refuse(f"files lie beside such a .{write_as}, which a pipe cannot hold: give --to glb, or a name")
        if writes and result.exists():
            _send(result, stdout)


def _send(path: Path, stdout: Any) -> None:
    """Copy a file to standard output."""
    with path.open("rb") as file:
        try:
            shutil.copyfileobj(file, stdout)
            stdout.flush()
        except OSError as error:
            raise OutputLostError(error.errno, error.strerror, OUTPUT) from error


def _check(option: str, place: str, is_pipe: bool, extension: str | None) -> None:
    if is_pipe and extension is None:
        refuse(f"- has no extension; say what it is, such as --{option} ply")
    if extension is not None and not is_pipe:
        refuse(f"--{option} goes with - in place of {place}")
