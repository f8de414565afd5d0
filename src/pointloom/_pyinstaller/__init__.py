"""Hooks for PyInstaller, which finds them by the entry point `pyinstaller40`."""

from pathlib import Path


def hook_folders() -> list[str]:
    """Folders with hooks: this one."""
    return [str(Path(__file__).parent)]
