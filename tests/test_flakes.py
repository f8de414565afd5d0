"""The list of flakes names each test whose outcome differed; tests of pages wait for events, not for time to pass."""

import re
from pathlib import Path

import pytest

from .flakes import Outcomes, report_on

TESTS = Path(__file__).parent
FAILURE, ERROR = '<failure message="assert 1 == 2&#10;more"/>', '<error message="no page"/>'
SKIP, RETRY = '<skipped message="no GPU"/>', '<properties><property name="flake" value="it was late"/></properties>'


def outcomes_of(*runs: dict[str, str]) -> Outcomes:
    outcomes = Outcomes()
    for run in runs:
        cases = "".join(
            f'<testcase classname="tests.a" name="{name}">{inner}</testcase>' for name, inner in run.items()
        )
        outcomes.add(f"<testsuites><testsuite>{cases}</testsuite></testsuites>")
    return outcomes


@pytest.mark.parametrize(
    ("runs", "expected"),
    [
        (["", ""], None),
        ([SKIP, SKIP], None),
        (["", FAILURE], {"passed": 1, "failed": 1}),
        ([ERROR, "", ""], {"error": 1, "passed": 2}),
        (["", SKIP], {"passed": 1, "skipped": 1}),
        ([RETRY], {"retried": 1}),
        ([FAILURE, FAILURE], {"failed": 2}),
        ([None, ""], {"absent": 1, "passed": 1}),
        (["", None], {"passed": 1, "absent": 1}),
    ],
)
def test_each_difference_retry_and_failure_is_listed(runs, expected, capsys, tmp_path):
    outcomes = outcomes_of(*({"other": ""} | ({} if run is None else {"t": run}) for run in runs))
    assert outcomes.differing() == ({} if expected is None else {"tests.a::t": expected})
    assert report_on(outcomes, [], tmp_path) == (expected is not None)
    told = capsys.readouterr().out
    assert ("DIFFERS tests.a::t" in told, "it was late" in told) == (expected is not None, RETRY in runs)
    assert ("skipped: 1 tests: no GPU" in told) == (runs[-1] == SKIP)


def test_a_failing_teardown_counts_and_runs_without_a_report_are_failures(tmp_path):
    outcomes = Outcomes()
    case = '<testcase classname="a" name="t">{}</testcase>'
    outcomes.add(f"<testsuite>{case.format('')}{case.format(ERROR)}</testsuite>")
    assert outcomes.tests == {"a::t": ["error"]}
    assert report_on(Outcomes(), [], tmp_path) == report_on(outcomes_of({"t": ""}), ["run 1"], tmp_path) == 1


@pytest.mark.parametrize("folder", ["browser", "drawing/viewer"])
def test_tests_of_pages_wait_for_no_time_to_pass(folder):
    found = [
        f"{path.relative_to(TESTS)}:{number}"
        for path in sorted((TESTS / folder).rglob("*.py"))
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if re.search(r"wait_for_timeout|\bsleep\(", line)
    ]
    assert found == [], "wait for an event: tests/drawing/viewer/events.py, ready() of tests/browser/pixels.py"
