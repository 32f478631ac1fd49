"""cffi's `ffi` and `lib` of a library, as far as pymunk uses them for bodies, circles, segments, spaces and queries."""

import ctypes
import sys
import weakref
from collections.abc import Callable, Sequence
from contextlib import suppress
from importlib.util import find_spec, module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType
from typing import Any, ClassVar

from game.web.cffi.tables import CSignature, CType, TableEntry, Tables, is_constant, is_extern_python, is_function

_SLOT = 8
"""Bytes for each argument of a function that the library calls."""
_CALL_PYTHON = 25
"""Index in cffi's exports of the function by which the library calls functions that Python defines."""
_INIT = "_init_cffi_1_0_external_module"
"""The function of cffi's module that a library calls when it is imported."""
_CALLBACK: Any = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)


class Pointer:
    """A pointer. address: 0 for none. target: index of the type that it points to; None for void.

    owned: object that it keeps alive. A destructor, if there is one, is called with a plain pointer when this one is collected.
    """

    __slots__ = ("__weakref__", "_destructor", "address", "owned", "tables", "target")

    def __init__(self, tables: Tables, address: int, target: int | None = None, owned: object = None) -> None:
        self.tables, self.address, self.target, self.owned = tables, address, target, owned
        self._destructor: Callable[[Pointer], object] | None = None

    def destroyed_by(self, destructor: Callable[["Pointer"], object]) -> "Pointer":
        """The same pointer, with a destructor."""
        made = Pointer(self.tables, self.address, self.target, self)
        made._destructor = destructor
        return made

    def __del__(self) -> None:
        if self._destructor is not None:
            DESTRUCTION.of(self._destructor, Pointer(self.tables, self.address, self.target))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Pointer) and self.address == other.address

    def __hash__(self) -> int:
        return hash(self.address)

    def __bool__(self) -> bool:
        return self.address != 0

    def __getattr__(self, name: str) -> Any:
        if self.target is None or name.startswith("__"):
            raise AttributeError(name)
        return getattr(Struct(self.tables, self.tables.type(self.target).made.from_address(self.address)), name)


class _Destruction:
    """Calls destructors while no function of the library runs, nor another destructor.

    Python may collect garbage at any moment, also in a callback while the library iterates over a list. A destructor that
    removed an entry from this list would crash the process.
    """

    def __init__(self) -> None:
        self._running = 0
        self._due: list[tuple[Callable[[Pointer], object], Pointer]] = []

    def of(self, destructor: Callable[[Pointer], object], pointer: Pointer) -> None:
        """Call a destructor, now or when no function runs any more."""
        self._due.append((destructor, pointer))
        self._destroy()

    def begin(self) -> None:
        """Note that a function of the library begins."""
        self._running += 1

    def end(self) -> None:
        """Note that it has ended, and call the destructors that have waited."""
        self._running -= 1
        if self._due:
            self._destroy()

    def _destroy(self) -> None:
        """Call the waiting destructors, unless a function runs."""
        while self._due and not self._running:
            destructor, pointer = self._due.pop(0)
            self._running += 1
            try:
                destructor(pointer)
            finally:
                self._running -= 1


DESTRUCTION = _Destruction()


class Struct:
    """A struct of C; its fields are attributes."""

    __slots__ = ("tables", "value")

    def __init__(self, tables: Tables, value: Any) -> None:
        """Wrap a struct. value: of ctypes."""
        self.tables, self.value = tables, value

    def __getattr__(self, name: str) -> Any:
        members = type(self.value).members
        if name not in members:
            raise AttributeError(name)
        return _from_c(self.tables, members[name], getattr(self.value, name))


class Library:
    """cffi's `lib`: functions, constants and variables as attributes."""

    def __init__(self, tables: Tables) -> None:
        self._tables = tables

    def __getattr__(self, name: str) -> Any:
        if name not in self._tables.entries:
            raise AttributeError(name)
        found = self._found(self._tables.entries[name])
        setattr(self, name, found)
        return found

    def _found(self, entry: TableEntry) -> Any:
        """The function, constant or variable of an entry."""
        tables = self._tables
        if is_function(entry):
            return _caller(tables, tables.signature(entry.kind), entry.function)
        if is_constant(entry):
            value = ctypes.c_ulonglong()
            ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)(entry.address)(ctypes.addressof(value))
            return value.value
        if is_extern_python(entry):
            return Pointer(tables, entry.function)
        kind = tables.type(entry.kind)  # a variable; a function returns its address
        variable = ctypes.CFUNCTYPE(ctypes.c_void_p)(entry.address)()
        return _from_c(tables, kind, kind.made.from_address(variable).value)


