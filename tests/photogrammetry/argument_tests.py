"""Tests of a table of public calls: good arguments are accepted, hostile ones are rejected by name."""

from collections.abc import Callable
from typing import Any

import pytest

from ..hostile import TORCH_CPU, faults_of

Table = dict[str, tuple[str, dict[str, str]]]


def call_of(table: Table, name: str, things: dict[str, Any]) -> tuple[Callable[..., Any], dict[str, Any]]:
    """A call of the table and its good arguments. An output `new()` is another one in each call."""
    function, expressions = table[name]
    good = {key: eval(value, dict(things)) for key, value in expressions.items()}

    def call(**given: Any) -> Any:
        outputs = [key for key, value in expressions.items() if value == "new()" and given[key] is good[key]]
        return eval(function, dict(things))(**given | {key: things["new"]() for key in outputs})

    return call, good


def argument_tests(table: Table) -> tuple[Callable[..., None], Callable[..., None]]:
    """The two tests of a table. They need a fixture `things`, the names in its expressions."""

    @pytest.mark.parametrize("name", table)
    def accepts(name: str, things: dict[str, Any]) -> None:
        call, good = call_of(table, name, things)
        call(**good | ({"device": TORCH_CPU} if "device" in good else {}))

    @pytest.mark.parametrize(("name", "argument"), [(name, key) for name, (_, given) in table.items() for key in given])
    def rejects(name: str, argument: str, things: dict[str, Any], tmp_path: Any, monkeypatch: Any) -> None:
        monkeypatch.chdir(tmp_path)  # where a string of digits is a good name of a file
        faults = faults_of(*call_of(table, name, things), argument)
        assert not faults, "\n".join(faults)

    return accepts, rejects
