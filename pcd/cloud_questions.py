"""What a cloud is asked: whether it has points, normals, colours."""

from __future__ import annotations

import warp as wp

from ..core.known_names import KnownNames
from ..core.yes_or_no import YesOrNo


class CloudQuestions(KnownNames):
    """Questions that are answered with and without a call: `cloud.has_normals`, `cloud.has_normals()`."""

    _arrays: dict[str, wp.array]

    def __len__(self) -> int:
        return self._arrays["points"].size

    @property
    def has_points(self) -> YesOrNo:
        """Whether there are points; may be called, too."""
        return YesOrNo(len(self))

    @property
    def has_normals(self) -> YesOrNo:
        """Whether there are normals; may be called, too."""
        return YesOrNo("normals" in self._arrays)

    @property
    def has_colors(self) -> YesOrNo:
        """Whether there are colours; may be called, too."""
        return YesOrNo("colors" in self._arrays)

    @property
    def has_covariances(self) -> YesOrNo:
        """Whether `estimate_covariances` has been here; may be called, too."""
        return YesOrNo("covariances" in self._arrays)

    @property
    def is_empty(self) -> YesOrNo:
        """Whether there is no point; may be called, too."""
        return YesOrNo(len(self) == 0)
