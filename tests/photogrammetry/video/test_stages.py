"""A stage is complete or absent, and is remade only if its inputs changed."""

import errno
import os

import pytest

from pointloom.core.errors import FileError
from pointloom.core.stages import Chain, Stage

from ...interruptions import run_lines

NAMES = ("first", "second", "third")


class Job:
    """Three stages: each appends a setting to the text of the previous one."""

    def __init__(self, root, *, resume=True, **settings):
        root.mkdir(exist_ok=True)
        self.settings = {"first": "a", "second": "b", "third": "c"} | settings
        self.ran, self.reported = [], []
        self.chain = Chain(root, NAMES, resume=resume, progress=lambda *step: self.reported.append(step))

    def run(self):
        made = None
        for name in NAMES:
            made = self.chain.run(self.stage(name, () if made is None else (made,)))
        return self.chain.made

    def stage(self, name, after):
        def make(folder, report):
            self.ran.append(name)
            report("letter", 1, 2)
            before = "".join((made.folder / "deep" / "text").read_text() for made in after)
            (folder / "deep").mkdir()
            # only the letter counts, not its case: another setting may give the same files
            (folder / "deep" / "text").write_text(before + self.settings[name].lower())
            return {"length": len(before) + 1, "share": float("nan")}

        return Stage(name, make, {"letter": self.settings[name]}, after)


def files_in(root):
    """All files but the records, which contain times."""
    paths = (path for path in root.rglob("*") if path.is_file() and path.parent.name != "records")
    return {path.relative_to(root).as_posix(): path.read_bytes() for path in paths}


def test_a_finished_job_is_reused(tmp_path):
    first = Job(tmp_path)
    made = first.run()
    assert first.ran == [*NAMES]
    again = Job(tmp_path)
    reused = again.run()
    assert again.ran == []
    assert [m.is_reused for m in made.values()] == [False] * 3
    assert [m.is_reused for m in reused.values()] == [True] * 3
    assert [m.report for m in reused.values()] == [m.report for m in made.values()]
    assert [m.cost for m in reused.values()] == [m.cost for m in made.values()]
    assert made["third"].report == {"length": 3, "share": None}
    assert set(made["third"].cost) == {"seconds", "cpu_seconds", "peak_bytes"}
    assert (tmp_path / "third" / "deep" / "text").read_text() == "abc"
    assert first.reported == [(f"{name}: letter", 1, 2) for name in NAMES]


@pytest.mark.parametrize(
    ("changed", "ran"),
    [
        ({"first": "x"}, ["first", "second", "third"]),
        ({"second": "x"}, ["second", "third"]),
        ({"third": "x"}, ["third"]),
        ({"first": "A"}, ["first"]),  # another setting that gives the same file: later stages are reused
        ({}, []),
    ],
)
def test_only_what_changed_is_made_again(tmp_path, changed, ran):
    Job(tmp_path / "resumed").run()
    job = Job(tmp_path / "resumed", **changed)
    job.run()
    assert job.ran == ran
    Job(tmp_path / "whole", **changed).run()
    assert files_in(tmp_path / "resumed") == files_in(tmp_path / "whole")


@pytest.mark.parametrize("damage", ["cut off", "removed", "record cut off", "record removed", "folder removed"])
def test_a_damaged_stage_is_made_again(tmp_path, damage):
    Job(tmp_path).run()
    complete, text, record = files_in(tmp_path), tmp_path / "second/deep/text", tmp_path / "records/second.json"
    if damage == "cut off":
        text.write_text("a")
    elif damage == "record cut off":
        record.write_text(record.read_text()[:40])
    elif damage == "folder removed":
        text.unlink()
        text.parent.rmdir()
        text.parent.parent.rmdir()
    else:
        (record if "record" in damage else text).unlink()
    job = Job(tmp_path)
    job.run()
    assert job.ran == ["second"]  # bitwise identical: the third is reused
    assert files_in(tmp_path) == complete


