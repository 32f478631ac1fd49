// Compiles Python for the page, by the very CPython that will run it: node compile.mjs RUNTIME-FOLDER SOURCES.zip OUT.zip
// Every .py of the one archive is a .pyc of the other, without docstrings, assertions and columns in tracebacks; other files are
// as they were. The project's own modules are also without the annotations that nothing reads: those of functions and modules.

import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [folder, sources, out] = process.argv.slice(2);
const { loadPyodide } = await import(pathToFileURL(`${folder}/pyodide.mjs`).href);
const python = await loadPyodide({ indexURL: `${folder}/`, env: { PYTHONHASHSEED: "0", PYTHONNODEBUGRANGES: "1" } });
python.FS.writeFile("/sources.zip", new Uint8Array(readFileSync(sources)));
python.runPython(`
import ast, importlib.util, marshal, zipfile
EPOCH = (1980, 1, 1, 0, 0, 0)
UNCHECKED = (1).to_bytes(4, "little") + bytes(8)  # a .pyc that no source is looked for
OWN = ("game/", "physics/", "tools/")

class Unannotated(ast.NodeTransformer):
    def visit_FunctionDef(self, node):
        node.returns = None
        return self.generic_visit(node)

    def visit_arg(self, node):
        node.annotation = None
        return node

    def visit_ClassDef(self, node):
        node.body = [line if isinstance(line, ast.AnnAssign) else self.visit(line) for line in node.body]
        return node

    def visit_AnnAssign(self, node):
        if node.value is None:
            return ast.copy_location(ast.Pass(), node)
        return ast.copy_location(ast.Assign([node.target], node.value), node)

with zipfile.ZipFile("/sources.zip") as sources, zipfile.ZipFile("/out.zip", "w", zipfile.ZIP_DEFLATED) as out:
    for name in sources.namelist():
        data = sources.read(name)
        if name.endswith(".py"):
            tree = ast.parse(data, name)
            tree = Unannotated().visit(tree) if name.startswith(OWN) else tree
            code = compile(tree, name, "exec", dont_inherit=True, optimize=2)
            name, data = name + "c", importlib.util.MAGIC_NUMBER + UNCHECKED + marshal.dumps(code)
        out.writestr(zipfile.ZipInfo(name, EPOCH), data)
`);
writeFileSync(out, python.FS.readFile("/out.zip"));
