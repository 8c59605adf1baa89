# SPDX-License-Identifier: BSD-3-Clause
"""Progress on standard error: a bar on a terminal, otherwise lines."""
import contextlib
import sys
import time

WIDTH = 30
STEP = 5000  # items between two calls
PERIOD = 5   # between the lines of counted() without a terminal [s]


def no_progress(done, total, title):
    """Shows nothing."""


def shown(items, total, progress, noun):
    """Yields the items of a long input, and calls a Progress now and then."""
    for done, item in enumerate(items):
        if done and done % STEP == 0:
            progress(done, max(total, done), f"{noun} {done} of {total}")
        yield item


@contextlib.contextmanager
def counted(progress, noun):
    """Gives a function of the numbers of items done and of all: `progress`, or for True one that shows them; None for False."""
    if progress is True:
        shows = Progress(period=PERIOD)
        try:
            yield lambda done, total: shows(done, max(total, 1), f"{done} of {total} {noun}")
        finally:
            shows.end()
    elif progress in (False, None) or callable(progress):
        yield progress if callable(progress) else None
    else:
        raise TypeError(f"progress = {progress!r}: must be True, False or a function")


class Progress:
    """Shows the progress of a task that consists of steps.

    Each call gives the number of steps done, the total number of steps, and a title. Without a terminal, a line is printed
    when the title changes, at most one per `period` [s].
    """

    def __init__(self, stream=None, period=0):
        self._stream = stream or sys.stderr
        self._started = self._reported = time.monotonic()
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
        elif title == self._title or now - self._reported < self._period:
            return
        else:
            print(f"[{seconds:5.0f} s] {100 * done // total:3d} %  {title}", file=self._stream, flush=True)
        self._title, self._reported = title, now

    def end(self):
        """Ends the line of the bar."""
        if self._bar and self._title is not None:
            print(file=self._stream, flush=True)
