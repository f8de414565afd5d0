"""Run commands and return their output."""

import json
import re
from pathlib import Path

from click.testing import CliRunner, Result

from pointloom.cli.shell.cli import cli
from pointloom.core.devices import resolve_device


def run(*words: object, content: bytes | None = None) -> Result:
    """Run a command, with this standard input, and return its exit code and output."""
    return CliRunner().invoke(cli, [str(word) for word in words], input=content)


def output_of(*words: object) -> str:
    """Run a command, which must succeed, and return what it prints."""
    result = run(*words)
    assert result.exit_code == 0, result.stderr
    return result.stdout


def answer(*words: object) -> dict:
    """Run a command with --json, which must succeed, and return its report."""
    return json.loads(output_of(*words, "--json"))


def unreliable(*words: object) -> dict:
    """Run a command with --json, whose result must be unreliable, and return its report."""
    result = run(*words, "--json")
    assert result.exit_code == 3, result.stderr
    report = json.loads(result.stdout)
    lines = [line for line in result.stderr.splitlines() if not line.startswith("intermediate files: ")]
    printed, stored = "\n".join(lines), "\n".join(f"unreliable result: {warning}" for warning in report["warnings"])
    assert in_arguments(printed) == in_arguments(stored)
    return report


def in_arguments(text: str) -> str:
    """A message with arguments of Python instead of options: `--depth-scale 1000` and `depth_scale=1000` are equal."""
    text = re.sub(r"--([a-z]+(?:-[a-z]+)*)", lambda found: found[1].replace("-", "_"), text)
    return re.sub(r"([a-z])=", r"\1 ", text)


def names_in(folder: Path) -> list[str]:
    return sorted(entry.name for entry in folder.iterdir())


def refusal(*words: object) -> str:
    """Run a command, which must end with an error, and return its stderr."""
    result = run(*words)
    assert result.exit_code == 1, result.stdout
    assert result.stdout == ""
    return result.stderr


def chosen_device() -> str:
    """The default device of commands: the first GPU, else the CPU."""
    return str(resolve_device("auto"))
