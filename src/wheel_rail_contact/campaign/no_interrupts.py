# SPDX-License-Identifier: BSD-3-Clause
"""Loaded by the workers of a cluster of one's own: Ctrl-C in their terminal is for the campaign, which ends them."""
import signal

signal.signal(signal.SIGINT, signal.SIG_IGN)
