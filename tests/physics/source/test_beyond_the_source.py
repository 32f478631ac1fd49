"""Where the source needs more: one chapter for each row of the design's table, each showing both answers.

`source_oracle` is what the source says, `physics` is what this game does.
"""

import math

import msgspec
import pytest

from game.levels import classic
from game.rules import TICK as GAME_TICK
from game.rules import Controls, Phase, new_game, tick
from physics import (
    PERMANENT,
    Arena,
    Ball,
    Feature,
    Ring,
    advance,
    angle_of,
    broad_phase,
    collision_response,
    contact,
    cross,
    dot,
    length,
    narrow_phase_case_2,
    normalize_angle,
    time_of_impact,
    to_cartesian,
)
from tests.support.oracles import source_oracle

TICK = 1.0 / 240.0


def source_normal(ball, ring):
    """The source's normal, or None, for a ball and a ring."""
    theta = source_oracle.to_polar(ball.position)[1]
    positions = [(ring.radius, ring.angle(slot)) for slot in range(ring.count)]
    return source_oracle.broad_phase(ball.position, ball.radius, theta, positions, ring.half_width, ring.half_angle)


def arena(ball, ring, layers=PERMANENT):
    """A single ball and a single ring."""
    return Arena((ball,), (ring,), ((layers,) * ring.count,))


class TestRow1:
    """Angles in (0, 2 pi): here in [0, 2 pi), also for -1e-17 and after 1e8 ticks."""

    def test_a_hair_below_the_polar_axis(self):
        """The source's normalisation leaves its own range."""
        assert source_oracle.normalize_angle(-1e-17) == math.tau
        assert normalize_angle(-1e-17) == 0.0

    def test_the_polar_axis_itself_is_an_angle(self):
        """0 is outside of (0, 2 pi), and a ball on the positive x axis has no other."""
        assert angle_of(3 + 0j) == 0.0
        ring = Ring(10.0, 0.5, 0.2, 3)
        assert contact(Ball(9 + 0j, 0j, 0.5), ring, 0).normal == -1.0

    def test_a_paddle_after_a_hundred_million_ticks(self):
        """Turned in one go through 1e8 ticks, or by a tick at 1e8 times the spin, the phase is in the range."""
        ring = Ring(10.0, 0.5, 0.2, 3, phase=1.0, spin=1.7).turned(1e8 * TICK)
        assert 0.0 <= ring.phase < math.tau
        assert abs(ring.phase - normalize_angle(1.0 + 1.7 * 1e8 * TICK)) < 1e-15


class TestRow2:
    """The end is found by on_left(theta, theta_p + phi_p): here by the sector's middle."""

    # A sector of 2 x 165 degrees leaves a gap of 30 around pi; a ball in it, nearer to the clockwise end.
    half_angle = math.radians(165.0)
    theta = math.radians(185.0)

    def test_a_wide_sector_has_its_end_on_the_other_side(self):
        """The ball touches the clockwise end at 195 degrees; the source looks at the other, at 165, and sees nothing."""
        p = to_cartesian(10.0, self.theta)
        arguments = p, 1.8, self.theta, 10.0, 0.0, 1.0, self.half_angle
        assert source_oracle.on_left(self.theta, self.half_angle)
        found, expected = narrow_phase_case_2(*arguments), source_oracle.narrow_phase_case_2(*arguments)
        assert expected is None
        assert abs(found - to_cartesian(1.0, math.radians(195.0 - 90.0))) < 1e-14

    def test_the_source_bounces_the_ball_into_the_end_that_it_touches(self):
        """Large enough to reach both ends, its normal is that of the farther one."""
        p = to_cartesian(10.0, self.theta)
        arguments = p, 4.0, self.theta, 10.0, 0.0, 1.0, self.half_angle
        found, expected = narrow_phase_case_2(*arguments), source_oracle.narrow_phase_case_2(*arguments)
        assert cross(p, found) < 0.0 < cross(p, expected)

    @pytest.mark.parametrize("half_angle", [1.0, 1.6, 2.5, 3.0])
    def test_both_sides_of_every_gap_mirror_each_other(self, half_angle):
        """However wide the sector is; the source's answers do so only while theta's offset + phi <= pi."""
        offset = half_angle + 0.1 * (math.pi - half_angle)
        above, below = to_cartesian(10.0, offset), to_cartesian(10.0, -offset)
        rest = 10.0, 0.0, 1.0, half_angle
        pairs = [
            [case_2(p, 5.0, theta % math.tau, *rest) for p, theta in ((above, offset), (below, -offset))]
            for case_2 in (narrow_phase_case_2, source_oracle.narrow_phase_case_2)
        ]
        engine, source = pairs
        assert abs(engine[0] - engine[1].conjugate()) < 1e-14
        mirrored = source[1] is not None and abs(source[0] - source[1].conjugate()) < 1e-14
        assert mirrored == (offset + half_angle < math.pi)


