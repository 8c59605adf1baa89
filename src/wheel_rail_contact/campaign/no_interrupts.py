# SPDX-License-Identifier: BSD-3-Clause
"""Preloaded by the workers of a local cluster. They ignore Ctrl-C, because the campaign handles it and ends them."""
import signal

signal.signal(signal.SIGINT, signal.SIG_IGN)
