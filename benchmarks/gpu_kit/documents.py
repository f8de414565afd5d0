"""Results of a run: one part per step during the run, one document per GPU at its end, written atomically.

A part names its device. Parts of the emulated device are never written to a document.
"""

from __future__ import annotations

import datetime
import json
import subprocess
from pathlib import Path
from typing import Any

from gpu_kit.device import EMULATED, ROOT, Device, EmulatedDeviceError, chip_of
from gpu_kit.records import NAMES, recorded

RESULTS = ROOT / "benchmarks" / "results"
FORMAT = 1


def write_json(path: Path, content: Any) -> None:
    """Write a document atomically."""
    from pointloom.core.atomic import atomic_write

    path.parent.mkdir(parents=True, exist_ok=True)
    with atomic_write(path) as file:
        file.write((json.dumps(content, indent=1, sort_keys=True) + "\n").encode())


def keep_part(state: Path, device: Device, name: str, content: Any) -> None:
    """Save the results of a step so far, replacing its previous ones."""
    from pointloom.kernels.language.compiled_ahead import digest_of_sources

    about = {"device": device.as_json(), "sources of kernels": digest_of_sources()}
    write_json(state / "parts" / f"{name}.json", {**about, "content": content})


def saved_part(state: Path, name: str) -> dict[str, Any]:
    """The results of a step so far."""
    path = state / "parts" / f"{name}.json"
    return json.loads(path.read_text())["content"] if path.exists() else {}


def saved_runs() -> list[dict[str, Any]]:
    """The documents of all runs, the oldest first."""
    return sorted(
        (json.loads(path.read_text()) for path in RESULTS.glob("gpu-run-*.json")), key=lambda run: run["date"]
    )


def chip_of_run(run: dict[str, Any]) -> str:
    """Short name of the chip of a run's document."""
    return chip_of(run["device"]["name"])


def last_measured(*part: str, chip: str, field: str = "") -> dict[str, tuple[str, str]]:
    """Date and commit of the newest run of a chip with a result, by entry of a part.

    Args:
        part: Names of the part in a run's document.
        chip: Short name of the chip: times of another one are not compared.
        field: The entry must have this field. Entries with an error do not count.
    """
    found: dict[str, tuple[str, str]] = {}
    for run in saved_runs():
        if chip_of_run(run) != chip:
            continue
        entries: Any = run
        for name in part:
            entries = entries.get(name, {})
        for name, entry in entries.items():
            failed = isinstance(entry, dict) and "error" in entry
            if not failed and (not field or field in entry):
                found[name] = (run["date"], run["commit"][:7])
    return found


def refuse_emulated(device: dict[str, Any]) -> None:
    """Raise an error for the emulated device.

    Raises:
        EmulatedDeviceError: The device is the emulated one, or has no name.
    """
    name = str(device.get("name", ""))
    if not name or EMULATED in name.lower():
        raise EmulatedDeviceError(f"{name or 'a device without a name'}: measurements of it are not saved")


def collected(state: Path) -> dict[str, Any]:
    """The document of a run, from its parts.

    Raises:
        EmulatedDeviceError: A part is of the emulated device.
        ValueError: There are no parts, or they are of different devices or kernel sources.
    """
    parts = {path.stem: json.loads(path.read_text()) for path in sorted((state / "parts").glob("*.json"))}
    if not parts:
        raise ValueError(f"{state}: no step has saved results")
    for part in parts.values():
        refuse_emulated(part["device"])
    first, *others = parts.values()
    for about in ("device", "sources of kernels"):
        if any(part[about] != first[about] for part in others):
            raise ValueError(f"{state}: the parts have different {about}. Repeat the run with another --state")
    commit, dirty = _commit()
    return {
        "format": FORMAT,
        "device": first["device"],
        "sources of kernels": first["sources of kernels"],
        "date": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
        "commit": commit,
        "dirty": dirty,
        **{name: content for name in NAMES if (content := recorded(state, name))},
        **{name: part["content"] for name, part in parts.items()},
    }


def keep(state: Path, folder: Path = RESULTS) -> Path:
    """Write the document of a run; returns its path.

    Raises:
        EmulatedDeviceError, ValueError: As in `collected`.
    """
    document = collected(state)
    chip = chip_of(document["device"]["name"])
    path = folder / f"gpu-run-{chip}-{document['date'][:10]}-{document['commit'][:7]}.json"
    write_json(path, document)
    return path


def _commit() -> tuple[str, bool | None]:
    def git(*words: str) -> str:
        try:
            done = subprocess.run(["git", *words], capture_output=True, text=True, cwd=ROOT, check=False)
        except OSError:
            return ""
        return done.stdout.strip() if done.returncode == 0 else ""

    commit = git("rev-parse", "--short=12", "HEAD")
    return commit or "unknown", bool(git("status", "--porcelain")) if commit else None
