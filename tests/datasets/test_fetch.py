"""Public sets come from a server or a mirror whole and checked, or not at all, and errors say what to put where."""

import functools
import hashlib
import http.server
import io
import shutil
import threading
import zipfile

import pytest

import pointloom as loom
from pointloom.datasets.public import fetching
from pointloom.datasets.public.fetching import PublicFile, PublicSet, public_sets


def zipped(files: dict[str, bytes]) -> bytes:
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w") as file:
        for name, content in files.items():
            file.writestr(name, content)
    return held.getvalue()


class Served(http.server.SimpleHTTPRequestHandler):
    """Serves a folder; `short.bin` ends early."""

    def do_GET(self):
        self.server.asked.append(self.path)
        if not self.path.endswith("short.bin"):
            return super().do_GET()
        self.send_response(200)
        self.send_header("Content-Length", "1000")
        self.end_headers()
        self.wfile.write(b"too little")

    def log_message(self, *_):
        pass


@pytest.fixture
def server(tmp_path):
    """A server of a folder on this machine: `.url`, `.folder`, and what it was `.asked` for."""
    folder = tmp_path / "served"
    folder.mkdir()
    found = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Served, directory=folder))
    found.asked, found.folder, found.url = [], folder, f"http://127.0.0.1:{found.server_port}"
    thread = threading.Thread(target=found.serve_forever, kwargs={"poll_interval": 0.01})
    thread.start()
    yield found
    found.shutdown()
    found.server_close()
    thread.join()


@pytest.fixture
def add(server, monkeypatch):
    """Make a set of one file that the server has; with another checksum where `wrong`."""
    monkeypatch.delenv(fetching.MIRROR, raising=False)

    def make(name, content, unpack=None, *, algorithm="sha256", wrong=False):
        (server.folder / name).write_bytes(content)
        digest = hashlib.new(algorithm, b"other" if wrong else content).hexdigest()
        file = PublicFile(f"{server.url}/{name}", f"{algorithm}:{digest}", unpack)
        monkeypatch.setitem(fetching.SETS, "made", PublicSet("made", "a made set", "none", "nobody", (file,)))
        return file

    return make


def everything(folder):
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())


@pytest.mark.parametrize("algorithm", ["sha256", "md5"])
def test_a_file_comes_once_and_is_there_then(add, server, tmp_path, algorithm):
    add("cloud.ply", b"points", algorithm=algorithm)
    for _ in range(2):
        path = loom.datasets.fetch("made", tmp_path / "home")
        assert path.name == "cloud.ply" and path.read_bytes() == b"points"
    assert server.asked == ["/cloud.ply"]


def test_an_archive_is_unpacked_and_unpacked_again_where_a_file_is_lost(add, server, tmp_path):
    add("frames.zip", zipped({"color/0.png": b"c", "depth/0.png": b"dd"}), "inside")
    folder = loom.datasets.fetch("made", tmp_path / "home")
    assert everything(folder) == [".files.json", "inside/color/0.png", "inside/depth/0.png"]
    (folder / "inside/depth/0.png").write_bytes(b"")
    assert (loom.datasets.fetch("made", tmp_path / "home") / "inside/depth/0.png").read_bytes() == b"dd"
    assert len(server.asked) == 2


@pytest.mark.parametrize("name", ["wrong", "short.bin", "gone.bin"])
def test_what_is_damaged_cut_short_or_gone_leaves_nothing_and_says_what_to_put_where(add, server, tmp_path, name):
    file = add(name, b"points", wrong=name == "wrong")
    if name == "gone.bin":
        (server.folder / name).unlink()
    with pytest.raises(loom.FileError, match="cannot be downloaded") as told:
        loom.datasets.fetch("made", tmp_path / "home")
    assert everything(tmp_path / "home") == []
    assert file.url in str(told.value) and str(tmp_path / "home" / "downloads" / f"made-{name}") in str(told.value)


def test_what_was_put_there_by_hand_needs_no_network(add, server, tmp_path):
    add("cloud.ply", b"points")
    with pytest.raises(loom.FileError) as told:
        (server.folder / "cloud.ply").unlink()
        loom.datasets.fetch("made", tmp_path / "home")
    shutil.copyfile(_written(tmp_path, b"points"), told.value.path)
    server.asked.clear()
    assert loom.datasets.fetch("made", tmp_path / "home").read_bytes() == b"points"
    assert server.asked == []


def _written(folder, content):
    (folder / "by-hand").write_bytes(content)
    return folder / "by-hand"


def test_a_mirror_comes_first_and_a_wrong_file_of_it_is_not_taken(add, server, tmp_path, monkeypatch):
    add("cloud.ply", b"points")
    for mirror in (f"{server.url}/mirror", str(server.folder / "mirror")):
        monkeypatch.setenv(fetching.MIRROR, mirror)
        held = server.folder / "mirror" / "made" / "cloud.ply"
        held.parent.mkdir(parents=True, exist_ok=True)
        for content, asks_host in ((b"points", False), (b"others", True)):
            held.write_bytes(content)
            server.asked.clear()
            home = tmp_path / f"{mirror == str(server.folder / 'mirror')}{asks_host}"
            assert loom.datasets.fetch("made", home).read_bytes() == b"points"
            assert ("/cloud.ply" in server.asked) == asks_host


@pytest.mark.parametrize("name", ["../out", "/out", "..\\out", "C:out"])
def test_names_that_climb_out_of_an_archive_are_refused(add, tmp_path, name):
    add("bad.zip", zipped({"good": b"1", name: b"2"}), "")
    with pytest.raises(loom.FileError, match="outside of its folder"):
        loom.datasets.fetch("made", tmp_path / "home")
    assert everything(tmp_path) == ["home/downloads/made-bad.zip", "served/bad.zip"]


def test_a_link_in_an_archive_is_refused(add, tmp_path):
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w") as file:
        entry = zipfile.ZipInfo("link")
        entry.external_attr = 0o120777 << 16
        file.writestr(entry, "/etc/passwd")
    add("bad.zip", held.getvalue(), "")
    with pytest.raises(loom.FileError, match="link"):
        loom.datasets.fetch("made", tmp_path / "home")


def test_a_fetch_that_is_interrupted_leaves_no_set(add, tmp_path, monkeypatch):
    add("frames.zip", zipped({"a": b"1"}), "")

    def interrupted(*_):
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(fetching, "_publish", interrupted)
        with pytest.raises(KeyboardInterrupt):
            loom.datasets.fetch("made", tmp_path / "home")
    assert everything(tmp_path / "home") == ["downloads/made-frames.zip"]
    assert everything(loom.datasets.fetch("made", tmp_path / "home")) == [".files.json", "a"]


def test_an_unknown_set_is_told_with_the_nearest():
    with pytest.raises(ValueError, match=r"^name:"):
        loom.datasets.fetch("buny")


def test_every_set_has_a_checksum_an_address_and_a_license():
    lengths = {"md5": 32, "sha256": 64}
    for one in public_sets():
        assert one.license and one.citation and one.files
        for file in one.files:
            kind, _, digest = file.checksum.partition(":")
            assert file.url.startswith("https://") and len(digest) == lengths[kind] and int(digest, 16)
            assert (file.unpack is not None) == file.name.endswith(".zip")
