"""Put other functions and numbers into the game's code while a block runs, wherever the code refers to the right ones."""

import contextlib
import sys
import types
from collections.abc import Callable, Iterator
from typing import Any

_PACKAGES = ("physics", "game")


@contextlib.contextmanager
def replaced(target: Callable[..., Any], substitute: Callable[..., Any]) -> Iterator[None]:
    """Bind every name in the loaded modules of the game that means the target, and every default, to the substitute.

    The target's own module is left alone: a function that calls itself goes on as it is. Raises LookupError where nothing
    refers to the target: a mistake that is not made proves nothing.
    """
    modules = [module for module in _modules() if module.__name__ != target.__module__]
    bound = [(vars(module), name) for module in modules for name, value in vars(module).items() if value is target]
    defaults = [
        function
        for module in modules
        for function in vars(module).values()
        if isinstance(function, types.FunctionType) and any(value is target for value in function.__defaults__ or ())
    ]
    if not bound:
        raise LookupError(f"no module of the game refers to {target!r}")
    old = [function.__defaults__ for function in defaults]
    for names, name in bound:
        names[name] = substitute
    for function in defaults:
        function.__defaults__ = tuple([substitute if value is target else value for value in function.__defaults__ or ()])
    try:
        yield
    finally:
        for names, name in bound:
            names[name] = target
        for function, values in zip(defaults, old, strict=True):
            function.__defaults__ = values


@contextlib.contextmanager
def constant(name: str, value: float) -> Iterator[None]:
    """Give a constant of the physics another value in every module that has it; LookupError where none has."""
    holders = [module for module in _modules() if module.__name__.startswith("physics.") and hasattr(module, name)]
    if not holders:
        raise LookupError(f"no module of the physics has a constant {name}")
    old = [getattr(module, name) for module in holders]
    for module in holders:
        setattr(module, name, value)
    try:
        yield
    finally:
        for module, right in zip(holders, old, strict=True):
            setattr(module, name, right)


@contextlib.contextmanager
def method(owner: type, name: str, substitute: Callable[..., Any]) -> Iterator[None]:
    """Give a class another method."""
    right = owner.__dict__[name]
    setattr(owner, name, substitute)
    try:
        yield
    finally:
        setattr(owner, name, right)


def _modules() -> list[types.ModuleType]:
    """The loaded modules of the game."""
    return [module for name, module in sys.modules.items() if name.partition(".")[0] in _PACKAGES]
