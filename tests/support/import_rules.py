"""Who may import whom, read from the source without running it.

physics   a few modules of the standard library, and itself; physics/batch.py alone numpy and numba, and nobody in
physics imports batch
game      physics, but not its batch; never tools, tests, numba, pymunk
game's rules, levels, replays, autopilot and what plays without a window: pygame neither directly nor through others;
game/__main__.py and game/commands.py not before they know that a window is wanted
game/lab  as the game; all but its window: no pygame, neither directly nor through others; its registry imports every scene
tools     physics, game's part without pygame; what draws or times pictures: all of the game
tools is imported by nothing but itself and tests, but for game/commands.py, which hands the game a second opinion on
contacts and the lab a second engine; tests by nothing
"""

import ast
from typing import NamedTuple

PACKAGES = ("game", "physics", "tools", "tests")
PURE_STDLIB = {"__future__", "collections", "dataclasses", "enum", "functools", "itertools", "math", "typing"}
WITHOUT_WINDOW = {"rules", "levels", "replays", "autopilot", "headless", "system.errors", "system.files"}
DRAWING_TOOLS = {"tools.measure.frame", "tools.measure.memory", "tools.measure.tipping_gif"}
UNKNOWN = "a name made at run time"
REGISTRY, SCENES, LAB_WINDOW = "game.lab.registry", "game.lab.scenes", "game.lab.window"
SECOND_OPINIONS = ("tools.crosscheck.overlay", "tools.crosscheck.second_engine")


class Import(NamedTuple):
    """One import as it is written."""

    module: str  # who imports
    target: str  # what, as a dotted name
    line: int
    deferred: bool  # inside a function: not when the module is imported


def modules(root):
    """Every module of the packages that exist, by dotted name."""
    found = {}
    for package in PACKAGES:
        for path in sorted((root / package).rglob("*.py")):
            parts = path.relative_to(root).with_suffix("").parts
            found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imports_of(module, path):
    """Every import of a module: plain, from, relative, inside functions, and by a call."""
    tree = ast.parse(path.read_text(encoding="utf-8"), str(path))
    package = module if path.name == "__init__.py" else module.rpartition(".")[0]
    found = []

    def walk(node, *, deferred):
        found.extend([Import(module, target, node.lineno, deferred) for target in _targets(node, package)])
        inside = deferred or isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)
        for child in ast.iter_child_nodes(node):
            walk(child, deferred=inside)

    walk(tree, deferred=False)
    return found


def _targets(node, package):
    """The dotted names that one node imports: `from a import b` may mean the module a.b."""
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    if isinstance(node, ast.ImportFrom):
        base = node.module or ""
        if node.level:
            parts = package.split(".")
            base = ".".join([*parts[: len(parts) - node.level + 1], *([base] if base else [])])
        return [base, *[f"{base}.{alias.name}" for alias in node.names]]
    if isinstance(node, ast.Call) and ast.unparse(node.func) in {"__import__", "import_module", "importlib.import_module"}:
        name = node.args[0] if node.args else None
        return [name.value if isinstance(name, ast.Constant) and isinstance(name.value, str) else UNKNOWN]
    return []


class Graph:
    """All imports of a tree."""

    def __init__(self, root):
        """Read every module."""
        self.paths = modules(root)
        self.imports = {module: imports_of(module, path) for module, path in self.paths.items()}
        if REGISTRY in self.imports:
            self.imports[REGISTRY] = self._with_scenes(self.imports[REGISTRY])

    def _with_scenes(self, imports):
        """The registry's imports: what it makes a name for at run time is every scene."""
        scenes = [module for module in self.paths if module.startswith(f"{SCENES}.")]
        return [
            one._replace(target=target) for one in imports for target in (scenes if one.target == UNKNOWN else [one.target])
        ]

    def chain_to(self, top, start, *, deferred):
        """The shortest way, as names, on which importing a module imports a top-level package; None if there is none."""
        chains = [[start]]
        seen = {start}
        for chain in chains:
            for found in self.imports[chain[-1]]:
                if found.deferred and not deferred:
                    continue
                if _top(found.target) == top:
                    return [*chain, found.target]
                for name in self._executed(found.target):
                    if name not in seen:
                        seen.add(name)
                        chains.append([*chain, name])
        return None

    def _executed(self, target):
        """The modules of the tree that an import of this name executes: it and every package around it."""
        parts = target.split(".")
        names = [".".join(parts[: k + 1]) for k in range(len(parts))]
        return [name for name in names if name in self.paths]


def violations(root):
    """Every import that breaks a rule, as `path:line: who imports what, and the rule`."""
    graph = Graph(root)
    found = []
    for module, imports in graph.imports.items():
        where = graph.paths[module].relative_to(root).as_posix()
        for one in imports:
            rule = _broken_rule(module, one.target)
            if rule:
                found.append(f"{where}:{one.line}: {module} imports {one.target}: {rule}")
        without = _without_pygame(module)
        chain = graph.chain_to("pygame", module, deferred=without == "ever") if without else None
        if chain:
            found.append(f"{where}:1: {' -> '.join(chain)}: no pygame here")
    return sorted(set(found))


def _top(name):
    """The top-level package of a dotted name."""
    return name.partition(".")[0]


def _broken_rule(module, target):
    """The rule that one import breaks, or None."""
    return next((rule for breaks, rule in RULES if _top(module) != "tests" and breaks(module, target)), None)


def _is_batch(name):
    """Whether a name is the compiled batch or something in it."""
    return name == "physics.batch" or name.startswith("physics.batch.")


def _is_second_opinion(module, target):
    """Whether this is the one place where the game is given a tool."""
    return module == "game.commands" and target.startswith(SECOND_OPINIONS)


def _foreign_to_physics(module, target):
    """Whether physics may not know a module."""
    extra = {"numpy", "numba"} if module == "physics.batch" else set()
    return _top(module) == "physics" and _top(target) not in {"physics", *PURE_STDLIB, *extra}


RULES = [
    (lambda _, target: target == UNKNOWN, "an import must be readable"),
    (lambda _, target: _top(target) == "tests", "nothing imports the tests"),
    (
        lambda module, target: _top(target) == "tools" != _top(module) and not _is_second_opinion(module, target),
        "nothing imports tools but tests",
    ),
    (_foreign_to_physics, "physics imports a little of the standard library, and itself"),
    (
        lambda module, target: _top(module) == "physics" and _is_batch(target) and not _is_batch(module),
        "physics does not need its batch",
    ),
    (lambda module, target: _top(module) == "game" and _top(target) == "pymunk", "the game does not need pymunk"),
    (
        lambda module, target: _top(module) == "game" and (_top(target) == "numba" or _is_batch(target)),
        "the game does not need numba",
    ),
]


def _is_without_window(name):
    """Whether a module of the game, or the folder it is in, must do without pygame."""
    return any(name == part or name.startswith(f"{part}.") for part in WITHOUT_WINDOW)


def _without_pygame(module):
    """Whether a module must do without pygame: "ever", "on import", or None."""
    parts = module.split(".")
    if module in DRAWING_TOOLS:
        return None
    if parts[0] == "tools" or (parts[0] == "game" and _is_without_window(".".join(parts[1:]))):
        return "ever"
    if module.startswith("game.lab"):
        return None if module.startswith(LAB_WINDOW) else "on import" if module == "game.lab.command" else "ever"
    return "on import" if module in {"game", "game.__main__", "game.commands"} else None
