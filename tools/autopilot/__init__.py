"""The autopilot of the source's rules for the games of a batch: needs the extra [batch].

`batch.step(ticks=240, autopilot=BatchAutopilot(level, len(batch)))` plays with it.
"""

from tools.autopilot.batch_autopilot import BatchAutopilot

__all__ = ["BatchAutopilot"]
