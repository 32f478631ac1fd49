"""What kind an expression is, complex, a float, a whole number or a container of such, as far as annotations tell."""

import ast

CONTAINERS = {"Iterable", "Iterator", "Sequence", "frozenset", "list", "set", "tuple"}


class Names:
    """What annotations say: by the name of a class, of its fields, of a function."""

    def __init__(self, sources):
        self.fields, self.attributes, self.returns = {}, {}, {}
        self.bases, self.constants, self.meanings = {}, {}, {}
        nodes = [node for source in sources for node in ast.walk(ast.parse(source))]
        for node in nodes:
            if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name) and _is_annotated(node.value):
                self.meanings[node.targets[0].id] = _plain(node.value)
        for node in nodes:
            if isinstance(node, ast.ClassDef):
                self._read_class(node)
            elif isinstance(node, ast.FunctionDef) and node.returns is not None:
                self._read_function(node)
        for node in nodes:
            if isinstance(node, ast.Module):
                for name, kind in Scope(self, module_level(node)).kinds.items():
                    self._add(self.constants, name, kind)

    def _read_function(self, node):
        self._add(self.returns, node.name, self.meaning(node.returns))
        if any(ast.unparse(mark) in {"property", "cached_property"} for mark in node.decorator_list):
            self._add(self.attributes, node.name, self.meaning(node.returns))

    def _read_class(self, node):
        fields = [item for item in node.body if isinstance(item, ast.AnnAssign) and isinstance(item.target, ast.Name)]
        self.fields[node.name] = {item.target.id: self.meaning(item.annotation) for item in fields}
        self.bases[node.name] = [ast.unparse(base) for base in node.bases]
        for item in fields:
            self._add(self.attributes, item.target.id, self.meaning(item.annotation))

    def meaning(self, annotation):
        """The text of an annotation, `X` for a name that stands for `Annotated[X, ...]`."""
        kind = _plain(annotation)
        return self.meanings.get(kind, kind)

    @staticmethod
    def _add(table, name, kind):
        """Of several meanings of one name the complex one counts, then the float."""
        if table.get(name) not in {"complex", "float"} or kind == "complex":
            table[name] = kind

    def fields_of(self, kind):
        """The kinds of a class's fields by name, its bases' when it has none of its own."""
        for name in [kind, *self.bases.get(kind, [])]:
            if self.fields.get(name):
                return self.fields[name]
        return None


def _plain(annotation):
    """The text of an annotation, `X` for `Annotated[X, ...]`."""
    return ast.unparse(annotation.slice.elts[0] if _is_annotated(annotation) else annotation)


def _is_annotated(node):
    return isinstance(node, ast.Subscript) and ast.unparse(node.value) == "Annotated"


def module_level(tree):
    """A module without its functions and classes."""
    return ast.Module([node for node in tree.body if not isinstance(node, ast.FunctionDef | ast.ClassDef)], [])


def _without_none(kind):
    """X of `X | None`."""
    parts = [ast.unparse(part) for part in _alternatives(ast.parse(kind, mode="eval").body)]
    rest = [part for part in parts if part != "None"]
    return "complex" if "complex" in rest else rest[0] if rest else None


def _alternatives(node):
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitOr):
        return _alternatives(node.left) + _alternatives(node.right)
    return [node]


def arguments_of(kind):
    """("tuple", ["X", "Y"]) of `tuple[X, Y]`; (kind, []) of what is no container."""
    node = ast.parse(kind, mode="eval").body
    if not isinstance(node, ast.Subscript):
        return kind, []
    inner = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
    return ast.unparse(node.value), [ast.unparse(part) for part in inner]


