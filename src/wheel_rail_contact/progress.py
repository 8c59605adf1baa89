# SPDX-License-Identifier: BSD-3-Clause
"""Progress on standard error: a bar on a terminal, lines elsewhere."""
import sys
import time

WIDTH = 30


class Progress:
    """Called with (steps done, steps in all, what is at work). Lines come when that changes, at most one a period [s]."""

    def __init__(self, stream=None, period=0):
        self._stream = stream or sys.stderr
        self._started = self._told = time.monotonic()
        self._period = period
        self._bar = self._stream.isatty()
        self._title = None

    def __call__(self, done, total, title):
        now = time.monotonic()
        seconds = now - self._started
        if self._bar:
            full = WIDTH * done // total
            bar = "#" * full + "." * (WIDTH - full)
            print(f"\r[{bar}] {100 * done // total:3d} %  {seconds:4.0f} s  {title:<45.45}", end="", file=self._stream,
                  flush=True)
        elif title == self._title or now - self._told < self._period:
            return
        else:
            print(f"[{seconds:5.0f} s] {100 * done // total:3d} %  {title}", file=self._stream, flush=True)
        self._title, self._told = title, now

    def end(self):
        """Leaves the bar's line."""
        if self._bar and self._title is not None:
            print(file=self._stream, flush=True)
