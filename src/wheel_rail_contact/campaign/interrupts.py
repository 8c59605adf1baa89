# SPDX-License-Identifier: BSD-3-Clause
"""Reliable handling of Ctrl-C."""
import signal


class Interrupts:
    """Context in which the first SIGINT is noted, and raised as KeyboardInterrupt by raise_noted().

    Python drops a KeyboardInterrupt that is raised in a destructor or in a callback of a library. The work would then
    continue to its end. Each later SIGINT is raised immediately, in case a call never returns. If SIGINT is ignored, or
    handled elsewhere, this is not changed. Only for the main thread.
    """

    def __enter__(self):
        self._noted = False
        self._ours = signal.getsignal(signal.SIGINT) is signal.default_int_handler
        if self._ours:
            signal.signal(signal.SIGINT, self._note)
        return self

    def __exit__(self, *_):
        if self._ours:
            signal.signal(signal.SIGINT, signal.default_int_handler)

    def _note(self, *_):
        if self._noted:
            raise KeyboardInterrupt
        self._noted = True

    def raise_noted(self):
        """Raises KeyboardInterrupt if a SIGINT was noted."""
        if self._noted:
            raise KeyboardInterrupt