class Scope:
    """The kinds of the names in one function, and of the expressions made of them."""

    def __init__(self, names, node, outer=None, own_class=None):
        self.names = names
        self.kinds = dict(outer.kinds if outer else names.constants)
        if isinstance(node, ast.FunctionDef):
            for argument in [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]:
                if argument.annotation is not None:
                    self.bind(argument, names.meaning(argument.annotation))
                elif argument.arg == "self" and own_class:
                    self.bind(argument, own_class)
        for _ in range(4):  # assignments may stand in any order: loops carry kinds backwards
            for child in ast.walk(node):
                self._read(child)

    def bind(self, target, kind):
        """Give a target, or the targets in a tuple, their kinds."""
        if kind is None:
            return
        kind = _without_none(kind)
        if isinstance(target, ast.arg):
            self._add(target.arg, kind)
        elif isinstance(target, ast.Name):
            self._add(target.id, kind)
        elif isinstance(target, ast.Tuple | ast.List) and kind is not None:
            for k, part in enumerate(target.elts):
                self.bind(part, self.element(kind, k))

    def _add(self, name, kind):
        if kind is not None and self.kinds.get(name) != "complex":
            self.kinds[name] = kind

    def _read(self, node):
        if isinstance(node, ast.Assign):
            for target in node.targets:
                self.bind(target, self.kind(node.value))
        elif isinstance(node, ast.AnnAssign):
            self.bind(node.target, self.names.meaning(node.annotation))
        elif isinstance(node, ast.AugAssign):
            self.bind(node.target, self.kind(ast.BinOp(node.target, node.op, node.value)))
        elif isinstance(node, ast.NamedExpr):
            self.bind(node.target, self.kind(node.value))
        elif isinstance(node, ast.For | ast.comprehension):
            self.bind(node.target, self.element(self.kind(node.iter)))

    def element(self, kind, index=None):
        """The kind of an item of a container, or of a field of a tuple."""
        if kind is None:
            return None
        fields = self.names.fields_of(kind)
        fields = None if fields is None else [*fields.values()]
        name, arguments = arguments_of(kind)
        if fields is None and name == "tuple" and arguments and arguments[-1] != "...":
            fields = arguments
        if fields is not None:
            if index is not None and index < len(fields):
                return fields[index]
            return fields[0] if len(set(fields)) == 1 else None
        return arguments[0] if name in CONTAINERS and arguments else None

    def kind(self, node):
        """The kind of an expression, or None."""
        found = getattr(self, f"_of_{type(node).__name__.lower()}", lambda _: None)(node)
        found = None if found is None else _without_none(found)
        return None if found in {"object", "Any"} else found

    def _of_constant(self, node):
        return type(node.value).__name__ if node.value is not None else None

    def _of_name(self, node):
        return self.kinds.get(node.id)

    def _of_attribute(self, node):
        if node.attr in {"real", "imag"}:
            return "float"
        if isinstance(node.value, ast.Name) and node.value.id == "math":
            return "float"
        owner = self.kind(node.value)
        fields = self.names.fields_of(owner) if owner else None
        return (fields or {}).get(node.attr) or self.names.attributes.get(node.attr)

    def _of_unaryop(self, node):
        return "bool" if isinstance(node.op, ast.Not) else self.kind(node.operand)

    def _of_compare(self, _):
        return "bool"

    def _of_boolop(self, node):
        return self._common(node.values)

    def _of_ifexp(self, node):
        return self._common([node.body, node.orelse])

    def _of_namedexpr(self, node):
        return self.kind(node.value)

    def _common(self, nodes):
        kinds = [kind for kind in map(self.kind, nodes) if kind is not None]
        return "complex" if "complex" in kinds else "float" if "float" in kinds else kinds[0] if kinds else None

    def _of_binop(self, node):
        kinds = {self.kind(node.left), self.kind(node.right)}
        if "complex" in kinds:
            return "complex"
        if kinds <= {"int", "bool"}:
            return "float" if isinstance(node.op, ast.Div) else "int"
        return "float" if kinds <= {"float", "int", "bool"} else None

    def _of_subscript(self, node):
        index = node.slice.value if isinstance(node.slice, ast.Constant) else None
        kind = self.kind(node.value)
        return kind if isinstance(node.slice, ast.Slice) else self.element(kind, index)

    def _of_tuple(self, node):
        kinds = [self.kind(part) or "object" for part in node.elts if not isinstance(part, ast.Starred)]
        return f"tuple[{', '.join(kinds)}]" if len(kinds) == len(node.elts) and kinds else None

    def _of_list(self, node):
        kind = self._common(node.elts)
        return f"list[{kind}]" if kind else None

    def _of_set(self, node):
        return f"set[{self._common(node.elts) or 'object'}]"

    def _of_listcomp(self, node):
        return f"list[{self.kind(node.elt) or 'object'}]"

    _of_generatorexp = _of_listcomp

    def _of_setcomp(self, node):
        return f"set[{self.kind(node.elt) or 'object'}]"

    def _of_call(self, node):
        if isinstance(node.func, ast.Attribute):
            return self._of_method(node)
        name = ast.unparse(node.func)
        if name in BUILTINS:
            return BUILTINS[name](self, node.args)
        if name in self.names.fields:
            return name
        return self.names.returns.get(name)

    def _of_method(self, node):
        owner, name = node.func.value, node.func.attr
        if isinstance(owner, ast.Name) and owner.id == "math":
            return "int" if name in {"floor", "ceil", "trunc", "isqrt", "gcd"} else "float"
        if name == "conjugate":
            return "complex"
        if name in {"random", "fromhex"}:
            return "float"
        found = self.names.returns.get(name)
        return self.kind(owner) if found == "Self" or name == "_replace" else found


def items(scope, arguments):
    return scope.element(scope.kind(arguments[0])) if arguments else None


def _container(name):
    return lambda scope, arguments: f"{name}[{items(scope, arguments) or 'object'}]"


def _always(kind):
    return lambda _, __: kind


def _least(scope, arguments):
    return items(scope, arguments) if len(arguments) == 1 else scope._common(arguments)


def _numbered(scope, arguments):
    return f"list[tuple[int, {items(scope, arguments) or 'object'}]]"


def _zipped(scope, arguments):
    return f"list[tuple[{', '.join([scope.element(scope.kind(part)) or 'object' for part in arguments])}]]"


BUILTINS = {
    **{name: _always("float") for name in ("abs", "float")},
    **{name: _always("int") for name in ("int", "len", "round", "hash", "ord")},
    **{name: _always("bool") for name in ("bool", "any", "all", "isinstance")},
    **{name: _container("list") for name in ("list", "sorted", "reversed", "iter")},
    **{name: _container("set") for name in ("set", "frozenset")},
    "complex": _always("complex"),
    "str": _always("str"),
    "range": _always("list[int]"),
    "tuple": lambda scope, arguments: f"tuple[{items(scope, arguments) or 'object'}, ...]",
    "min": _least,
    "max": _least,
    "sum": items,
    "next": items,
    "enumerate": _numbered,
    "zip": _zipped,
}
