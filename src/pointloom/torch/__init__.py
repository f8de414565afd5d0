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

__getattr__, __dir__ = attach(__name__)
