"""Command group with exit codes, one-line errors, and suggestions for misspelled commands.

Exit codes: 0 done, 1 error, 2 usage error, 3 unreliable result, 130 interrupted. A command returns its code (None for
0) or raises the library's errors.
"""

from __future__ import annotations

import contextlib
import os
import sys
import warnings
from collections.abc import Iterable, Sequence
from typing import Any

import click

from ...core.errors import FileError
from ...core.escaped_text import escaped
from ...kernels.language.environment import check_environment
from .command_words import in_options
from .console import Notices, OutputLostError, is_quiet, print_json
from .options import COMMAND, VERBOSITY

ERROR_CODE, USAGE_CODE, UNRELIABLE_CODE, INTERRUPTED_CODE, TERMINATED_CODE = 1, 2, 3, 130, 143

TRACEBACK = "POINTLOOM_TRACEBACK"

_NoCommand: Any = getattr(click.exceptions, "NoArgsIsHelpError", ())  # click 8.1 prints the help and exits by itself


class Commands(click.Group):
    """A click group of commands with the options -q and -v."""

    def add_command(self, cmd: click.Command, name: str | None = None) -> None:
        if not isinstance(cmd, click.Group):
            VERBOSITY(cmd)
        super().add_command(cmd, name)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        names = self.list_commands(ctx)
        if args[0] in names or args[0].startswith("-"):
            return super().resolve_command(ctx, args)
        from difflib import get_close_matches

        near = get_close_matches(args[0].lower(), names, n=1, cutoff=0.5)
        hint = f"did you mean {near[0]}?" if near else f"the commands are {', '.join(names)}"
        raise click.UsageError(f"no command {args[0]!r}; {hint}", ctx)


class CommandLine(Commands):
    """A click group that turns exceptions into one line on stderr and an exit code."""

    _context: click.Context | None = None

    def main(
        self,
        args: Sequence[str] | None = None,
        prog_name: str | None = None,
        complete_var: str | None = None,
        standalone_mode: bool = True,
        **extra: Any,
    ) -> Any:
        words = list(sys.argv[1:] if args is None else args)
        self._context = None
        try:
            with warnings.catch_warnings(), Notices():
                warnings.showwarning = _show_warning
                if words[:1] != ["doctor"]:  # which reports a wrong value
                    check_environment()
                code = super().main(words, prog_name or "pointloom", complete_var, standalone_mode=False, **extra)
        except _NoCommand as error:  # no command: show the help
            click.echo(error.ctx.get_help())
            code = 0
        except Exception as error:
            with self._command_context():
                code, message = _exit_code(error), report_error(error)
            if isinstance(error, click.UsageError) and error.ctx is not None:
                click.echo(f"See '{error.ctx.command_path} --help'.", err=True)
            if "--json" in words:
                with contextlib.suppress(OutputLostError):
                    print_json({"error": message, "exit_code": code})
        sys.exit(_flushed(code or 0))

    def make_context(self, *words: Any, **extra: Any) -> click.Context:
        self._context = super().make_context(*words, **extra)
        return self._context

    def _command_context(self) -> contextlib.AbstractContextManager[Any]:
        """The context of the command that has ended, for its options."""
        context = self._context and self._context.meta.get(COMMAND)
        return contextlib.nullcontext() if context is None else context.scope(cleanup=False)


def exit_code(warnings: Iterable[str]) -> int:
    """Exit code of a result: 3, with the warnings on stderr, if there are any. Else 0."""
    lines = [escaped(f"unreliable result: {in_options(warning)}", lines=True) for warning in warnings]
    for line in lines:
        click.echo(line, err=True)
    return UNRELIABLE_CODE if lines else 0


def report_error(error: Exception) -> str:
    """Print an error on stderr, with the traceback if requested. Returns the message."""
    if os.environ.get(TRACEBACK) == "1":
        import traceback

        traceback.print_exception(error, file=sys.stderr)
    message = escaped(_message(error), lines=True)
    click.echo(message if isinstance(error, click.Abort) else f"error: {message}", err=True)
    return message


def _flushed(code: int) -> int:
    """The exit code after flushing output. 1 if that fails.

    Unwritable output is dropped: Python would retry at exit and print its own message.
    """
    if sys.stdout is None:
        return code
    try:
        sys.stdout.flush()
    except OSError:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        return code or ERROR_CODE
    return code


def _unknown_option(given: str, ctx: click.Context) -> str:
    """Message for an unknown option: similar ones, other commands that have it, and all options."""
    from difflib import get_close_matches

    own = _options_of(ctx.command)
    message = f"no option {given} of {ctx.command_path}"
    near = get_close_matches(given, own, n=2, cutoff=0.7)
    if near:
        return f"{message}; did you mean {' or '.join(near)}?"
    others = _commands_like(ctx, given)
    elsewhere = f", which {' and '.join(others)} {'have' if len(others) > 1 else 'has'}" if others else ""
    return f"{message}{elsewhere}; its options are {', '.join(option for option in own if option.startswith('--'))}"


def _commands_like(ctx: click.Context, option: str) -> list[str]:
    """Commands with the same input and output types that have an option."""
    group = None if ctx.parent is None else ctx.parent.command
    if not isinstance(group, click.Group):
        return []

    def ends(command: click.Command) -> list[str | None]:
        return [one.name for one in command.params if isinstance(one, click.Argument)]

    alike = [name for name, command in sorted(group.commands.items()) if ends(command) == ends(ctx.command)]
    return [name for name in alike if option in _options_of(group.commands[name])]


def _options_of(command: click.Command) -> list[str]:
    options = [one for one in command.params if isinstance(one, click.Option) and not one.hidden]
    return [name for option in options for name in (*option.opts, *option.secondary_opts)]


def _exit_code(error: Exception) -> int:
    if isinstance(error, click.UsageError):
        return USAGE_CODE
    return INTERRUPTED_CODE if isinstance(error, click.Abort) else ERROR_CODE


def _message(error: Exception) -> str:
    if isinstance(error, click.Abort):
        return "interrupted"
    if isinstance(error, click.NoSuchOption) and error.ctx is not None:
        return _unknown_option(error.option_name, error.ctx)
    if isinstance(error, click.ClickException):
        text = error.format_message().rstrip(".")
        return text[:1].lower() + text[1:]
    if isinstance(error, MemoryError):
        what = f": {error}" if str(error) else ""
        return f"out of memory{what}. A larger --voxel, a smaller --depth-max or fewer frames (--every) need less"
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename}: {error.strerror}" if error.filename else error.strerror
    is_own_error = type(error).__module__.startswith("pointloom.") or str(error).startswith("POINTLOOM_")
    if is_own_error or isinstance(error, ValueError | TypeError | OSError):
        text, name = str(error) or type(error).__name__, escaped(error.path) if isinstance(error, FileError) else ""
        return name + in_options(text.removeprefix(name))  # a file keeps its name
    return (
        f"unexpected {type(error).__name__}: {error}. This is a bug in pointloom; "
        f"set {TRACEBACK}=1 and report the error with the traceback"
    )


def _show_warning(
    message: Warning | str, category: Any, filename: str, lineno: int, file: Any = None, line: str | None = None
) -> None:
    if is_quiet():
        return
    click.echo(escaped(f"warning: {in_options(str(message))}", lines=True), err=True)
