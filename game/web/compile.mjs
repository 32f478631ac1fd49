// Compiles Python for the page, by the very CPython that will run it: node compile.mjs RUNTIME-FOLDER SOURCES.zip OUT.zip
// Every .py of the one archive is a .pyc of the other, without docstrings, assertions and columns in tracebacks; other files are
// as they were.

import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [folder, sources, out] = process.argv.slice(2);
const { loadPyodide } = await import(pathToFileURL(`${folder}/pyodide.mjs`).href);
const python = await loadPyodide({ indexURL: `${folder}/`, env: { PYTHONHASHSEED: "0", PYTHONNODEBUGRANGES: "1" } });
python.FS.writeFile("/sources.zip", new Uint8Array(readFileSync(sources)));
python.runPython(`
import importlib.util, marshal, zipfile
EPOCH = (1980, 1, 1, 0, 0, 0)
UNCHECKED = (1).to_bytes(4, "little") + bytes(8)  # a .pyc that no source is looked for
with zipfile.ZipFile("/sources.zip") as sources, zipfile.ZipFile("/out.zip", "w", zipfile.ZIP_DEFLATED) as out:
    for name in sources.namelist():
        data = sources.read(name)
        if name.endswith(".py"):
            code = compile(data, name, "exec", dont_inherit=True, optimize=2)
            name, data = name + "c", importlib.util.MAGIC_NUMBER + UNCHECKED + marshal.dumps(code)
        out.writestr(zipfile.ZipInfo(name, EPOCH), data)
`);
writeFileSync(out, python.FS.readFile("/out.zip"));
