"""Files that a packed application needs of pointloom and Warp.

Public names are loaded on first use, by the stubs. Both packages compile kernels from Python source at run time.
"""

from PyInstaller.utils.hooks import collect_data_files, collect_dynamic_libs, collect_submodules  # type: ignore

hiddenimports = collect_submodules("pointloom", filter=lambda name: not name.startswith("pointloom._pyinstaller"))
datas = collect_data_files("pointloom") + collect_data_files("warp")
binaries = collect_dynamic_libs("warp", search_patterns=["*.so", "*.dll", "*.dylib"])
module_collection_mode = {"pointloom": "py", "warp": "py"}
