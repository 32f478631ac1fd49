"""What may give other bits on another machine, found in the source without running it.

Flagged: the C library's transcendental functions (everything of `math` but what IEEE 754 fixes), `cmath`, `**`, abs() of a
complex, products and quotients of two complex numbers, sum() of floats, chance that is not `random.Random(seed).random()`,
clocks, iteration over sets, hash() and id().

Whether an expression is complex, a float or a whole number follows from annotations: of arguments, of fields and of what
functions return, through assignments, loops and arithmetic. An operand of * or / whose kind cannot be told is flagged too,
so that nothing passes for want of an annotation.
"""

import ast
from typing import NamedTuple

from tests.support.source_code.kinds import Scope, arguments_of, items, module_level

EXACT_MATH = {
    *("ceil", "copysign", "fabs", "floor", "fmod", "frexp", "fsum", "gcd", "inf", "isclose", "isfinite", "isinf", "isnan"),
    *("isqrt", "ldexp", "modf", "nan", "nextafter", "pi", "sqrt", "tau", "trunc", "ulp"),
    *("degrees", "radians"),  # one product with a constant
}
ELSEWHERE = {"cmath", "datetime", "numpy", "os", "secrets", "statistics", "time", "uuid"}
CHANCE = {
    *("betavariate", "binomialvariate", "choice", "choices", "expovariate", "gammavariate", "gauss", "getrandbits"),
    *("lognormvariate", "normalvariate", "paretovariate", "randbytes", "randint", "randrange", "sample", "shuffle"),
    *("triangular", "uniform", "vonmisesvariate", "weibullvariate"),
}
ORDERLESS = {"all", "any", "frozenset", "len", "max", "min", "set", "sorted", "sum"}


class Finding(NamedTuple):
    """One place that may give other bits."""

    line: int
    what: str


def findings(source, names):
    """All places in a module; `names`: what the annotations say in it and in the modules that it uses."""
    checker = _Checker(names, ast.parse(source))
    return sorted(set(checker.found))


class _Checker(ast.NodeVisitor):
    """Walks a module, function by function, and notes what it finds."""

    def __init__(self, names, tree):
        self.names, self.found, self.aliases = names, [], {}
        self.own_class = None
        self.harmless = set()  # comprehensions whose order is lost again
        self.scope = Scope(names, module_level(tree))
        self.visit(tree)

    def note(self, node, what):
        """One more finding."""
        self.found.append(Finding(node.lineno, what))

    def kind(self, node):
        """The kind of an expression, here."""
        return self.scope.kind(node)

    def visit_ClassDef(self, node):
        """Methods know the class that self is of."""
        outer, self.own_class = self.own_class, node.name
        self.generic_visit(node)
        self.own_class = outer

    def visit_FunctionDef(self, node):
        """Every function has its own names."""
        outer = self.scope
        self.scope = Scope(self.names, node, outer, self.own_class)
        self.generic_visit(node)
        self.scope = outer

    def visit_Import(self, node):
        """Under whatever name."""
        for alias in node.names:
            self._module(node, alias.name)
            if alias.name in {"math", "random"}:
                self.aliases[alias.asname or alias.name] = alias.name

    def visit_ImportFrom(self, node):
        """`from math import sin`."""
        self._module(node, node.module or "")
        for alias in node.names:
            if node.module in {"math", "random"}:
                self._member(node, node.module, alias.name)

    def _module(self, node, name):
        if name.partition(".")[0] in ELSEWHERE:
            self.note(node, f"import {name}")

    def _member(self, node, module, name):
        if module == "math" and name not in EXACT_MATH:
            self.note(node, f"math.{name}")
        if module == "random" and name != "Random":
            self.note(node, f"random.{name}")

    def visit_Attribute(self, node):
        """`math.sin`, and `random.random`, also when they are not called at once."""
        if isinstance(node.value, ast.Name) and node.value.id in self.aliases:
            self._member(node, self.aliases[node.value.id], node.attr)
        elif node.attr in CHANCE:
            self.note(node, f".{node.attr}")
        self.generic_visit(node)

    def visit_Call(self, node):
        """Calls of builtins, and of methods of sets."""
        name = ast.unparse(node.func)
        if name in {"hash", "id", "pow"}:
            self.note(node, f"{name}()")
        if name == "abs" and self.kind(node.args[0]) not in {"float", "int", "bool"}:
            self.note(node, f"abs() of {self.kind(node.args[0]) or 'what may be complex'}")
        if name == "sum" and items(self.scope, node.args) not in {"int", "bool"}:
            self.note(node, f"sum() of {items(self.scope, node.args) or 'what may be floats'}")
        if name.rpartition(".")[2] == "Random" and not node.args:
            self.note(node, "Random() without a seed")
        if name in ORDERLESS:
            self.harmless.update([id(part) for part in node.args])
        elif name in {"enumerate", "iter", "list", "map", "next", "reversed", "tuple", "zip"}:
            for part in node.args:
                self._iterated(part)
        if isinstance(node.func, ast.Attribute) and node.func.attr == "pop" and self._is_set(node.func.value):
            self.note(node, "pop() of a set")
        self.generic_visit(node)

    def visit_BinOp(self, node):
        """Products, quotients, powers."""
        self._operation(node, node.left, node.op, node.right)
        self.generic_visit(node)

    def visit_AugAssign(self, node):
        """And those in place."""
        self._operation(node, node.target, node.op, node.value)
        self.generic_visit(node)

    def _operation(self, node, left, op, right):
        if isinstance(op, ast.Pow) and not (_is_literal(left) and _is_literal(right)):
            self.note(node, "**")
        if not isinstance(op, ast.Mult | ast.Div):
            return
        kinds = [self.kind(left), self.kind(right)]
        if None in kinds:
            self.note(node, f"* or / of what may be complex: {ast.unparse(node)}")
        elif kinds[1] == "complex" and (kinds[0] == "complex" or isinstance(op, ast.Div)):
            self.note(node, "* or / of two complex numbers")

    def visit_For(self, node):
        """Loops over sets."""
        self._iterated(node.iter)
        self.generic_visit(node)

    def _comprehension(self, node):
        if id(node) not in self.harmless:
            for part in node.generators:
                self._iterated(part.iter)
        self.generic_visit(node)

    def visit_ListComp(self, node):
        """Keeps the order."""
        self._comprehension(node)

    def visit_GeneratorExp(self, node):
        """Keeps the order."""
        self._comprehension(node)

    def visit_DictComp(self, node):
        """Keeps the order."""
        self._comprehension(node)

    def visit_Starred(self, node):
        """`[*set]`."""
        self._iterated(node.value)
        self.generic_visit(node)

    def _iterated(self, node):
        if self._is_set(node):
            self.note(node, "iteration over a set")

    def _is_set(self, node):
        kind = self.kind(node)
        return kind is not None and arguments_of(kind)[0] in {"set", "frozenset", "Set", "AbstractSet"}


def _is_literal(node):
    """A number as it stands, with or without a sign: the compiler computes its powers."""
    return isinstance(node.operand if isinstance(node, ast.UnaryOp) else node, ast.Constant)
