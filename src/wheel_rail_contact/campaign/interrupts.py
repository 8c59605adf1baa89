# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C that is not lost."""
import signal


class Interrupts:
    """Within it, the first SIGINT is noted, to be raised where raise_noted is called: Python drops a KeyboardInterrupt
    that strikes in a destructor or a callback of the libraries in use, and the work would go on to its end. Each later
    one is raised at once, for the user of a call that never returns. A SIGINT that is ignored or handled by others stays
    so. For the main thread only."""

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
        """Raises KeyboardInterrupt if there was a SIGINT."""
        if self._noted:
            raise KeyboardInterrupt