class TestRow3:
    """The closest point on the line AB: here on the segment; the clamp is what makes the corners."""

    ring = Ring(10.0, 1.0, 0.25, 1, phase=-0.25)  # its counter-clockwise end lies on the x axis, from 9 to 11

    def test_a_ball_past_the_corner_is_thrown_off_it_not_off_the_line(self):
        """At 0.6 right of the outer corner and 0.8 above it."""
        ball = Ball(11.6 + 0.8j, 0j, 1.1)
        assert abs(source_normal(ball, self.ring) - 1j) < 1e-12
        found = contact(ball, self.ring, 0)
        assert found.feature is Feature.CORNER
        assert abs(found.normal - (0.6 + 0.8j)) < 1e-12

    def test_the_line_is_no_wall(self):
        """Far out on the line of the end, and deep in the hole, the source sees a contact in thin air."""
        for x in (20.0, 3.0):
            ball = Ball(complex(x, 0.3), 0j, 0.5)
            theta = angle_of(ball.position)
            assert source_normal(ball, self.ring) is not None
            positions = [(10.0, self.ring.angle(0))]
            assert broad_phase(ball.position, ball.radius, theta, positions, 1.0, 0.25) is None
            assert contact(ball, self.ring, 0).gap > 3.0


class TestRow4:
    """NOTE: |v_res| > 0 is not guaranteed: an end that retreats at half the ball's speed stops it dead."""

    def test_the_ball_stopped_dead_leaves_along_the_normal(self):
        """A paddle's end at radius 10 turning at 0.2 rad/s retreats at 2 from a ball of speed 4."""
        ring = Ring(10.0, 1.0, 0.25, 1, phase=-0.25, spin=-0.2)
        ball = Ball(10 + 0.5j, -4j, 0.5)
        found = contact(ball, ring, 0)
        surface = ring.surface_velocity(found.point)
        assert surface == -2j
        with pytest.raises(ZeroDivisionError):
            source_oracle.collision_response(ball.velocity, found.normal, surface, 1.0, 4.0)
        assert collision_response(ball.velocity, found.normal, surface, 1.0, 4.0) == 4j


class TestRow5:
    """A paddle has one velocity v_p: here each point of its surface has its own, and a ball too slow to get away is carried."""

    def test_the_outer_corner_is_faster_than_the_inner(self):
        """The same paddle gives more at the rim; the source gives its middle's velocity to both."""
        ring = Ring(10.0, 5.0, 0.25, 1, phase=-0.25, spin=0.3)
        middle = ring.surface_velocity(to_cartesian(10.0, 0.0))
        for x in (6.0, 14.0):
            ball = Ball(complex(x, 0.5), 3 - 4j, 0.5)
            found = contact(ball, ring, 0)
            assert abs(ring.surface_velocity(found.point) - 0.3j * x) < 1e-14
            here = collision_response(ball.velocity, found.normal, ring.surface_velocity(found.point), 0.0, 5.0)
            source = source_oracle.collision_response(ball.velocity, found.normal, middle, 0.0, 5.0)
            assert (here.imag < source.imag - 0.01) if x < 10.0 else (here.imag > source.imag + 0.01)

    def test_a_face_drags_across_its_radius(self):
        """The velocity of the surface is spin x q, square to the radius of the contact point, not to the paddle's middle."""
        ring = Ring(10.0, 1.0, 1.0, 1, spin=0.5)
        found = contact(Ball(to_cartesian(8.5, 0.9), 0j, 0.5), ring, 0)
        surface = ring.surface_velocity(found.point)
        assert abs(dot(surface, found.normal)) < 1e-14
        assert abs(dot(ring.surface_velocity(to_cartesian(10.0, 0.0)), found.normal)) > 3.0

    def test_a_ball_that_still_approaches_after_the_reset_is_carried(self):
        """v_res has the length 6.4, cut to 5 it falls back behind the end's 4.5: into the material."""
        v, normal, surface = 4 + 3j, 1j, 4.5j
        source = source_oracle.collision_response(v, normal, surface, 0.0, 5.0)
        assert dot(source - surface, normal) < -0.3
        here = collision_response(v, normal, surface, 0.0, 5.0)
        assert abs(dot(here - surface, normal)) < 1e-14
        assert abs(length(here) - 5.0) < 1e-14
        assert here.real > 0.0


