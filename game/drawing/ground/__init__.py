"""The ground painted pixel by pixel, as any camera sees it."""
