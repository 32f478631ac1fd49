"""Where the physics goes beyond the source: the rows of the documentation's table, each in a few words."""

DIFFERENCES = {
    1: "angles are in [0, 2π), also for -1e-17",
    2: "the sector's middle picks the end, not on_left(θ, θ_p + φ_p)",
    3: "the segment, not the line: the clamp makes the corners",
    4: "|v_res| = 0 is possible, and answered",
    5: "the surface's own velocity ω × q; a slow ball is carried",
    6: "the exact time of impact, not one test a frame",
    7: "a centre inside the material leaves by the shortest way",
    8: "two sectors at once, in the order of time",
    9: "leaving the ground costs one life, once",
    10: "friction is the source's; endless loops are nudged",
    11: "case 2 touches at a distance in [0, r): at 0 the normal is the end's own",
    12: "v and n lie in the ground, which is two-dimensional",
}


def differences_line(rows: tuple[int, ...]) -> str:
    """Some rows as one line of text; empty for none."""
    return f"Beyond the source:  {';  '.join([f'{row}  {DIFFERENCES[row]}' for row in rows])}" if rows else ""