class TestRow6:
    """Overlap is tested once a frame: here the time of impact is exact."""

    def test_nothing_tunnels(self):
        """A ball that crosses a thin wall within one frame: no overlap before, none after, an impact in between."""
        ring = Ring(10.0, 0.05, 0.3, 1)
        frame = 1.0 / 60.0
        ball = Ball(9.7 + 0j, 40 + 0j, 0.1)
        for moment in (ball, ball.moved(frame)):
            nearest, farthest = abs(moment.position) - 0.1, abs(moment.position) + 0.1
            assert source_oracle.outcome(moment.position, 0.1, 99.0, 10.0, 0.05, 5.0, 0.1) == "no collision"
            assert farthest < ring.inner_radius or nearest > ring.outer_radius
        impact = time_of_impact(ball, ring, frame)
        assert abs(impact.time - 0.15 / 40.0) < 1e-12
        step = advance(arena(ball, ring), frame, 40.0)
        assert [hit.contact.feature for hit in step.hits] == [Feature.INNER_FACE]
        assert abs(step.arena.balls[0].position) < 9.85 + 1e-12

    def test_nothing_is_passed_by_a_turning_end_either(self):
        """A paddle that sweeps a third of a turn in one frame hits the ball that lay in its way."""
        ring = Ring(10.0, 1.0, 0.1, 1, phase=-1.0, spin=120.0)
        ball = Ball(10 + 0j, 0j, 0.2)
        assert source_normal(ball, ring) is None
        assert source_normal(ball, ring.turned(1.0 / 60.0)) is None
        impact = time_of_impact(ball, ring, 1.0 / 60.0)
        assert impact is not None
        assert abs(impact.contact.gap) < 1e-9

    def test_the_result_does_not_depend_on_the_frame_rate(self):
        """A second of play at 30 frames, and at 240: the same ball. The source's bounces come up to a frame late."""
        ends = []
        for rate in (30, 240):
            now = arena(Ball(1 + 2j, 14 - 9j, 0.25), Ring(10.0, 0.5, math.pi, 1))
            for _ in range(rate):
                now = advance(now, 1.0 / rate, abs(14 - 9j)).arena
            ends.append(now.balls[0])
        assert abs(ends[0].position - ends[1].position) < 1e-11
        assert abs(ends[0].velocity - ends[1].velocity) < 1e-11
        assert abs(self.source_second(30) - self.source_second(240)) > 0.01

    @staticmethod
    def source_second(rate):
        """Where the source's ball is after a second in a closed ring, tested once a frame."""
        p, v = 1 + 2j, 14 - 9j
        for _ in range(rate):
            p += v / rate
            if source_oracle.outcome(p, 0.25, 99.0, 10.0, 0.5, 1.0, 0.1) == "broad phase with paddles":
                v = source_oracle.collision_response(v, source_oracle.narrow_phase_case_1(p, 10.0), 0.0, 0.0, abs(v))
        return p


