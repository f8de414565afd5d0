"""The kernel language: rules, types, structures, loops, and the two compilers."""

import linecache


def _require_sources() -> None:
    """Raise ImportError if the package has bytecode only: kernels are compiled from their Python source."""
    if not linecache.getlines(_require_sources.__code__.co_filename, globals()):
        raise ImportError(
            "pointloom compiles its kernels from its .py files, and this installation has bytecode alone. Install it "
            "with its .py files; with PyInstaller, pass module_collection_mode={'pointloom': 'py'} to Analysis"
        )


_require_sources()
