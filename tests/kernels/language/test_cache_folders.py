"""Owners of compiled kernels are checked where files have owners."""

import os

from pointloom.kernels.language import cache_folders


def test_without_users_digests_alone_protect_files(tmp_path, monkeypatch):
    file = tmp_path / "kernel.o"
    file.write_bytes(b"code")
    cache_folders.seal(file)
    tmp_path.chmod(0o777)
    file.chmod(0o666)
    assert cache_folders.other_writers(tmp_path) and not cache_folders.is_intact(file)
    monkeypatch.delattr(os, "getuid")
    assert cache_folders.other_writers(tmp_path) == "" and cache_folders.is_intact(file)
    file.write_bytes(b"node")
    assert not cache_folders.is_intact(file)
