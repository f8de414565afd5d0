"""Run the benchmarks: one table on stdout, progress on stderr, a JSON document under benchmarks/results/.

python benchmarks/run.py [--only OPERATION] [--device cpu|cuda:0] [--quick | --long] [--profile] [--output FILE]
"""

from __future__ import annotations

import argparse
import datetime
import itertools
import json
import os
import platform
import re
import statistics
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parent
TORCH = FOLDER.parent / "build" / "torch" / "bin" / "python"  # .venv with torch, as `make bench` makes it
sys.path.insert(0, str(FOLDER))

from contest import POINTLOOM, Operation, operations, thread_count  # noqa: E402
from report import Row, Timing, collect, document, table  # noqa: E402


def main(arguments: list[str] | None = None) -> int:
    """Run the benchmarks. Returns 0, or 1 if a benchmark failed or results disagreed. A missed target is no failure."""
    try:
        return measure(_options(arguments))
    except KeyboardInterrupt:
        print("Interrupted: what was not written before is not saved.", file=sys.stderr)
        return 130


def measure(options: argparse.Namespace) -> int:
    """Run the selected measurements; returns the exit code."""
    try:
        chosen = choose(options.only)
        if options.device != "cpu":
            from pointloom.core.devices import resolve_device

            resolve_device(options.device)
    except (ValueError, RuntimeError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    os.environ["BENCH_THREADS"] = str(options.threads)
    if options.cold:
        folder = tempfile.TemporaryDirectory(prefix="bench-cache-")
        os.environ |= {"TI_OFFLINE_CACHE_FILE_PATH": folder.name, "WARP_CACHE_PATH": folder.name}
    if options.profile:
        return print_profiles(chosen, options)
    about = describe(options)
    if about["machine"]["load_before"] > 0.5:
        load = about["machine"]["load_before"]
        print(f"This machine is busy (load {load}): times and ratios will be inaccurate.", file=sys.stderr)
    begin = time.monotonic()
    rows, problems = run_timings(chosen, options)
    if not options.quick:
        measure_memory(chosen, rows, options, problems)
    about["seconds"] = round(time.monotonic() - begin, 1)
    with_targets = options.device == "cpu" and not options.quick
    print(table(rows.values(), with_targets=with_targets), flush=True)
    for line in problems["failed"]:
        print(f"FAILED {line}", file=sys.stderr)
    for line in problems["skipped"]:
        print(f"left out {line}", file=sys.stderr)
    is_saved = save(options, about, document(rows.values(), about, problems, with_targets=with_targets))
    if is_saved and options.device == "cpu" and not options.output:
        import speed

        speed.record()  # the ratios that `make speed` expects, from the same machine and code
    return 1 if problems["failed"] or not rows else 0


def _options(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="Benchmarks of pointloom beside the best baselines.")
    parser.add_argument("--only", action="append", metavar="OPERATION", help="an operation or file, or a prefix")
    parser.add_argument("--device", default="cpu", help="device of pointloom: cpu (default) or cuda:0")
    parser.add_argument("--quick", action="store_true", help="test run: small sizes, one lap, no memory")
    parser.add_argument("--long", action="store_true", help="the largest sizes, too")
    parser.add_argument("--profile", action="store_true", help="print pointloom's times by kernel instead")
    parser.add_argument("--cold", action="store_true", help="start with empty kernel caches, to include compilation")
    parser.add_argument("--threads", type=int, default=2, help="threads and cores of every contestant (default 2)")
    parser.add_argument("--output", type=Path, metavar="FILE", help="JSON file; without it quick runs write none")
    options = parser.parse_args(arguments)
    if options.threads < 1:
        parser.error(f"--threads: expected at least 1, got {options.threads}")
    if options.output and not options.output.resolve().parent.is_dir():
        parser.error(f"--output {options.output}: its folder does not exist")
    return options


def choose(only: list[str] | None) -> dict[str, tuple[str, Operation]]:
    """The operations whose name, or file, starts with one of these prefixes."""
    known = operations()
    if not only:
        return known
    chosen = {}
    for prefix in only:
        matching = {
            name: (module, operation)
            for name, (module, operation) in known.items()
            if name.startswith(prefix) or module.removeprefix("bench_").startswith(prefix.removeprefix("bench_"))
        }
        if not matching:
            raise ValueError(f"--only {prefix}: expected a prefix of one of {', '.join(known)}")
        chosen |= matching
    return {name: known[name] for name in known if name in chosen}


def interpreter_of(module: str) -> str:
    """The Python that runs a file of benchmarks: that with torch, if the file needs torch and there is one."""
    return str(TORCH) if module.startswith("bench_torch") and TORCH.exists() else sys.executable


def run_timings(chosen: dict[str, tuple[str, Operation]], options: argparse.Namespace) -> tuple[dict, dict]:
    """Run each file of benchmarks in a separate process, with all contestants in it.

    In a quick run the times are not meaningful, so one process runs all: libraries and kernels are loaded once.
    """
    documents, problems, begin = [], {"failed": [], "skipped": []}, time.monotonic()
    modules = sorted(dict.fromkeys(module for module, _ in chosen.values()), key=interpreter_of)
    parts = [[module] for module in modules]
    if options.quick:
        parts = [list(part) for _, part in itertools.groupby(modules, interpreter_of)]
    for number, part in enumerate(parts, 1):
        names = [name for name, (home, _) in chosen.items() if home in part]
        title = f"{len(part)} files of benchmarks" if len(part) > 1 else part[0]
        minutes, seconds = divmod(int(time.monotonic() - begin), 60)
        print(f"[{number}/{len(parts)}, {minutes}:{seconds:02d}] {title}", file=sys.stderr, flush=True)
        with tempfile.TemporaryDirectory(prefix="bench-") as folder:
            output = Path(folder) / "benchmark.json"
            command = [interpreter_of(part[0]), "-m", "pytest", *(str(FOLDER / f"{module}.py") for module in part)]
            command += ["-q", "-s", "--tb=short"]
            command += [f"--benchmark-json={output}", "--benchmark-quiet", f"--bench-device={options.device}"]
            command += [f"--bench-operation={name}" for name in names] + ["--bench-quick"] * options.quick
            command += ["--bench-long"] * options.long
            done = subprocess.run(command, stdout=subprocess.PIPE, text=True, cwd=FOLDER.parent, check=False)
            is_written = output.exists() and output.stat().st_size > 0
            if is_written:
                documents.append(json.loads(output.read_text()))
                for kind, lines in documents[-1]["problems"].items():
                    problems[kind] += dict.fromkeys(without_folders(line) for line in lines)
            if done.returncode != 0:
                print(done.stdout[-4000:], file=sys.stderr)
                if not is_written or not documents[-1]["problems"]["failed"]:
                    problems["failed"].append(f"{title}: pytest ended with code {done.returncode}")
    return collect(documents), problems


def measure_memory(
    chosen: dict[str, tuple[str, Operation]],
    rows: dict[tuple[str, str], Row],
    options: argparse.Namespace,
    problems: dict,
) -> None:
    """Measure the peak memory of pointloom and the best baseline in separate processes, and add it to the rows.

    With `--long`, that of all contestants.

    On the CPU two processes run at a time: no time is measured here.
    """

    def measure_one(case: tuple[str, str, str, Timing]) -> None:
        name, size, label, timing = case
        module = chosen[name][0]
        command = [interpreter_of(module), str(FOLDER / "memory.py"), module, name, size, label, options.device]
        done = subprocess.run(command, capture_output=True, text=True, cwd=FOLDER.parent, check=False)
        try:
            timing.memory = document_in(done.stdout)["bytes"]
        except (ValueError, KeyError, IndexError):
            reason = (done.stderr.strip().splitlines() or ["no result"])[-1]
            problems["failed"].append(without_folders(f"{name} {size} {label}: peak memory: {reason}"))
            return
        print(f"  {name:18} {size:16} {label:20} {timing.memory / 1e6:10.1f} MB", file=sys.stderr, flush=True)

    cases = []
    for name, (_, operation) in chosen.items():
        size = operation.memory_size or list(operation.sizes(long=options.long))[-1]
        if row := rows.get((name, size)):
            labels = row.timings if options.long else {POINTLOOM, row.best_peer}
            cases += [(name, size, label, timing) for label, timing in row.timings.items() if label in labels]
    with ThreadPoolExecutor(2 if options.device == "cpu" else 1) as pool:
        list(pool.map(measure_one, cases))


def document_in(text: str) -> Any:
    """The JSON document among the output lines of a process; libraries may print more at exit.

    Raises:
        IndexError: There is none.
    """
    return json.loads([line for line in text.splitlines() if line.startswith(("{", "[{"))][-1])


def without_folders(line: str) -> str:
    """The line with absolute paths replaced by file names."""
    return re.sub(r"/(?:[^\s/:'\"()]+/)+", "", line)


def print_profiles(chosen: dict[str, tuple[str, Operation]], options: argparse.Namespace) -> int:
    """Print pointloom's times by kernel, each operation and size in a separate process."""
    code = 0
    for name, (module, operation) in chosen.items():
        for size in operation.sizes(quick=options.quick, long=options.long):
            command = [interpreter_of(module), str(FOLDER / "launches.py"), name, size, options.device]
            code |= subprocess.run(command, cwd=FOLDER.parent, check=False).returncode != 0
    return int(code)


# ------------------------------------------------------------------------------------------------ about the run


def describe(options: argparse.Namespace) -> dict[str, Any]:
    """The machine, versions and commit, without names of hosts or folders."""
    commit = git("rev-parse", "--short=12", "HEAD")
    return {
        "device": options.device,
        "date": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
        "commit": commit or "unknown",
        "dirty": bool(git("status", "--porcelain")) if commit else None,
        "quick": options.quick,
        "long": options.long,
        "kernel_caches": "empty" if options.cold else "as found",
        "machine": machine(options.device),
        "versions": versions_by(interpreter_of("bench_torch_neighbors")),
    }


def versions_by(python: str) -> dict[str, str]:
    """Versions of the libraries that a Python finds."""
    call = "import json, contest; print(json.dumps(contest.versions()))"
    done = subprocess.run([python, "-c", call], capture_output=True, text=True, cwd=FOLDER, check=True)
    return document_in(done.stdout)


def machine(device: str) -> dict[str, Any]:
    """Machine properties that the times depend on."""
    cpu = platform.processor() or platform.machine()
    memory = None
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        cpu = next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), cpu)
        memory = round(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30, 1)
    except OSError:
        pass
    facts = {
        "cpu": cpu,
        "cores": os.cpu_count(),
        "threads": thread_count(),
        "memory_gib": memory,
        "load_before": round(os.getloadavg()[0], 2),
        "python": platform.python_version(),
        "system": f"{platform.system()} {platform.release()}",
    }
    if device.startswith("cuda"):
        from pointloom.core.devices import resolve_device

        facts["gpu"] = resolve_device(device).name
    return facts


