"""Counts of operations as files: small enough to be kept beside the project."""

from __future__ import annotations

import datetime
import itertools
import json
from pathlib import Path
from typing import Any

RESULTS = Path(__file__).parent / "results"
BEFORE = RESULTS / "gpu-model-before.json"  # of commit 7a4e84e, before kernels were shaped for a GPU
ONE_BY_ONE = 8  # launches of a kernel that are kept one by one; of the others their mean
MANY, FEWER = 100, 1  # launches of a call from which on fewer are
DIGITS = 4


def todays_file() -> Path:
    """Where the counts of today go."""
    return RESULTS / f"gpu-model-{datetime.date.today():%Y-%m-%d}.json"


def newest() -> list[dict[str, Any]]:
    """The newest counts of each operation and size, those from before left out."""
    found = {}
    for file in sorted(RESULTS.glob("gpu-model-2*.json")):
        found |= {(counts["operation"], counts["size"]): counts for counts in kept(file)}
    return list(found.values())


def kept(file: Path) -> list[dict[str, Any]]:
    """The counts of a file."""
    return [_filled(counts) for counts in json.loads(file.read_text())]


def keep(file: Path, counts: dict[str, Any]) -> None:
    """Add the counts of a call to a file; they take the place of older ones of the same operation and size."""
    there = json.loads(file.read_text()) if file.exists() else []
    key = counts["operation"], counts["size"]
    there = [x for x in there if (x["operation"], x["size"]) != key] + [_short(counts)]
    there.sort(key=lambda x: (x["operation"], x["size"]))
    lines = ",\n".join(json.dumps(x, separators=(",", ":")) for x in there)
    file.write_text(f"[\n{lines}\n]\n")


def merged(launches: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The first launches of each kernel and kind, and the mean of its others as one that stands for several."""
    found, seen, others = [], {}, {}
    kept_alone = ONE_BY_ONE if len(launches) <= MANY else FEWER
    for x in launches:
        kind = kind_of(x)
        seen[kind] = seen.get(kind, 0) + 1
        if seen[kind] <= kept_alone:
            found.append(x)
            continue
        if kind not in others:
            others[kind] = []
            found.append({"rest of": kind})
        others[kind].append(x)
    return [_mean(others[x["rest of"]]) if "rest of" in x else x for x in found]


def kind_of(x: dict[str, Any]) -> tuple[Any, ...]:
    """What launches have in common whose mean can stand for them: of one kernel, in a graph or not, of like sizes."""
    size = x["blocks"] or x["bytes_read"] + x["bytes_written"]
    return x["kernel"], x["in_graph"], size.bit_length()


def _mean(all_of: list[Any]) -> Any:
    """Numbers by their mean, dictionaries field by field, all else as in the first."""
    first = all_of[0]
    if isinstance(first, dict):
        missing = {k: {} if isinstance(v, dict) else 0 for x in all_of for k, v in x.items()}
        mean = {k: _mean([x.get(k, missing[k]) for x in all_of]) for k in sorted(missing)}
        if "kernel" in mean:
            mean["times"] = len(all_of)
        return mean
    if isinstance(first, list) and all(isinstance(v, (int, float)) for x in all_of for v in x):
        return [sum(column) / len(all_of) for column in itertools.zip_longest(*all_of, fillvalue=0.0)]
    if isinstance(first, bool) or not isinstance(first, (int, float)):
        return first
    mean = sum(all_of) / len(all_of)
    return max(1, round(mean)) if isinstance(first, int) and first else mean


def _short(value: Any) -> Any:
    """Without what is zero or empty, and with a few digits."""
    if isinstance(value, dict):
        told = {k: v for k, v in value.items() if v not in (0, 0.0, "", {}, [], False) and (k, v) != ("imbalance", 1.0)}
        return {k: _short(v) for k, v in told.items()}
    if isinstance(value, list):
        return [_short(v) for v in value]
    return float(f"{value:.{DIGITS}g}") if isinstance(value, float) else value


def _filled(counts: dict[str, Any]) -> dict[str, Any]:
    """With what was left out."""
    zero = {
        **{"symbol": "", "blocks": 0, "threads": 0, "shared_bytes": 0, "in_graph": False, "units": {}, "traffic": {}},
        **{"lane_statements": 0.0, "warp_statements": 0.0, "chain": 0.0, "hits": 0.0, "misses": 0.0, "imbalance": 1.0},
        **{"own_sectors": 0.0, "own_loads": 0.0, "own_stores": 0.0, "issued_by_depth": [], "code_by_depth": []},
        **{"memory_reads": 0, "memory_writes": 0, "bytes_read": 0, "bytes_written": 0, "nodes": 0, "hot_atomics": 0.0},
    }
    fields = dict.fromkeys(("requests", "lanes", "bytes", "sectors", "wavefronts", "missed"), 0.0)
    launches = [
        {**zero, **x, "traffic": {name: {**fields, **t} for name, t in x.get("traffic", {}).items()}}
        for x in counts["launches"]
    ]
    return {**counts, "launches": launches, "host": counts.get("host", {}), "resources": counts.get("resources", {})}
