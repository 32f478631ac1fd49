"""Line protocol of `python -m tools.grade --command "python adapter.py"`, for the functions in student.py beside it.

`python -m tools.grade student.py` does the same without an adapter; this one shows the protocol, and imports nothing of ours.
Points are complex numbers; no contact is None. What student.py does not define is not graded.
"""

import json
import sys

answers, sys.stdout = sys.stdout, sys.stderr  # what the student's code prints is no answer
import student

ARGUMENTS = {
    "to_polar": lambda a: [complex(*a)],
    "closest_point_on_line": lambda a: [complex(*a[:2]), complex(*a[2:4]), complex(*a[4:])],
    "broad_phase_outcome": lambda a: [complex(*a[:2]), *a[2:]],
    "broad_phase": lambda a: [complex(*a[:2]), a[2], a[3], list(zip(a[6::2], a[7::2], strict=True)), a[4], a[5]],
    "narrow_phase_case_1": lambda a: [complex(*a[:2]), a[2]],
    "narrow_phase_case_2": lambda a: [complex(*a[:2]), *a[2:]],
    "collision_response": lambda a: [complex(*a[:2]), complex(*a[2:4]), complex(*a[4:6]), *a[6:]],
}
"""How the flat list of numbers becomes the arguments of each function; where it is not here, every number is one."""


def answer(name, numbers):
    """The answer to one question."""
    function = getattr(student, name, None)
    if function is None:
        return {"undefined": True}
    try:
        result = function(*ARGUMENTS.get(name, list)(numbers))
    except Exception as error:
        return {"error": f"{type(error).__name__}: {error}"}
    return {"result": [result.real, result.imag] if isinstance(result, complex) else result}


for line in sys.stdin:
    question = json.loads(line)
    print(json.dumps(answer(question["function"], question["arguments"])), file=answers, flush=True)