class TestRow7:
    """Centre within the sector's angle means face: true outside of the material only."""

    ring = Ring(10.0, 2.0, 0.25, 1, phase=-0.25)  # its end is the x axis from 8 to 12
    ball = Ball(10.5 - 0.1j, 0j, 0.3)  # just inside of the end

    def test_a_ball_inside_the_material_near_its_end_leaves_through_the_end(self):
        """The source sends it through the whole half width, 1.5 + 0.3 outwards; the end is 0.1 + 0.3 away."""
        assert abs(source_normal(self.ball, self.ring) - self.ball.position / abs(self.ball.position)) < 1e-15
        found = contact(self.ball, self.ring, 0)
        assert found.feature is Feature.END
        assert abs(found.normal - 1j) < 1e-15
        assert abs(found.gap + 0.4) < 1e-14

    def test_the_next_tick_puts_it_there(self):
        """Out by the least depth, its velocity kept, and counted."""
        step = advance(arena(self.ball, self.ring), TICK, 5.0)
        assert step.freed == 1
        assert step.hits == ()
        assert abs(step.arena.balls[0].position - (10.5 + 0.3j)) < 1e-12

    def test_a_ball_deep_inside_leaves_through_the_nearer_face(self):
        """Where the way through a face is the shortest, the source is right."""
        ball = Ball(to_cartesian(11.5, -0.25), 0j, 0.3)
        found = contact(ball, self.ring, 0)
        assert found.feature is Feature.OUTER_FACE
        assert abs(found.normal - source_normal(ball, self.ring)) < 1e-15
        assert abs(found.gap + 0.8) < 1e-14


class TestRow8:
    """One nearest sector: here a ball between two bricks answers to both, in the order of time."""

    # Two sectors leave a notch of 2 x 0.1 rad around the x axis, narrower than the ball; others are far.
    ring = Ring(10.0, 1.0, math.pi / 4.0 - 0.1, 4, phase=math.pi / 4.0)

    def test_a_ball_in_a_notch_touches_both_bricks(self):
        """It comes in along the axis of the notch, hits both corners and leaves from both; the source sees one."""
        ball = Ball(13 + 0j, -20 + 0j, 2.0)
        step = advance(arena(ball, self.ring, 3), 0.1, 20.0)
        assert {hit.slot for hit in step.hits} == {0, 3}
        assert {hit.contact.feature for hit in step.hits} == {Feature.CORNER}
        times = [hit.time for hit in step.hits]
        assert times == sorted(times)
        after = step.hits[-1].after
        assert all(dot(after, hit.contact.normal) > 0.0 for hit in step.hits)
        assert abs(length(after) - 20.0) < 1e-13

    def test_the_source_answers_one_and_flies_on_into_the_other(self):
        """Its normal is the one brick's; the velocity after still approaches the other brick's corner."""
        ball = Ball(13 + 0j, -20 + 0j, 2.0)
        ball = ball.moved(time_of_impact(ball, self.ring, 0.1).time + 1e-6)
        normal = source_normal(ball, self.ring)
        after = source_oracle.collision_response(ball.velocity, normal, 0.0, 0.0, 20.0)
        assert min(dot(after, contact(ball, self.ring, slot).normal) for slot in (0, 3)) < -1.0

    def test_a_tie_goes_to_the_lower_slot(self):
        """Touched at the very same time, the lower number answers first, and only once the other, if still approached."""
        step = advance(arena(Ball(13 + 0j, -20 + 0j, 2.0), self.ring, 3), 0.1, 20.0)
        assert step.hits[0].time == step.hits[1].time
        assert [hit.slot for hit in step.hits[:2]] == [0, 3]

    def test_the_number_of_contacts_in_a_tick_is_bounded(self):
        """A ball that rattles down a wedge between two ends, and out again, within one long tick: 32 hits at most."""
        speed = abs(-500 + 150j)
        ring = Ring(10.0, 9.0, math.pi / 4.0 - 0.15, 4, phase=math.pi / 4.0)
        step = advance(arena(Ball(17 + 0.1j, -500 + 150j, 0.25), ring), 0.2, speed)
        assert 4 <= len(step.hits) <= 32
        assert {hit.slot for hit in step.hits} == {0, 3}
        assert all(abs(length(hit.after) / speed - 1.0) < 1e-12 for hit in step.hits)