def test_another_version_of_a_stage_makes_it_again(tmp_path):
    chain = Job(tmp_path).chain
    ran = []
    for version in (1, 1, 2):
        chain.run(Stage("first", lambda folder, report, v=version: ran.append(v) or {}, version=version))
    assert ran == [1, 2]


def test_stages_of_another_version_are_remade_and_reported(tmp_path):
    def run(**code):
        return Job(tmp_path).chain.run(Stage("first", lambda folder, report: {}, code=code))

    assert run(pointloom="1.0").outdated == "" and run(pointloom="1.0").is_reused
    newer = run(pointloom="1.1")
    assert not newer.is_reused and newer.outdated == "pointloom 1.0, now 1.1"
    other = Job(tmp_path).chain.run(Stage("first", lambda folder, report: {}, {"a": 1}, code={"pointloom": "1.1"}))
    assert not other.is_reused and other.outdated == ""  # a setting was changed, not the version


def test_an_interrupted_stage_finds_its_partial_files(tmp_path):
    seen = []

    def make(folder, report, going, *, fail):
        seen.append(sorted(path.name for path in going.iterdir() if path.name.isdigit()))
        (going / str(len(seen))).write_text("so far")
        if fail:
            raise KeyboardInterrupt
        (folder / "text").write_text("whole")
        return {}

    def run(fail, setting=1, resume=True):
        chain = Job(tmp_path, resume=resume).chain
        chain.run(Stage("first", lambda *given: make(*given, fail=fail), {"setting": setting}, goes_on=True))

    for fail, setting in ((True, 1), (True, 1), (True, 2), (False, 2)):
        if fail:
            with pytest.raises(KeyboardInterrupt):
                run(fail, setting)
        else:
            run(fail, setting)
    assert seen == [[], ["1"], [], ["3"]]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["first", "records"]
    with pytest.raises(KeyboardInterrupt):
        run(True, 3)
    Job(tmp_path, resume=False)
    assert not (tmp_path / "first.going").exists()


def test_without_resume_all_stages_are_remade(tmp_path):
    Job(tmp_path).run()
    job = Job(tmp_path, resume=False)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["records"]
    job.run()
    assert job.ran == [*NAMES]


def test_an_interrupted_job_resumes_to_bitwise_identical_files(tmp_path):
    files = ("core/stages.py", __file__)
    lines = run_lines(lambda: Job(tmp_path / "whole").run(), files)
    complete = files_in(tmp_path / "whole")
    for stop in range(1, lines, 5):
        root = tmp_path / str(stop)
        assert run_lines(lambda root=root: Job(root).run(), files, stop) == stop
        for name in NAMES:  # the folder of a stage is complete or absent
            assert not (root / name).exists() or (root / name / "deep" / "text").is_file()
        assert Job(root).run()["third"].report["length"] == 3
        assert files_in(root) == complete


def test_a_stage_that_fails_leaves_nothing_of_itself(tmp_path):
    job = Job(tmp_path)

    def fail(folder, report):
        (folder / "half").write_text("half")
        raise ValueError("no")

    first = job.chain.run(job.stage("first", ()))
    with pytest.raises(ValueError, match="no"):
        job.chain.run(Stage("second", fail, {}, (first,)))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["first", "records"]


def test_a_full_disk_is_an_error_and_finished_stages_remain(tmp_path):
    job = Job(tmp_path)

    def full(folder, report):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(folder / "big"))

    first = job.chain.run(job.stage("first", ()))
    with pytest.raises(FileError, match=r"second\.part/big: cannot be written: No space left"):
        job.chain.run(Stage("second", full, {}, (first,)))
    again = Job(tmp_path)
    again.run()
    assert again.ran == ["second", "third"]


def test_a_killed_run_leaves_a_part_that_the_next_removes(tmp_path):
    (tmp_path / "second.part").mkdir()
    (tmp_path / "second.part" / "half").write_text("half")
    Job(tmp_path).run()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["first", "records", "second", "third"]
