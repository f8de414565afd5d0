"""A stage is whole or not there, and is made again where what it was made from changed; and only then."""

import errno
import os

import pytest

from pointloom.core.errors import FileError
from pointloom.core.stages import Chain, Stage

from ...interruptions import run_lines

NAMES = ("first", "second", "third")


class Job:
    """Three stages: each writes a setting of its own behind what it reads from the one before."""

    def __init__(self, root, *, resume=True, **settings):
        root.mkdir(exist_ok=True)
        self.settings = {"first": "a", "second": "b", "third": "c"} | settings
        self.ran, self.told = [], []
        self.chain = Chain(root, NAMES, resume=resume, progress=lambda *step: self.told.append(step))

    def run(self):
        made = None
        for name in NAMES:
            made = self.chain.run(self.stage(name, () if made is None else (made,)))
        return self.chain.made

    def stage(self, name, after):
        def make(folder, say):
            self.ran.append(name)
            say("letter", 1, 2)
            before = "".join((made.folder / "deep" / "text").read_text() for made in after)
            (folder / "deep").mkdir()
            # only the letter counts, not its case: another setting may give the same files
            (folder / "deep" / "text").write_text(before + self.settings[name].lower())
            return {"length": len(before) + 1, "share": float("nan")}

        return Stage(name, make, {"letter": self.settings[name]}, after)


def files_in(root):
    """All files but the records, which hold times."""
    paths = (path for path in root.rglob("*") if path.is_file() and path.parent.name != "records")
    return {path.relative_to(root).as_posix(): path.read_bytes() for path in paths}


def test_a_finished_job_is_kept_as_it_is(tmp_path):
    first = Job(tmp_path)
    made = first.run()
    assert first.ran == [*NAMES]
    again = Job(tmp_path)
    kept = again.run()
    assert again.ran == []
    assert [m.is_reused for m in made.values()] == [False] * 3
    assert [m.is_reused for m in kept.values()] == [True] * 3
    assert [m.report for m in kept.values()] == [m.report for m in made.values()]
    assert [m.cost for m in kept.values()] == [m.cost for m in made.values()]
    assert made["third"].report == {"length": 3, "share": None}
    assert set(made["third"].cost) == {"seconds", "cpu_seconds", "peak_bytes"}
    assert (tmp_path / "third" / "deep" / "text").read_text() == "abc"
    assert first.told == [(f"{name}: letter", 1, 2) for name in NAMES]


@pytest.mark.parametrize(
    ("changed", "ran"),
    [
        ({"first": "x"}, ["first", "second", "third"]),
        ({"second": "x"}, ["second", "third"]),
        ({"third": "x"}, ["third"]),
        ({"first": "A"}, ["first"]),  # another setting that gives the same file: what follows is kept
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
    whole, text, record = files_in(tmp_path), tmp_path / "second/deep/text", tmp_path / "records/second.json"
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
    assert job.ran == ["second"]  # with the same bytes: the third is kept
    assert files_in(tmp_path) == whole


def test_another_version_of_a_stage_makes_it_again(tmp_path):
    chain = Job(tmp_path).chain
    ran = []
    for version in (1, 1, 2):
        chain.run(Stage("first", lambda folder, say, v=version: ran.append(v) or {}, version=version))
    assert ran == [1, 2]


def test_what_another_version_made_is_made_again_and_told(tmp_path):
    def run(**code):
        return Job(tmp_path).chain.run(Stage("first", lambda folder, say: {}, code=code))

    assert run(pointloom="1.0").outdated == "" and run(pointloom="1.0").is_reused
    newer = run(pointloom="1.1")
    assert not newer.is_reused and newer.outdated == "pointloom 1.0, now 1.1"
    other = Job(tmp_path).chain.run(Stage("first", lambda folder, say: {}, {"a": 1}, code={"pointloom": "1.1"}))
    assert not other.is_reused and other.outdated == ""  # a setting was changed, and no version


def test_a_stage_that_goes_on_finds_what_it_left_of_the_same(tmp_path):
    seen = []

    def make(folder, say, going, *, fail):
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


def test_without_resume_all_is_made_anew(tmp_path):
    Job(tmp_path).run()
    job = Job(tmp_path, resume=False)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["records"]
    job.run()
    assert job.ran == [*NAMES]


def test_an_interrupted_job_leaves_whole_stages_and_goes_on_to_the_same_bytes(tmp_path):
    files = ("core/stages.py", __file__)
    lines = run_lines(lambda: Job(tmp_path / "whole").run(), files)
    whole = files_in(tmp_path / "whole")
    for stop in range(1, lines, 5):
        root = tmp_path / str(stop)
        assert run_lines(lambda root=root: Job(root).run(), files, stop) == stop
        for name in NAMES:  # a folder of a stage is there as a whole
            assert not (root / name).exists() or (root / name / "deep" / "text").is_file()
        assert Job(root).run()["third"].report["length"] == 3
        assert files_in(root) == whole


def test_a_stage_that_fails_leaves_nothing_of_itself(tmp_path):
    job = Job(tmp_path)

    def fail(folder, say):
        (folder / "half").write_text("half")
        raise ValueError("no")

    first = job.chain.run(job.stage("first", ()))
    with pytest.raises(ValueError, match="no"):
        job.chain.run(Stage("second", fail, {}, (first,)))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["first", "records"]


def test_a_full_disk_is_said_and_what_was_finished_stays(tmp_path):
    job = Job(tmp_path)

    def full(folder, say):
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
