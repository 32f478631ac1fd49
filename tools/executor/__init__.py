"""Work shared by processes here or by a cluster: `results(function, jobs, where)`, in the order of the jobs."""

from tools.executor.lost import Lost
from tools.executor.results import Where, results, sure

__all__ = ["Lost", "Where", "results", "sure"]
"""What the tools that share their work import."""
