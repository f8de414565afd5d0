"""`-` as a file name: standard input is spooled to a temporary file, an output is copied to standard output.

Readers need seeking and writers check paths first, so both use temporary files, whose names are hidden. If the output
takes stdout, the report goes to stderr.
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
from .format_lists import READ, WRITTEN_FORMATS
from .options import option, refuse

INPUT, OUTPUT = "standard input", "standard output"

_PIPE = Path("-")

FROM = option(
    "--from read_as=EXT",
    click.Choice([extension[1:] for extension in READ]),
    "Format of standard input, if a file is -.",
)
TO = option(
    "--to write_as=EXT",
    click.Choice([extension[1:] for extension in WRITTEN_FORMATS]),
    "Format of standard output, if OUT is -.",
)


class Ends(NamedTuple):
    """Files in place of pipes; `names` has the displayed names of temporary ones."""

    sources: list[Path]
    output: Path | None
    names: dict[str, str]

    @property
    def writes_pipe(self) -> bool:
        return OUTPUT in self.names.values()

    @contextlib.contextmanager
    def errors_renamed(self) -> Iterator[None]:
        """Context that renames temporary files in errors."""
        from ...core.errors import FileError

        try:
            yield
        except FileError as error:
            if error.path not in self.names:
                raise
            renamed = type(error)(self.names[error.path], error.reason, where=error.where, remedy=error.remedy)
            raise renamed from error

    def rename(self, value: Any) -> Any:
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
    """Context that replaces `-` by temporary files. At its end the output is copied to standard output.

    `read_as` and `write_as` are the extensions of `-`. Raises click.UsageError for an extension without `-` or the
    reverse, or a terminal in place of a pipe.
    """
    reads, writes = list(sources).count(_PIPE), output == _PIPE
    _check("from", "IN", reads > 0, read_as)
    _check("to", "OUT", writes, write_as)
    if reads > 1:
        refuse("- is duplicated; there is only one standard input")
    if writes and as_json:
        refuse("--json and - both use standard output; pass a file instead of -")
    if not reads and not writes:
        yield Ends(list(sources), output, {})
        return
    if (reads and sys.stdin is None) or (writes and sys.stdout is None):
        refuse("- needs a standard stream, which this process does not have; pass a name instead of -")
    stdin: Any = getattr(sys.stdin, "buffer", None)
    stdout: Any = getattr(sys.stdout, "buffer", None)
    if reads and is_terminal(stdin):
        refuse("standard input is a terminal; pipe a file into it, or pass a name instead of -")
    if writes and is_terminal(stdout):
        refuse("standard output is a terminal; pipe it into a program or a file, or pass a name instead of -")
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
            refuse(f"a .{write_as} has separate files, which a pipe cannot transfer: pass --to glb, or a name")
        if writes and result.exists():
            _send(result, stdout)


def _send(path: Path, stdout: Any) -> None:
    with path.open("rb") as file:
        try:
            shutil.copyfileobj(file, stdout)
            stdout.flush()
        except OSError as error:
            raise OutputLostError(error.errno, error.strerror, OUTPUT) from error


def _check(option: str, metavar: str, is_pipe: bool, extension: str | None) -> None:
    if is_pipe and extension is None:
        refuse(f"- has no extension; pass its format, such as --{option} ply")
    if extension is not None and not is_pipe:
        refuse(f"--{option} requires - as {metavar}")
