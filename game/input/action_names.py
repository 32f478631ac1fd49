"""What actions are called, for those who choose keys for them."""

from game.input.actions import Action
from game.language import tr


def action_names() -> dict[Action, str]:
    """What every action is called."""
    return {action: name for _, actions in action_groups() for action, name in actions.items()}


def action_groups() -> tuple[tuple[str, dict[Action, str]], ...]:
    """Actions by what they are for, with their names."""
    return (
        (
            tr("Playing and choosing"),
            {
                Action.LEFT: tr("Left, clockwise"),
                Action.RIGHT: tr("Right, counter-clockwise"),
                Action.UP: tr("Up"),
                Action.DOWN: tr("Down"),
                Action.SERVE: tr("Serve, go on"),
                Action.CONFIRM: tr("Confirm"),
                Action.BACK: tr("Back"),
                Action.PAUSE: tr("Pause"),
                Action.RESTART: tr("Restart"),
                Action.GIVE_UP: tr("Give up a ball"),
                Action.HELP: tr("Help"),
                Action.SETTINGS: tr("Settings"),
            },
        ),
        (
            tr("Picture and sound"),
            {
                Action.TIP: tr("Tip the camera"),
                Action.FLAT: tr("From above"),
                Action.SOLID: tr("In 3D"),
                Action.ORBIT_LEFT: tr("In 3D: camera left"),
                Action.ORBIT_RIGHT: tr("In 3D: camera right"),
                Action.TILT_UP: tr("In 3D: camera up"),
                Action.TILT_DOWN: tr("In 3D: camera down"),
                Action.ZOOM_IN: tr("In 3D: nearer"),
                Action.ZOOM_OUT: tr("In 3D: farther"),
                Action.FULL_SCREEN: tr("Full screen"),
                Action.THEME: tr("Next colours"),
                Action.EFFECTS: tr("Effects on or off"),
                Action.MUTE: tr("Sound on or off"),
                Action.MORE: tr("Louder, faster replay"),
                Action.LESS: tr("Quieter, slower replay"),
            },
        ),
        (
            tr("Replays and lab"),
            {
                Action.STEP: tr("A tick forward"),
                Action.STEP_BACK: tr("A tick back"),
                Action.START: tr("To the beginning"),
                Action.END: tr("To the end"),
                Action.NORMALS: tr("Contact normals"),
                Action.LAB: tr("The lab"),
            },
        ),
    )
