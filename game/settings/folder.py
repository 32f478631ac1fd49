"""Where the settings are on this system."""

from pathlib import Path

import platformdirs


def settings_path() -> Path:
    """Where the settings are kept."""
    return platformdirs.user_config_path("polar-breakout", appauthor=False) / "settings.json"
