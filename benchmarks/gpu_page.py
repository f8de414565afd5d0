"""The tables of docs/gpu.md, from counts before and now."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from gpu_chips import CHIPS, H200, Chip, chip_named
from gpu_host import measured_hosts
from gpu_kit.documents import newest_runs
from gpu_operations import OPERATIONS
from gpu_prediction import Predicted, predict
from gpu_results import BEFORE, kept, newest

PAGE = Path(__file__).parents[1] / "docs" / "gpu.md"
SHOWN = [chip_named(name) for name in CHIPS if name != "rtx-5090"]  # columns; `gpu_model.py --chip` has them all
BEGIN, END = "<!-- gpu_model: begin -->", "<!-- gpu_model: end -->"


def _predictions(
    all_counts: list[dict[str, Any]], chip: Chip = H200, hosts: dict[str, float] | None = None
) -> dict[tuple[str, int], Predicted]:
    hosts = hosts or {}
    return {(c["operation"], c["size"]): predict(c, chip, hosts.get(c["operation"])) for c in all_counts}


def _milliseconds(seconds: float) -> str:
    return f"{1e3 * seconds:.3g}"


def _number(x: float) -> str:
    for limit, unit in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if x >= limit:
            return f"{x / limit:.3g}{unit}"
    return f"{x:.3g}"


def _totals(found: Predicted) -> dict[str, Any]:
    rows = list(found.rows.values())
    statements, requests = sum(r.statements for r in rows), sum(r.requests for r in rows)
    slowest = max(found.rows.items(), key=lambda item: item[1].seconds)
    bounds = slowest[1].bounds
    return {
        "instructions": sum(r.instructions for r in rows),
        "active": sum(r.lane_statements for r in rows) / (32 * statements) if statements else 0.0,
        "sectors": sum(r.sectors for r in rows) / requests if requests else 0.0,
        "l2": sum(r.l2_bytes for r in rows),
        "memory": sum(r.memory_bytes for r in rows),
        "local": sum(r.local_bytes for r in rows),
        "launches": sum(r.launches for r in rows),
        "slowest": slowest[0],
        "occupancy": slowest[1].occupancy,
        "bound": max(bounds, key=lambda k: bounds[k]) if bounds else "bandwidth",
    }


def _both(before: str, now: str) -> str:
    return now if before in ("", now) else f"{before} → {now}"


def measured_cell(runs: dict[str, dict[str, Any]], key: str, name: str) -> str:
    """A figure of the newest run of each GPU; figures that nobody measured are words."""
    found = [
        f"{operation[name]:.3g} ({chip})"
        for chip, run in runs.items()
        if name in (operation := run.get("operations", {}).get(key, {}))
    ]
    return ", ".join(found) or "not measured"


def times_table() -> list[str]:
    """Predicted times before and now, beside what was measured, what was asked for and what is possible."""
    before, runs = _predictions(kept(BEFORE)), newest_runs()
    hosts = measured_hosts()
    now = {chip.name: _predictions(newest(), chip, hosts) for chip in SHOWN}
    titles = " | ".join(f"{chip.title} now" for chip in SHOWN)
    lines = [
        f"| operation | size | device ms, {H200.title} before | {titles} | measured | asked | limit | now / limit"
        " | caller ms now | measured | waits | limit by |",
        "|---" * (11 + len(SHOWN)) + "|",
    ]
    for operation in OPERATIONS.values():
        for size in operation.sizes:
            key = (operation.name, size)
            old, new = before.get(key), now[H200.name].get(key)
            last = new or old
            if last is None:
                continue
            limit, name = operation.limit(size), f"{operation.name} {size}"
            asked = f"{operation.bar:g}" if operation.bar and size == operation.bar_size else ""
            cells = [operation.name, f"{size:,}", _milliseconds(old.timeline.device) if old else ""]
            cells += [_milliseconds(now[c.name][key].timeline.device) if key in now[c.name] else "" for c in SHOWN]
            cells += [measured_cell(runs, name, "device_ms"), asked, _milliseconds(limit)]
            cells += [f"{new.timeline.device / limit:.3g}" if new else "", _milliseconds(last.timeline.call)]
            cells += [measured_cell(runs, name, "caller_ms"), str(last.timeline.waits), operation.why]
            lines.append(f"| {' | '.join(cells)} |")
    return lines


def counts_table() -> list[str]:
    """What was counted, before and now."""
    before, now = _predictions(kept(BEFORE)), _predictions(newest())
    lines = [
        "| operation | size | warp instructions | active lanes | sectors a request | L2 B | memory B | local B"
        " | launches | slowest kernel | its warps there | bound by |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for key in ((o.name, size) for o in OPERATIONS.values() for size in o.sizes if (o.name, size) in {**before, **now}):
        old = _totals(before[key]) if key in before else {}
        new = _totals(now[key]) if key in now else old
        cells = [key[0], f"{key[1]:,}"]
        forms = (
            *(("instructions", _number), ("active", lambda x: f"{100 * x:.0f} %"), ("sectors", lambda x: f"{x:.1f}")),
            *(("l2", _number), ("memory", _number), ("local", _number), ("launches", str), ("slowest", str)),
            *(("occupancy", lambda x: f"{100 * x:.2g} %"), ("bound", str)),
        )
        cells += [_both(form(old[name]) if old else "", form(new[name])) for name, form in forms]
        lines.append(f"| {' | '.join(cells)} |")
    return lines


def write_page() -> None:
    """Put the tables between the marks of docs/gpu.md."""
    text = PAGE.read_text()
    start, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    tables = "\n".join(["", *times_table(), "", *counts_table(), ""])
    PAGE.write_text(text[:start] + tables + text[end:])
