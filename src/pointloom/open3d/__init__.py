"""Open3D's names over pointloom: `import pointloom.open3d as o3d` runs scripts written for Open3D.

Objects behave as in Open3D (changed in place) and wrap pointloom objects: `cloud.native` of a `geometry.PointCloud` is
a `loom.PointCloud`. Missing names raise errors that name pointloom's equivalent
(docs/adr/0030-open3d-objects-over-ours.md). Modules are loaded on first use.
"""

from ..public_names import attach, report_unknown_modules  # pyright: ignore[reportMissingImports]

__version__ = "0.20.0"  # version of the Open3D API; pointloom.__version__ is that of pointloom
_build_config = {  # parts of Open3D's build that pointloom replaces
    **dict.fromkeys(("BUILD_CUDA_MODULE", "GLIBCXX_USE_CXX11_ABI"), True),
    **dict.fromkeys(("BUILD_SYCL_MODULE", "BUILD_PYTORCH_OPS", "BUILD_TENSORFLOW_OPS", "BUNDLE_OPEN3D_ML"), False),
    **dict.fromkeys(("BUILD_AZURE_KINECT", "BUILD_LIBREALSENSE", "BUILD_SHARED_LIBS", "BUILD_GUI"), False),
    "BUILD_JUPYTER_EXTENSION": False,
    **dict.fromkeys(("CUDA_VERSION", "CUDA_GENCODES", "Tensorflow_VERSION", "Pytorch_VERSION"), ""),
    "CMAKE_BUILD_TYPE": "Release",
}
__getattr__, __dir__ = attach(__name__)
report_unknown_modules()
