"""Open3D's options with assignable fields, over pointloom's immutable ones."""

from __future__ import annotations

import copy
import dataclasses
from types import ModuleType
from typing import Any, Self, dataclass_transform

import numpy as np

from .wrapper import Wrapper, unwrap


@dataclass_transform(eq_default=False, field_specifiers=(dataclasses.field,))
@dataclasses.dataclass(eq=False, repr=False)
class Settings(Wrapper):
    """A `Wrapper` of plain fields: the pointloom object is made and validated from them on demand.

    Subclasses are dataclasses with Open3D's fields and defaults under pointloom's names. Their pointloom class has the
    same name, in the module `of`. An object of the class in place of the first field is copied.
    """

    _internal = ("native_keywords",)

    def __init_subclass__(cls, of: ModuleType | None = None):
        super().__init_subclass__()
        cls._kind = cls._kind if of is None else getattr(of, cls.__name__)
        dataclasses.dataclass(eq=False, repr=False)(cls)

    def __post_init__(self) -> None:
        first = next(iter(dataclasses.fields(self)), None)
        other = getattr(self, first.name) if first else None
        if isinstance(other, type(self)):
            for field in dataclasses.fields(self):
                setattr(self, field.name, copy.copy(getattr(other, field.name)))

    def __setattr__(self, name: str, value: Any) -> None:
        super().__setattr__(name, value.copy() if isinstance(value, np.ndarray) else value)

    @property
    def native(self) -> Any:
        return self._kind(**self.native_keywords())

    def native_keywords(self) -> dict[str, Any]:
        return {field.name: unwrap(getattr(self, field.name)) for field in dataclasses.fields(self)}

    @classmethod
    def from_native(cls, native: Any) -> Self:
        return cls(**{field.name: getattr(native, field.name) for field in dataclasses.fields(cls)})

    def __copy__(self) -> Self:
        return dataclasses.replace(self)

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return type(self)(**{f.name: copy.deepcopy(getattr(self, f.name), memo) for f in dataclasses.fields(self)})

    def __getstate__(self) -> dict[str, Any]:
        return {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        for name, value in state.items():
            setattr(self, name, value)

    def __repr__(self) -> str:
        return type(self).__name__
