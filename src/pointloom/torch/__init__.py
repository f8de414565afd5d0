"""Point clouds in networks: batched neighbors, sampling and losses on torch tensors, with gradients (docs/torch.md).

Requires torch 2.4 or later, which is imported when a name of this package is first used.

Examples:
    >>> import torch, pointloom as loom
    >>> clouds = torch.rand(8, 1024, 3)
    >>> indices, sqdists = loom.torch.knn(clouds, clouds, 16)
    >>> indices.shape
    torch.Size([8, 1024, 16])
"""

from ..public_names import attach  # pyright: ignore[reportMissingImports]

_load, __dir__ = attach(__name__)


def __getattr__(name: str) -> object:
    try:
        return _load(name)
    except ModuleNotFoundError as error:
        if error.name != "torch":
            raise
        raise ImportError("pointloom.torch needs torch 2.4 or later: pip install pointloom[torch]") from error