class TestRow9:
    """Game over when |p| - r > r_g: here the same rule costs a life, once for each ball; the game ends with the last."""

    def test_the_source_is_over_where_a_life_is_lost(self):
        """At the very tick at which the source's game is over, this one loses a life and serves again."""
        game = new_game(classic(), 1)
        ball = Ball(9.9 + 0j, complex(game.level.ball.speed, 0.0), game.level.ball.radius)
        game = game._replace(phase=Phase.PLAYING, arena=game.arena._replace(balls=(ball,)))
        lives = [game.lives]
        while game.phase == Phase.PLAYING:
            ball = ball.moved(GAME_TICK)
            game = tick(game, Controls()).game
            lives.append(game.lives)
        radius, ground = ball.radius, game.level.ground_radius
        assert length(ball.position) - radius > ground >= length(ball.moved(-GAME_TICK).position) - radius
        assert lives == [3] * (len(lives) - 1) + [2]
        assert game.phase == Phase.SERVING

    def test_of_two_balls_the_first_to_leave_costs_nothing(self):
        """A life goes with the last ball, not with every one."""
        game = new_game(classic(), 1)
        out = Ball(10.3 + 0j, complex(game.level.ball.speed, 0.0), game.level.ball.radius)
        stays = Ball(7j, complex(game.level.ball.speed, 0.0), game.level.ball.radius)
        game = game._replace(phase=Phase.PLAYING, arena=game.arena._replace(balls=(out, stays)))
        game = tick(game, Controls()).game
        assert (len(game.arena.balls), game.lives, game.phase) == (1, 3, Phase.PLAYING)


class TestRow10:
    """Friction mu_p with min(|dv_n|, |dv_t|): the same; and a ball in a loop that meets no brick is nudged by the seed."""

    def test_the_sources_ball_stays_on_its_line_for_ever_and_ours_leaves_it(self):
        """To and fro through the centre between two paddles: twelve contacts on one line, then another."""
        level = classic()[0]
        paddles = msgspec.structs.replace(level.paddles, count=2, phase=90.0)
        brick = msgspec.structs.replace(level.rings[0], layers=[1] + [0] * 11)
        level = msgspec.structs.replace(level, paddles=paddles, rings=[brick])
        game = new_game((level,), 1)
        ball = Ball(0j, complex(0.0, level.ball.speed), level.ball.radius)
        game = game._replace(phase=Phase.PLAYING, arena=game.arena._replace(balls=(ball,)))
        contacts = 0
        while game.draws == 0:
            done = tick(game, Controls())
            game = done.game
            contacts += len(done.step.hits)
            assert contacts <= 12
            assert game.draws > 0 or abs(game.arena.balls[0].position.real) < 1e-9
        assert contacts == 12
        assert abs(game.arena.balls[0].velocity.real) > level.ball.speed * math.sin(math.radians(4.9))

    @pytest.mark.parametrize("friction", [0.0, 0.25, 0.5, 1.0])
    @pytest.mark.parametrize("v", [3 - 4j, -4 - 3j, -5j])
    def test_friction_is_the_sources(self, friction, v):
        """Slip below the fall, above it, and none."""
        expected = source_oracle.collision_response(v, 1j, 1 + 0j, friction, 5.0)
        assert abs(collision_response(v, 1j, 1 + 0j, friction, 5.0) - expected) < 1e-15


class TestRow11:
    """Case 2 touches at a distance in (0, r): here in [0, r)."""

    def test_a_ball_whose_centre_lies_on_the_end_touches_it(self):
        """The source's quotient has no value there; the end's own normal is the limit from outside."""
        ring = Ring(10.0, 1.0, 0.5, 1)
        theta = math.nextafter(0.5, 1.0)
        end = (0.5, 0.3, ring.radius, 0.0, ring.half_width, ring.half_angle)
        for p in (to_cartesian(9.0, 0.5), to_cartesian(11.0, 0.5)):  # the corners, where the distance is exactly 0
            assert source_oracle.narrow_phase_case_2(p, end[1], theta, *end[2:]) is None
            normal = narrow_phase_case_2(p, end[1], theta, *end[2:])
            assert normal is not None
            assert abs(normal - to_cartesian(1.0, 0.5 + math.pi / 2.0)) < 1e-15


class TestRow12:
    """v = (v_x, 0, v_z), but n = (n_x, n_y, 0): one of the two is a slip."""

    def test_taken_at_their_word_the_two_share_one_axis(self):
        """A ball that flies straight at a face along the second axis would not be seen to approach it."""
        v, n = -5j, 1j  # in the ground's two axes
        assert dot(v, n) < 0.0
        assert collision_response(v, n, 0j, 0.0, 5.0) == 5j
        source_v, source_n = (v.real, 0.0, v.imag), (n.real, n.imag, 0.0)
        assert sum([a * b for a, b in zip(source_v, source_n, strict=True)]) == 0.0