def git(*arguments: str) -> str:
    """The output of a git command; empty if it fails."""
    try:
        done = subprocess.run(["git", *arguments], capture_output=True, text=True, cwd=FOLDER, check=False)
    except OSError:
        return ""
    return done.stdout.strip() if done.returncode == 0 else ""


def in_own_process(command: list[str], seconds: float, **variables: str) -> tuple[Any, str | None]:
    """The JSON document that a command prints, and the error, one of them None. `variables` are added to the
    environment."""
    environment = os.environ | variables
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=seconds, check=False, env=environment)
    except subprocess.TimeoutExpired:
        return None, f"more than {seconds:.0f} s"
    if done.returncode:
        lines = done.stderr.strip().splitlines() or [f"ended by signal {-done.returncode}"]
        return None, lines[-1][:200]
    return document_in(done.stdout), None


def continued(path: Path, about: dict[str, Any] | None = None) -> dict[str, Any]:
    """The saved run of the same commit on the same processor, else a new one without rows."""
    facts = {
        "date": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
        "commit": git("rev-parse", "HEAD"),
        "machine": machine("cpu"),
    }
    if path.exists():
        saved = json.loads(path.read_text())
        known = saved["about"]
        if (known["commit"], known["machine"]["cpu"]) == (facts["commit"], facts["machine"]["cpu"]):
            return saved
    return {"about": facts | (about or {}), "rows": {}}


