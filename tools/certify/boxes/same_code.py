"""A function's own code, run on other numbers.

No second copy of the source's functions is analysed: the compiled code itself runs, in a namespace in which `math`, `complex`
and what is given besides are replaced, and so do all functions of the physics that it calls.
"""

from collections.abc import Callable, Mapping
from types import FunctionType
from typing import Any


def on_other_numbers(function: Callable[..., Any], names: Mapping[str, Any]) -> Callable[..., Any]:
    """The function with some of the names it uses, directly or through others of the physics, replaced."""
    return _bound(function, names, {})


def _bound(
    function: Callable[..., Any], names: Mapping[str, Any], done: dict[Callable[..., Any], FunctionType]
) -> FunctionType:
    """The function with its namespace replaced, and those it calls with theirs."""
    assert isinstance(function, FunctionType), function
    if function not in done:
        space = dict(function.__globals__)
        done[function] = FunctionType(function.__code__, space, function.__name__, function.__defaults__, function.__closure__)
        for name in function.__code__.co_names:
            used = space.get(name)
            if isinstance(used, FunctionType) and used.__module__.partition(".")[0] == "physics":
                space[name] = _bound(used, names, done)
        space.update(names)
    return done[function]
