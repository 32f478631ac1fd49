"""What a cross-check found, in words."""

from tools.crosscheck.results.measurements import ContactVerdict


def what(rows, comparison=None):
    """The words for the unexplained measurements, of one comparison or of all."""
    found = [one.compared for one in rows.measurements if one.compared.verdict == ContactVerdict.UNEXPLAINED]
    return {compared.what for compared in found if comparison in {None, compared.comparison}}
