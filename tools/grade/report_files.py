"""The grade as JSON, and as JUnit XML."""

import json
import math
from xml.etree import ElementTree as ET

from game.student.signatures import SIGNATURES
from tools.grade.findings import FunctionFindings
from tools.grade.grading import FunctionGrade, Grade
from tools.grade.report import answer_text, call_text, floored, result_text, verdict
from tools.vectors.files import FORMAT as VECTORS

FORMAT = "polar-breakout grade 1"


def json_text(grade: Grade, findings: dict[str, FunctionFindings]) -> str:
    """Everything that the report says, as numbers and text."""
    record = {
        "format": FORMAT,
        "vectors": VECTORS,
        "seed": grade.seed,
        "title": grade.title,
        "verdict": verdict(grade),
        "right": grade.right,
        "score": math.floor(grade.score * 1e6 + 1e-3) / 1e6,
        "functions": [_record(found, findings[found.name]) for found in grade.functions],
    }
    return json.dumps(record, indent=1) + "\n"


def _record(found: FunctionGrade, findings: FunctionFindings) -> dict[str, object]:
    """A function."""
    record: dict[str, object] = {
        "function": found.name,
        "slide": SIGNATURES[found.name].slide,
        "defined": found.defined,
        "weight": found.weight,
        "passed": len([checked for checked in found.counted if checked.right]),
        "counted": len(found.counted),
        "score": found.score,
        "traps": {trap: {"passed": right, "counted": count} for trap, (right, count) in found.traps.items()},
        "mistakes": [{"name": mistake.name, "hint": mistake.hint} for mistake in findings.mistakes],
        "beyond": {topic: {"source": own, "beyond": beyond} for topic, (own, beyond) in found.topics.items()},
    }
    smallest = findings.simplest
    if smallest is not None:
        record["simplest"] = {
            "id": smallest.vector.name,
            "trap": smallest.vector.trap,
            "call": call_text(smallest.vector),
            "arguments": list(smallest.vector.arguments),
            "expected": smallest.vector.expected,
            "got": answer_text(smallest),
            "lab": findings.lab_line,
        }
    return record


def junit_text(grade: Grade, findings: dict[str, FunctionFindings]) -> str:
    """A test suite for each function, a test case for each of its traps."""
    suites = ET.Element("testsuites", name=grade.title or "polar breakout")
    for found in grade.graded:
        traps = found.traps or {"defined": (0, 1)}
        failures = len([1 for right, count in traps.values() if right < count])
        suite = ET.SubElement(suites, "testsuite", name=found.name, tests=str(len(traps)), failures=str(failures), errors="0")
        for trap, (right, count) in traps.items():
            case = ET.SubElement(suite, "testcase", classname=f"slide {SIGNATURES[found.name].slide}.{found.name}", name=trap)
            if right < count:
                message = f"{count - right} of {count} wrong" if found.defined else "not defined"
                failure = ET.SubElement(case, "failure", message=message)
                failure.text = _failure_text(found, findings[found.name], trap)
    ET.indent(suites)
    return f"<?xml version='1.0' encoding='utf-8'?>\n{ET.tostring(suites, encoding='unicode')}\n"


def _failure_text(found: FunctionGrade, findings: FunctionFindings, trap: str) -> str:
    """The simplest wrong answer of a trap, and the mistakes of the function."""
    lines = [f"score {floored(100.0 * found.score)} %"]
    smallest = next((checked for checked in found.wrong if checked.vector.trap == trap), None)
    if smallest is not None:
        lines += [
            f"{call_text(smallest.vector)}: expected {result_text(smallest.vector.expected)}, got {answer_text(smallest)}"
        ]
    return "\n".join([*lines, *[f"{mistake.name}: {mistake.hint}" for mistake in findings.mistakes]])
