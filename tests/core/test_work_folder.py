"""The lock of a job folder, where the system has one."""

import os

import pytest

from pointloom.core import work_folder
from pointloom.core.errors import FileError


def test_a_locked_folder_is_in_use_for_other_runs(tmp_path):
    with work_folder.locked(tmp_path), pytest.raises(FileError, match="in"), work_folder.locked(tmp_path):
        pass
    with work_folder.locked(tmp_path):
        pass


def test_without_locks_a_folder_is_not_opened(tmp_path, monkeypatch):
    """Windows opens no folders."""
    monkeypatch.setattr(work_folder, "fcntl", None)
    monkeypatch.delattr(os, "open")
    with work_folder.locked(tmp_path), work_folder.locked(tmp_path):
        pass