class Interface:
    """cffi's `ffi`."""

    CData = Pointer
    _handles: ClassVar["weakref.WeakValueDictionary[int, Pointer]"] = weakref.WeakValueDictionary()
    _number = 0

    def __init__(self, tables: Tables, exports: int) -> None:
        """Create it. exports: address of the list in which the library looks for cffi's functions."""
        self.NULL = Pointer(tables, 0)
        self._tables = tables
        self._externs: dict[str, Callable[..., Any]] = {}
        self._callback = _CALLBACK(self._called)
        slot = exports + _CALL_PYTHON * ctypes.sizeof(ctypes.c_void_p)
        ctypes.c_void_p.from_address(slot).value = ctypes.cast(self._callback, ctypes.c_void_p).value

    def new(self, declaration: str) -> Pointer:
        """Allocate a value. declaration: "TYPE *"."""
        kind, index = self._tables.named(declaration.removesuffix("*").strip())
        value = kind.made()
        return Pointer(self._tables, ctypes.addressof(value), index, value)

    def cast(self, declaration: str, value: object) -> Any:
        """A number converted to a type; anything else, such as a function, unchanged."""
        if not isinstance(value, int):
            return value
        return self._tables.named(declaration)[0].made(value).value

    def addressof(self, library: Library, name: str) -> Pointer:
        """A pointer to a function of the library, as an argument for the library."""
        del library
        return Pointer(self._tables, self._tables.entries[name].function)

    def string(self, pointer: Pointer) -> bytes:
        """The text at a pointer."""
        return ctypes.string_at(pointer.address)

    def gc(self, pointer: Pointer, destructor: Callable[[Pointer], object]) -> Pointer:
        """The same pointer; the destructor is called when it is collected."""
        return pointer.destroyed_by(destructor)

    def new_handle(self, held: object) -> Pointer:
        """A pointer that stands for a Python object."""
        Interface._number += 1
        handle = Pointer(self._tables, Interface._number, None, held)
        self._handles[handle.address] = handle
        return handle

    def from_handle(self, handle: Pointer) -> Any:
        """The object that a handle stands for."""
        return self._handles[handle.address].owned

    def def_extern(self) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
        """A decorator: the library calls the Python function by its name."""

        def defined(function: Callable[..., Any]) -> Callable[..., Any]:
            self._externs[function.__name__] = function
            return function

        return defined

    def _called(self, extern: int, slots: int) -> None:
        """Call a Python function for the library. slots: address of the arguments; the result is written there."""
        name = (ctypes.string_at(ctypes.c_void_p.from_address(extern).value or 0)).decode().rpartition(".")[2]
        signature = self._tables.signature(self._tables.entries[name].kind)
        given = [self._argument(kind, slots + _SLOT * number) for number, kind in enumerate(signature.arguments)]
        result = self._externs[name](*given)
        if signature.result.made is not None:
            value = signature.result.made(_to_c(signature.result, result))
            ctypes.memmove(slots, ctypes.addressof(value), ctypes.sizeof(value))

    def _argument(self, kind: CType, slot: int) -> Any:
        """The argument at an address; a struct is passed by its address."""
        if kind.is_struct:
            address = ctypes.c_void_p.from_address(slot).value
            return Struct(self._tables, kind.made.from_buffer_copy(kind.made.from_address(address)))
        return _from_c(self._tables, kind, kind.made.from_address(slot).value)


def load_library(package: str, name: str) -> None:
    """Load a library of a package that cffi has built, so that the package can import it with its `ffi` and `lib`.

    While it is imported, the library calls cffi's module, which should return the finished module. Python accepts only one
    written in C, so the import is aborted with an exception after this call.
    """
    found = find_spec(package)
    assert found is not None
    path = next(path for folder in found.submodule_search_locations or () for path in Path(folder).glob(f"{name}.*"))
    spec = spec_from_file_location(f"{package}.{name}", path)
    assert spec is not None

    def external_module(address: int) -> None:
        """Called by the library. address: of its name, cffi's version, the list for cffi's functions, the tables' context."""
        _name, _version, exports, context = (ctypes.c_void_p * 4).from_address(address)
        tables = Tables(context or 0)
        module: Any = ModuleType(spec.name)
        module.ffi, module.lib = Interface(tables, exports or 0), Library(tables)
        sys.modules[spec.name] = module
        raise _LoadedError

    backend: Any = ModuleType("_cffi_backend")
    setattr(backend, _INIT, external_module)
    sys.modules[backend.__name__] = backend
    with suppress(_LoadedError):
        module_from_spec(spec)


class _LoadedError(Exception):
    """The library is loaded: ends its import."""


def _caller(tables: Tables, signature: CSignature, address: int) -> Callable[..., Any]:
    """A function of the library with Python's values as arguments and result."""
    function = signature.made(address)
    result, kinds = signature

    def call(*values: object) -> Any:
        DESTRUCTION.begin()
        try:
            return _from_c(tables, result, function(*[_to_c(kind, value) for kind, value in zip(kinds, values, strict=True)]))
        finally:
            DESTRUCTION.end()

    return call


def _to_c(kind: CType, value: Any) -> Any:
    """A value converted for ctypes; a sequence becomes a struct."""
    if isinstance(value, Pointer):
        return value.address
    if isinstance(value, Struct):
        return value.value
    if kind.is_struct and isinstance(value, Sequence):
        members = kind.made.members.values()
        return kind.made(*[_to_c(one, part) for one, part in zip(members, value, strict=True)])
    return value


def _from_c(tables: Tables, kind: CType, value: Any) -> Any:
    """A value of ctypes converted to Python's."""
    if kind.made is ctypes.c_void_p:
        return Pointer(tables, value or 0, kind.target)
    if kind.is_struct:
        return Struct(tables, value)
    if kind.target is not None:
        return [_from_c(tables, tables.type(kind.target), part) for part in value]
    return value
