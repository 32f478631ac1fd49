"""The tables that cffi writes into a library: its types, structs, constants and functions (cffi's parse_c_type.h).

Types are converted to those of ctypes.
"""

import ctypes
from collections.abc import Callable
from functools import cache, cached_property
from typing import Any, NamedTuple

_POINTER, _ARRAY, _OPEN_ARRAY, _STRUCT, _ENUM, _FUNCTION, _FUNCTION_END, _NOOP, _TYPENAME = 3, 5, 7, 9, 11, 13, 15, 17, 21
_PRIMITIVE, _CALLS, _CONSTANTS, _EXTERN_PYTHON = 1, {23, 25, 27}, {11, 31}, 41
"""Operation codes of types and of named entries."""
_PRIMITIVES = (
    *(None, "bool", "char", "byte", "ubyte", "short", "ushort", "int", "uint", "long", "ulong", "longlong", "ulonglong"),
    *("float", "double", "longdouble", "wchar", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64"),
    *("ssize_t", "size_t", "ssize_t", "size_t", "ssize_t"),
)
"""ctypes' names of the primitive types, by their numbers; the first is void."""
_SIZE = ctypes.sizeof(ctypes.c_void_p)
_UNKNOWN = (1 << 8 * _SIZE) - 2
"""Size that cffi writes for a struct without a name, whose size it does not know."""


class CType(NamedTuple):
    """A type. made: that of ctypes; None for void. target: index of the type that a pointer or an array is of, else None."""

    made: Any
    target: int | None = None

    @property
    def is_struct(self) -> bool:
        """Whether it is a struct."""
        return isinstance(self.made, type) and issubclass(self.made, ctypes.Structure)


class CSignature(NamedTuple):
    """The types of a function's result and arguments."""

    result: CType
    arguments: tuple[CType, ...]

    @property
    def made(self) -> Callable[[int], Callable[..., Any]]:
        """The function type of ctypes, which makes a function from an address."""
        return ctypes.CFUNCTYPE(self.result.made, *[one.made for one in self.arguments])


class TableEntry(NamedTuple):
    """A named entry of a library. kind: index of its type. address: of the entry, or of the function that returns it."""

    code: int
    kind: int
    address: int
    function: int


class _Global(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_char_p),
        ("address", ctypes.c_void_p),
        ("operation", ctypes.c_size_t),
        ("function", ctypes.c_void_p),
    )


class _Field(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_char_p),
        ("offset", ctypes.c_size_t),
        ("size", ctypes.c_size_t),
        ("operation", ctypes.c_size_t),
    )


class _Struct(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_char_p),
        ("type_index", ctypes.c_int),
        ("flags", ctypes.c_int),
        ("size", ctypes.c_size_t),
        ("alignment", ctypes.c_int),
        ("first", ctypes.c_int),
        ("count", ctypes.c_int),
    )


class _TypeName(ctypes.Structure):
    _fields_ = (("name", ctypes.c_char_p), ("type_index", ctypes.c_int))


class _Context(ctypes.Structure):
    _fields_ = (
        ("types", ctypes.POINTER(ctypes.c_size_t)),
        ("globals", ctypes.POINTER(_Global)),
        ("fields", ctypes.POINTER(_Field)),
        ("structs", ctypes.POINTER(_Struct)),
        ("enums", ctypes.c_void_p),
        ("names", ctypes.POINTER(_TypeName)),
        *[(f"count_of_{what}", ctypes.c_int) for what in ("globals", "structs", "enums", "names")],
    )


class Tables:
    """The tables of one library."""

    def __init__(self, address: int) -> None:
        """Read the tables. address: of the library's context."""
        self._context = _Context.from_address(address)

    @cached_property
    def entries(self) -> dict[str, TableEntry]:
        """Functions, constants and variables by name."""
        found = [self._context.globals[k] for k in range(self._context.count_of_globals)]
        return {one.name.decode(): TableEntry(*_split(one.operation), one.address, one.function or 0) for one in found}

    @cached_property
    def _names(self) -> dict[str, int]:
        """Indices of types by their names."""
        found = [self._context.names[k] for k in range(self._context.count_of_names)]
        return {one.name.decode(): one.type_index for one in found}

    def named(self, name: str) -> tuple[CType, int | None]:
        """A type by its name, with its index; None as the index of a primitive type."""
        if name in self._names:
            return self.type(self._names[name]), self._names[name]
        return CType(getattr(ctypes, f"c_{name.replace('uintptr_t', 'size_t')}")), None

    @cache  # noqa: B019  # one object for each library, as long as the page is open
    def type(self, index: int) -> CType:
        """A type by its index."""
        code, argument = _split(self._context.types[index])
        if code == _PRIMITIVE:
            name = _PRIMITIVES[argument]
            return CType(None if name is None else getattr(ctypes, f"c_{name}"))
        return self._derived(code, argument, index)

    def _derived(self, code: int, argument: int, index: int) -> CType:
        """A type that is derived from others, as a pointer is."""
        if code in {_POINTER, _OPEN_ARRAY, _FUNCTION}:
            return CType(ctypes.c_void_p, argument)
        if code == _ARRAY:
            return CType(self.type(argument).made * self._context.types[index + 1], argument)
        if code == _STRUCT:
            return CType(self._struct(argument))
        if code == _TYPENAME:
            return self.type(self._context.names[argument].type_index)
        if code == _NOOP:
            return self.type(argument)
        assert code == _ENUM
        return CType(ctypes.c_int)

    def _struct(self, number: int) -> Any:
        """A struct as a class of ctypes; an opaque one has no fields."""
        found = self._context.structs[number]
        fields = [self._context.fields[found.first + k] for k in range(found.count)] if found.first >= 0 else []
        members = {one.name.decode(): self.type(_split(one.operation)[1]) for one in fields}
        made = type(
            found.name.decode(),
            (ctypes.Structure,),
            {"_fields_": [(name, one.made) for name, one in members.items()], "members": members},
        )
        assert not members or found.size == ctypes.sizeof(made) or found.size >= _UNKNOWN, found.name
        return made

    @cache  # noqa: B019  # as above
    def signature(self, index: int) -> CSignature:
        """The signature of a function by the index of its type, or of a pointer to it."""
        code, result = _split(self._context.types[index])
        if code == _POINTER:
            return self.signature(result)
        arguments = []
        while _split(self._context.types[index + 1])[0] != _FUNCTION_END:
            index += 1
            arguments.append(self.type(index))
        return CSignature(self.type(result), tuple(arguments))


def is_function(entry: TableEntry) -> bool:
    """Whether an entry is a function of the library."""
    return entry.code in _CALLS


def is_constant(entry: TableEntry) -> bool:
    """Whether an entry is a constant."""
    return entry.code in _CONSTANTS


def is_extern_python(entry: TableEntry) -> bool:
    """Whether an entry is a function that Python defines and the library calls."""
    return entry.code == _EXTERN_PYTHON


def _split(operation: int) -> tuple[int, int]:
    """Operation code and argument of an entry of the type table."""
    signed = operation - (1 << 8 * _SIZE) if operation >> (8 * _SIZE - 1) else operation
    return operation & 0xFF, signed >> 8
