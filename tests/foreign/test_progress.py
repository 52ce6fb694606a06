"""What a person at a terminal sees while quads are made circular, and a program that reads through a pipe does not."""

import fcntl
import json
import math
import os
import pty
import re
import struct
import subprocess
import termios

import numpy as np
import pytest

from conftest import program_path

STEP = re.compile(rb"0/1 \S+ net: cyclidic-net, circular quads: step (\d+), residual (\S+)")


@pytest.fixture(scope="module")
def command(tmp_path_factory):
    """A run that makes quads circular for seconds, where the bar waits less than half a second before it appears."""
    x = np.linspace(-1, 1, 61)
    grid = [[[s, t, 0.5 * math.exp(-2 * (s * s + t * t))] for s in x] for t in x]
    document = tmp_path_factory.mktemp("progress") / "net.json"
    net = {"type": "cyclidic-net", "grid": grid, "make_circular": {"allow_shape_change": True}}
    document.write_text(json.dumps({"cyclide": 1, "objects": {"net": net}}))
    return [program_path(), "report", document]


def at_terminal(command):
    """What a program draws on a terminal of 120 columns that is its standard error."""
    screen, stderr = pty.openpty()
    fcntl.ioctl(stderr, termios.TIOCSWINSZ, struct.pack("HHHH", 30, 120, 0, 0))
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=stderr) as running:
        os.close(stderr)
        drawn = b""
        try:
            while piece := os.read(screen, 65536):
                drawn += piece
        except OSError:  # the other end is closed
            pass
        os.close(screen)
    assert running.returncode == 0
    return drawn


def test_a_terminal_shows_steps_and_residuals(command):
    drawn = at_terminal(command)
    steps, residuals = zip(*((int(step), float(residual)) for step, residual in STEP.findall(drawn)))
    assert len(set(steps)) >= 3 and list(steps) == sorted(steps)
    assert residuals[-1] < 1e-3 * residuals[0], "it converges while one looks on"
    assert drawn.endswith(b"\x1b[2K"), "the bar is wiped away"


def test_a_pipe_gets_no_bar(command):
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=True)
    assert b"\x1b" not in done.stderr and b"step" not in done.stderr
    assert all(line.startswith(b"warning: ") for line in done.stderr.splitlines())