def write_json(path: Path, content: dict[str, Any]) -> None:
    from pointloom.core.atomic import atomic_write

    with atomic_write(path) as file:
        file.write((json.dumps(content, indent=1) + "\n").encode())


def save(options: argparse.Namespace, about: dict[str, Any], content: dict[str, Any]) -> bool:
    """Write the document atomically to `--output`; without it, replace the device's results after a complete run.

    Returns:
        True if it was written.
    """
    path = options.output
    if path is None:
        if options.quick or options.only:
            return False
        device = about["device"].replace(":", "")
        path = FOLDER / "results" / f"operations-{device}.json"
        path.parent.mkdir(exist_ok=True)
        if path.exists():
            content["other_processors"] = other_processors(content, json.loads(path.read_text()))
    write_json(path, content)
    print(f"Wrote {os.path.relpath(path)}", file=sys.stderr)
    return True


def other_processors(content: dict[str, Any], before: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """The last runs on other processors than that of a run, by processor: date, commit, rows, rows ahead, median."""
    ratios = [row["ratio"] for row in before["results"] if "ratio" in row]
    last = {key: before[key] for key in ("date", "commit")}
    last |= {"rows": len(ratios), "ahead": sum(ratio >= 1 for ratio in ratios), "median": statistics.median(ratios)}
    known = {**before.get("other_processors", {}), before["machine"]["cpu"]: last}
    return {cpu: about for cpu, about in known.items() if cpu != content["machine"]["cpu"]}


if __name__ == "__main__":
    sys.exit(main())
