"""Public datasets are downloaded atomically from a server or a mirror and checked; errors name the missing files."""

import functools
import hashlib
import http.server
import io
import threading
import zipfile
from pathlib import Path

import pytest

import pointloom as loom
from pointloom.datasets.public import fetching
from pointloom.datasets.public.fetching import PublicFile, PublicSet, public_sets


def zipped(files: dict[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as file:
        for name, content in files.items():
            file.writestr(name, content)
    return buffer.getvalue()


class Served(http.server.SimpleHTTPRequestHandler):
    """Serves a folder; `short.bin` is truncated."""

    def do_GET(self):
        self.server.requests.append(self.path)
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
    """A server of a folder on this machine: `.url`, `.folder`, and the paths that were requested (`.requests`)."""
    folder = tmp_path / "served"
    folder.mkdir()
    http_server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Served, directory=folder))
    http_server.requests, http_server.folder = [], folder
    http_server.url = f"http://127.0.0.1:{http_server.server_port}"
    thread = threading.Thread(target=http_server.serve_forever, kwargs={"poll_interval": 0.01})
    thread.start()
    yield http_server
    http_server.shutdown()
    http_server.server_close()
    thread.join()


@pytest.fixture
def add(server, monkeypatch):
    """Add a dataset of one file on the server, with a wrong checksum if `wrong`."""
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
def test_file_is_downloaded_once(add, server, tmp_path, algorithm):
    add("cloud.ply", b"points", algorithm=algorithm)
    for _ in range(2):
        path = loom.datasets.fetch("made", tmp_path / "home")
        assert path.name == "cloud.ply" and path.read_bytes() == b"points"
    assert server.requests == ["/cloud.ply"]


def test_archive_is_unpacked_again_if_a_file_is_missing(add, server, tmp_path):
    add("frames.zip", zipped({"color/0.png": b"c", "depth/0.png": b"dd"}), "inside")
    folder = loom.datasets.fetch("made", tmp_path / "home")
    assert everything(folder) == [".files.json", "inside/color/0.png", "inside/depth/0.png"]
    (folder / "inside/depth/0.png").write_bytes(b"")
    assert (loom.datasets.fetch("made", tmp_path / "home") / "inside/depth/0.png").read_bytes() == b"dd"
    assert len(server.requests) == 2


@pytest.mark.parametrize("name", ["wrong", "short.bin", "gone.bin"])
def test_failed_download_leaves_no_files_and_reports_where_to_put_them(add, server, tmp_path, name):
    file = add(name, b"points", wrong=name == "wrong")
    if name == "gone.bin":
        (server.folder / name).unlink()
    with pytest.raises(loom.FileError, match="cannot be downloaded") as caught:
        loom.datasets.fetch("made", tmp_path / "home")
    assert everything(tmp_path / "home") == []
    assert file.url in str(caught.value) and str(tmp_path / "home" / "downloads" / f"made-{name}") in str(caught.value)


def test_files_added_by_hand_need_no_network(add, server, tmp_path):
    add("cloud.ply", b"points")
    with pytest.raises(loom.FileError) as caught:
        (server.folder / "cloud.ply").unlink()
        loom.datasets.fetch("made", tmp_path / "home")
    Path(caught.value.path).write_bytes(b"points")
    server.requests.clear()
    assert loom.datasets.fetch("made", tmp_path / "home").read_bytes() == b"points" and server.requests == []


def test_mirror_is_tried_first_and_its_wrong_file_is_rejected(add, server, tmp_path, monkeypatch):
    add("cloud.ply", b"points")
    for mirror in (f"{server.url}/mirror", str(server.folder / "mirror")):
        monkeypatch.setenv(fetching.MIRROR, mirror)
        mirrored = server.folder / "mirror" / "made" / "cloud.ply"
        mirrored.parent.mkdir(parents=True, exist_ok=True)
        for content, contacts_host in ((b"points", False), (b"others", True)):
            mirrored.write_bytes(content)
            server.requests.clear()
            home = tmp_path / f"{mirror == str(server.folder / 'mirror')}{contacts_host}"
            assert loom.datasets.fetch("made", home).read_bytes() == b"points"
            assert ("/cloud.ply" in server.requests) == contacts_host


@pytest.mark.parametrize("name", ["../out", "/out", "..\\out", "C:out"])
def test_names_that_climb_out_of_an_archive_and_links_are_refused(add, tmp_path, name):
    add("bad.zip", zipped({"good": b"1", name: b"2"}), "")
    with pytest.raises(loom.FileError, match="outside of its folder"):
        loom.datasets.fetch("made", tmp_path / "home")
    assert everything(tmp_path) == ["home/downloads/made-bad.zip", "served/bad.zip"]
    (tmp_path / "home/downloads/made-bad.zip").unlink()
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as file:
        entry = zipfile.ZipInfo("link")
        entry.external_attr = 0o120777 << 16
        file.writestr(entry, "/etc/passwd")
    add("bad.zip", buffer.getvalue(), "")
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


def test_every_set_has_a_checksum_an_address_and_a_license():
    with pytest.raises(ValueError, match=r"^name:"):
        loom.datasets.fetch("buny")
    lengths = {"md5": 32, "sha256": 64}
    for one in public_sets():
        assert one.license and one.citation and one.files
        for file in one.files:
            kind, _, digest = file.checksum.partition(":")
            assert file.url.startswith("https://") and len(digest) == lengths[kind] and int(digest, 16)
            assert (file.unpack is not None) == file.name.endswith(".zip")
